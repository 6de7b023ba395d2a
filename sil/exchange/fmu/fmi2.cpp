// FMI 2.0: the functions of its co-simulation interface over an Instance, and nothing else.
#include <exception>
#include <memory>
#include <string>

#include "sil/exchange/fmu/fmi2_types.h"
#include "sil/exchange/fmu/instance.hpp"

namespace {

using fmu::Instance;
using fmu::Kind;

constexpr const char* error_category = "logStatusError";

struct Component {
    std::unique_ptr<Instance> instance;
    double start_s{0.0};
};

// Errors stay within: no exception may reach an importer.
template <typename Action>
fmi2Status guarded(fmi2Component component, Action action) {
    if (component == nullptr) {
        return fmi2Error;
    }
    Component& object = *static_cast<Component*>(component);
    try {
        return action(*object.instance) ? fmi2OK : fmi2Error;
    } catch (const std::exception& error) {
        object.instance->refuse(error.what());
        return fmi2Error;
    }
}

fmi2Status refused(fmi2Component component, const char* function) {
    return guarded(component, [function](Instance& object) {
        return object.refuse(std::string{function} +
                             " is not offered by this FMU; modelDescription.xml says what is");
    });
}

// An enumeration is an integer here.
Kind kind_of(const Instance& object, Kind kind, fmi2ValueReference reference) {
    return kind == Kind::integer && object.is_choice(reference) ? Kind::choice : kind;
}

template <typename Number>
fmi2Status get(fmi2Component component, Kind kind, const fmi2ValueReference references[], size_t count,
               Number values[]) {
    return guarded(component, [=](Instance& object) {
        for (size_t index = 0U; index < count; ++index) {
            double value = 0.0;
            if (!object.get(kind_of(object, kind, references[index]), references[index], value)) {
                return false;
            }
            values[index] = static_cast<Number>(value);
        }
        return true;
    });
}

template <typename Number>
fmi2Status set(fmi2Component component, Kind kind, const fmi2ValueReference references[], size_t count,
               const Number values[]) {
    return guarded(component, [=](Instance& object) {
        for (size_t index = 0U; index < count; ++index) {
            if (!object.set(kind_of(object, kind, references[index]), references[index],
                            static_cast<double>(values[index]))) {
                return false;
            }
        }
        return true;
    });
}

// The logger's message is a format.
std::string without_formats(const std::string& sentence) {
    std::string text;
    for (const char letter : sentence) {
        text += letter == '%' ? "%%" : std::string{letter};
    }
    return text;
}

}  // namespace

RSI_FMI2_EXPORT const char* fmi2GetTypesPlatform() {
    return "default";
}

RSI_FMI2_EXPORT const char* fmi2GetVersion() {
    return "2.0";
}

RSI_FMI2_EXPORT fmi2Status fmi2SetDebugLogging(fmi2Component, fmi2Boolean, size_t, const fmi2String[]) {
    return fmi2OK;  // only what is wrong is logged, and that always
}

RSI_FMI2_EXPORT fmi2Component fmi2Instantiate(fmi2String instance_name, fmi2Type type, fmi2String token,
                                              fmi2String, const fmi2CallbackFunctions* functions, fmi2Boolean,
                                              fmi2Boolean) {
    const std::string name = instance_name == nullptr ? "" : instance_name;
    const fmi2CallbackFunctions callbacks =
        functions == nullptr ? fmi2CallbackFunctions{nullptr, nullptr, nullptr, nullptr, nullptr}
                             : *functions;
    const auto log = [name, callbacks](const std::string& sentence) {
        if (callbacks.logger != nullptr) {
            callbacks.logger(callbacks.componentEnvironment, name.c_str(), fmi2Error, error_category,
                             without_formats(sentence).c_str());
        }
    };
    if (type != fmi2CoSimulation) {
        log("this FMU is for co-simulation; instantiate it for that");
        return nullptr;
    }
    try {
        auto instance = Instance::create(name, token, log);
        return instance == nullptr ? nullptr : new Component{std::move(instance)};
    } catch (const std::exception& error) {
        log(error.what());
        return nullptr;
    }
}

RSI_FMI2_EXPORT void fmi2FreeInstance(fmi2Component component) {
    delete static_cast<Component*>(component);
}

RSI_FMI2_EXPORT fmi2Status fmi2SetupExperiment(fmi2Component component, fmi2Boolean, fmi2Real,
                                               fmi2Real start_time, fmi2Boolean, fmi2Real) {
    return guarded(component, [=](Instance&) {
        static_cast<Component*>(component)->start_s = start_time;
        return true;
    });
}

RSI_FMI2_EXPORT fmi2Status fmi2EnterInitializationMode(fmi2Component component) {
    return guarded(component, [=](Instance& object) {
        return object.enter_initialisation(static_cast<Component*>(component)->start_s);
    });
}

RSI_FMI2_EXPORT fmi2Status fmi2ExitInitializationMode(fmi2Component component) {
    return guarded(component, [](Instance& object) { return object.exit_initialisation(); });
}

RSI_FMI2_EXPORT fmi2Status fmi2Terminate(fmi2Component component) {
    return guarded(component, [](Instance& object) { return object.terminate(); });
}

RSI_FMI2_EXPORT fmi2Status fmi2Reset(fmi2Component component) {
    return guarded(component, [](Instance& object) { return object.reset(); });
}

RSI_FMI2_EXPORT fmi2Status fmi2DoStep(fmi2Component component, fmi2Real now, fmi2Real step, fmi2Boolean) {
    return guarded(component, [=](Instance& object) { return object.step(now, step); });
}

#define RSI_GETTER(type, kind)                                                                               \
    RSI_FMI2_EXPORT fmi2Status fmi2Get##type(fmi2Component component, const fmi2ValueReference references[], \
                                             size_t count, fmi2##type values[]) {                            \
        return get(component, kind, references, count, values);                                              \
    }                                                                                                        \
    RSI_FMI2_EXPORT fmi2Status fmi2Set##type(fmi2Component component, const fmi2ValueReference references[], \
                                             size_t count, const fmi2##type values[]) {                      \
        return set(component, kind, references, count, values);                                              \
    }
RSI_GETTER(Real, Kind::number)
RSI_GETTER(Integer, Kind::integer)
RSI_GETTER(Boolean, Kind::boolean)
#undef RSI_GETTER

RSI_FMI2_EXPORT fmi2Status fmi2GetString(fmi2Component component, const fmi2ValueReference references[],
                                         size_t count, fmi2String values[]) {
    return guarded(component, [=](Instance& object) {
        for (size_t index = 0U; index < count; ++index) {
            if (!object.get(references[index], values[index])) {
                return false;
            }
        }
        return true;
    });
}

RSI_FMI2_EXPORT fmi2Status fmi2SetString(fmi2Component component, const fmi2ValueReference references[],
                                         size_t count, const fmi2String values[]) {
    return guarded(component, [=](Instance& object) {
        for (size_t index = 0U; index < count; ++index) {
            if (!object.set(references[index], values[index])) {
                return false;
            }
        }
        return true;
    });
}

RSI_FMI2_EXPORT fmi2Status fmi2GetFMUstate(fmi2Component component, fmi2FMUstate* state) {
    return guarded(component, [=](Instance& object) { return object.save(state); });
}

RSI_FMI2_EXPORT fmi2Status fmi2SetFMUstate(fmi2Component component, fmi2FMUstate state) {
    return guarded(component, [=](Instance& object) { return object.restore(state); });
}

RSI_FMI2_EXPORT fmi2Status fmi2FreeFMUstate(fmi2Component component, fmi2FMUstate* state) {
    return guarded(component, [=](Instance& object) { return object.free_state(state); });
}

RSI_FMI2_EXPORT fmi2Status fmi2SerializedFMUstateSize(fmi2Component component, fmi2FMUstate state,
                                                      size_t* size) {
    return guarded(component, [=](Instance& object) { return object.serialised_size(state, *size); });
}

RSI_FMI2_EXPORT fmi2Status fmi2SerializeFMUstate(fmi2Component component, fmi2FMUstate state,
                                                 fmi2Byte bytes[], size_t size) {
    return guarded(component, [=](Instance& object) {
        return object.serialise(state, reinterpret_cast<unsigned char*>(bytes), size);
    });
}

RSI_FMI2_EXPORT fmi2Status fmi2DeSerializeFMUstate(fmi2Component component, const fmi2Byte bytes[],
                                                   size_t size, fmi2FMUstate* state) {
    return guarded(component, [=](Instance& object) {
        return object.deserialise(reinterpret_cast<const unsigned char*>(bytes), size, state);
    });
}

// Every step ends within its call: nothing is pending.
RSI_FMI2_EXPORT fmi2Status fmi2GetRealStatus(fmi2Component component, const fmi2StatusKind kind,
                                             fmi2Real* value) {
    return guarded(component, [=](Instance& object) {
        if (kind != fmi2LastSuccessfulTime) {
            return object.refuse("fmi2GetRealStatus tells the last successful time only");
        }
        *value = object.time_s();
        return true;
    });
}

// There for importers that look up every function of the interface.
#define RSI_REFUSED(name, parameters)            \
    RSI_FMI2_EXPORT fmi2Status name parameters { \
        return refused(component, #name);        \
    }
RSI_REFUSED(fmi2CancelStep, (fmi2Component component))
RSI_REFUSED(fmi2GetStatus, (fmi2Component component, const fmi2StatusKind, fmi2Status*))
RSI_REFUSED(fmi2GetIntegerStatus, (fmi2Component component, const fmi2StatusKind, fmi2Integer*))
RSI_REFUSED(fmi2GetBooleanStatus, (fmi2Component component, const fmi2StatusKind, fmi2Boolean*))
RSI_REFUSED(fmi2GetStringStatus, (fmi2Component component, const fmi2StatusKind, fmi2String*))
RSI_REFUSED(fmi2SetRealInputDerivatives, (fmi2Component component, const fmi2ValueReference[], size_t,
                                          const fmi2Integer[], const fmi2Real[]))
RSI_REFUSED(fmi2GetRealOutputDerivatives,
            (fmi2Component component, const fmi2ValueReference[], size_t, const fmi2Integer[], fmi2Real[]))
RSI_REFUSED(fmi2GetDirectionalDerivative, (fmi2Component component, const fmi2ValueReference[], size_t,
                                           const fmi2ValueReference[], size_t, const fmi2Real[], fmi2Real[]))
#undef RSI_REFUSED
