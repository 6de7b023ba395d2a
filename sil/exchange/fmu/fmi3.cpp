// FMI 3.0: the functions of its co-simulation interface over an Instance, and nothing else.
#include <exception>
#include <string>

#include "sil/exchange/fmu/fmi3_types.h"
#include "sil/exchange/fmu/instance.hpp"

namespace {

using fmu::Instance;
using fmu::Kind;

constexpr const char* error_category = "logStatusError";

// Errors stay within: no exception may reach an importer.
template <typename Action>
fmi3Status guarded(fmi3Instance instance, Action action) {
    if (instance == nullptr) {
        return fmi3Error;
    }
    Instance& object = *static_cast<Instance*>(instance);
    try {
        return action(object) ? fmi3OK : fmi3Error;
    } catch (const std::exception& error) {
        object.refuse(error.what());
        return fmi3Error;
    }
}

fmi3Status refused(fmi3Instance instance, const char* function) {
    return guarded(instance, [function](Instance& object) {
        return object.refuse(std::string{function} +
                             " is not offered by this FMU; modelDescription.xml says what is");
    });
}

template <typename Number>
fmi3Status get(fmi3Instance instance, Kind kind, const fmi3ValueReference references[], size_t count,
               Number values[]) {
    return guarded(instance, [=](Instance& object) {
        for (size_t index = 0U; index < count; ++index) {
            double value = 0.0;
            if (!object.get(kind, references[index], value)) {
                return false;
            }
            values[index] = static_cast<Number>(value);
        }
        return true;
    });
}

template <typename Number>
fmi3Status set(fmi3Instance instance, Kind kind, const fmi3ValueReference references[], size_t count,
               const Number values[]) {
    return guarded(instance, [=](Instance& object) {
        for (size_t index = 0U; index < count; ++index) {
            if (!object.set(kind, references[index], static_cast<double>(values[index]))) {
                return false;
            }
        }
        return true;
    });
}

}  // namespace

RSI_FMI3_EXPORT const char* fmi3GetVersion() {
    return "3.0";
}

RSI_FMI3_EXPORT fmi3Status fmi3SetDebugLogging(fmi3Instance, fmi3Boolean, size_t, const fmi3String[]) {
    return fmi3OK;  // only what is wrong is logged, and that always
}

RSI_FMI3_EXPORT fmi3Instance fmi3InstantiateCoSimulation(fmi3String name, fmi3String token, fmi3String,
                                                         fmi3Boolean, fmi3Boolean, fmi3Boolean, fmi3Boolean,
                                                         const fmi3ValueReference[], size_t,
                                                         fmi3InstanceEnvironment environment,
                                                         fmi3LogMessageCallback log_message,
                                                         fmi3IntermediateUpdateCallback) {
    const auto log = [environment, log_message](const std::string& sentence) {
        if (log_message != nullptr) {
            log_message(environment, fmi3Error, error_category, sentence.c_str());
        }
    };
    try {
        return Instance::create(name == nullptr ? "" : name, token, log).release();
    } catch (const std::exception& error) {
        log(error.what());
        return nullptr;
    }
}

RSI_FMI3_EXPORT fmi3Instance fmi3InstantiateModelExchange(fmi3String, fmi3String, fmi3String, fmi3Boolean,
                                                          fmi3Boolean, fmi3InstanceEnvironment environment,
                                                          fmi3LogMessageCallback log_message) {
    if (log_message != nullptr) {
        log_message(environment, fmi3Error, error_category,
                    "this FMU is for co-simulation; instantiate it for that");
    }
    return nullptr;
}

RSI_FMI3_EXPORT fmi3Instance fmi3InstantiateScheduledExecution(
    fmi3String, fmi3String, fmi3String, fmi3Boolean, fmi3Boolean, fmi3InstanceEnvironment environment,
    fmi3LogMessageCallback log_message, fmi3ClockUpdateCallback, fmi3LockPreemptionCallback,
    fmi3UnlockPreemptionCallback) {
    return fmi3InstantiateModelExchange(nullptr, nullptr, nullptr, false, false, environment, log_message);
}

RSI_FMI3_EXPORT void fmi3FreeInstance(fmi3Instance instance) {
    delete static_cast<Instance*>(instance);
}

RSI_FMI3_EXPORT fmi3Status fmi3EnterInitializationMode(fmi3Instance instance, fmi3Boolean, fmi3Float64,
                                                       fmi3Float64 start_time, fmi3Boolean, fmi3Float64) {
    return guarded(instance, [=](Instance& object) { return object.enter_initialisation(start_time); });
}

RSI_FMI3_EXPORT fmi3Status fmi3ExitInitializationMode(fmi3Instance instance) {
    return guarded(instance, [](Instance& object) { return object.exit_initialisation(); });
}

RSI_FMI3_EXPORT fmi3Status fmi3Terminate(fmi3Instance instance) {
    return guarded(instance, [](Instance& object) { return object.terminate(); });
}

RSI_FMI3_EXPORT fmi3Status fmi3Reset(fmi3Instance instance) {
    return guarded(instance, [](Instance& object) { return object.reset(); });
}

RSI_FMI3_EXPORT fmi3Status fmi3DoStep(fmi3Instance instance, fmi3Float64 now, fmi3Float64 step, fmi3Boolean,
                                      fmi3Boolean* event_handling_needed, fmi3Boolean* terminate_simulation,
                                      fmi3Boolean* early_return, fmi3Float64* last_successful_time) {
    *event_handling_needed = false;
    *terminate_simulation = false;
    *early_return = false;
    return guarded(instance, [=](Instance& object) {
        const bool done = object.step(now, step);
        *last_successful_time = object.time_s();
        return done;
    });
}

RSI_FMI3_EXPORT fmi3Status fmi3EnterStepMode(fmi3Instance instance) {
    return refused(instance, "fmi3EnterStepMode");
}

#define RSI_GETTER(type, kind)                                                                             \
    RSI_FMI3_EXPORT fmi3Status fmi3Get##type(fmi3Instance instance, const fmi3ValueReference references[], \
                                             size_t count, fmi3##type values[], size_t) {                  \
        return get(instance, kind, references, count, values);                                             \
    }                                                                                                      \
    RSI_FMI3_EXPORT fmi3Status fmi3Set##type(fmi3Instance instance, const fmi3ValueReference references[], \
                                             size_t count, const fmi3##type values[], size_t) {            \
        return set(instance, kind, references, count, values);                                             \
    }
RSI_GETTER(Float64, Kind::number)
RSI_GETTER(Int32, Kind::integer)
RSI_GETTER(Int64, Kind::choice)
RSI_GETTER(Boolean, Kind::boolean)
#undef RSI_GETTER

RSI_FMI3_EXPORT fmi3Status fmi3GetString(fmi3Instance instance, const fmi3ValueReference references[],
                                         size_t count, fmi3String values[], size_t) {
    return guarded(instance, [=](Instance& object) {
        for (size_t index = 0U; index < count; ++index) {
            if (!object.get(references[index], values[index])) {
                return false;
            }
        }
        return true;
    });
}

RSI_FMI3_EXPORT fmi3Status fmi3SetString(fmi3Instance instance, const fmi3ValueReference references[],
                                         size_t count, const fmi3String values[], size_t) {
    return guarded(instance, [=](Instance& object) {
        for (size_t index = 0U; index < count; ++index) {
            if (!object.set(references[index], values[index])) {
                return false;
            }
        }
        return true;
    });
}

RSI_FMI3_EXPORT fmi3Status fmi3GetFMUState(fmi3Instance instance, fmi3FMUState* state) {
    return guarded(instance, [=](Instance& object) { return object.save(state); });
}

RSI_FMI3_EXPORT fmi3Status fmi3SetFMUState(fmi3Instance instance, fmi3FMUState state) {
    return guarded(instance, [=](Instance& object) { return object.restore(state); });
}

RSI_FMI3_EXPORT fmi3Status fmi3FreeFMUState(fmi3Instance instance, fmi3FMUState* state) {
    return guarded(instance, [=](Instance& object) { return object.free_state(state); });
}

RSI_FMI3_EXPORT fmi3Status fmi3SerializedFMUStateSize(fmi3Instance instance, fmi3FMUState state,
                                                      size_t* size) {
    return guarded(instance, [=](Instance& object) { return object.serialised_size(state, *size); });
}

RSI_FMI3_EXPORT fmi3Status fmi3SerializeFMUState(fmi3Instance instance, fmi3FMUState state, fmi3Byte bytes[],
                                                 size_t size) {
    return guarded(instance, [=](Instance& object) { return object.serialise(state, bytes, size); });
}

RSI_FMI3_EXPORT fmi3Status fmi3DeserializeFMUState(fmi3Instance instance, const fmi3Byte bytes[], size_t size,
                                                   fmi3FMUState* state) {
    return guarded(instance, [=](Instance& object) { return object.deserialise(bytes, size, state); });
}

// There for importers that look up every function of the interface.
#define RSI_REFUSED(name, parameters)            \
    RSI_FMI3_EXPORT fmi3Status name parameters { \
        return refused(instance, #name);         \
    }
#define RSI_REFUSED_TYPE(type)                                                                     \
    RSI_REFUSED(fmi3Get##type,                                                                     \
                (fmi3Instance instance, const fmi3ValueReference[], size_t, fmi3##type[], size_t)) \
    RSI_REFUSED(fmi3Set##type,                                                                     \
                (fmi3Instance instance, const fmi3ValueReference[], size_t, const fmi3##type[], size_t))
RSI_REFUSED_TYPE(Float32)
RSI_REFUSED_TYPE(Int8)
RSI_REFUSED_TYPE(UInt8)
RSI_REFUSED_TYPE(Int16)
RSI_REFUSED_TYPE(UInt16)
RSI_REFUSED_TYPE(UInt32)
RSI_REFUSED_TYPE(UInt64)
RSI_REFUSED(fmi3GetBinary,
            (fmi3Instance instance, const fmi3ValueReference[], size_t, size_t[], fmi3Binary[], size_t))
RSI_REFUSED(fmi3SetBinary, (fmi3Instance instance, const fmi3ValueReference[], size_t, const size_t[],
                            const fmi3Binary[], size_t))
RSI_REFUSED(fmi3GetClock, (fmi3Instance instance, const fmi3ValueReference[], size_t, fmi3Clock[]))
RSI_REFUSED(fmi3SetClock, (fmi3Instance instance, const fmi3ValueReference[], size_t, const fmi3Clock[]))
RSI_REFUSED(fmi3GetNumberOfVariableDependencies, (fmi3Instance instance, fmi3ValueReference, size_t*))
RSI_REFUSED(fmi3GetVariableDependencies, (fmi3Instance instance, fmi3ValueReference, size_t[],
                                          fmi3ValueReference[], size_t[], fmi3DependencyKind[], size_t))
RSI_REFUSED(fmi3GetDirectionalDerivative,
            (fmi3Instance instance, const fmi3ValueReference[], size_t, const fmi3ValueReference[], size_t,
             const fmi3Float64[], size_t, fmi3Float64[], size_t))
RSI_REFUSED(fmi3GetAdjointDerivative,
            (fmi3Instance instance, const fmi3ValueReference[], size_t, const fmi3ValueReference[], size_t,
             const fmi3Float64[], size_t, fmi3Float64[], size_t))
RSI_REFUSED(fmi3GetOutputDerivatives, (fmi3Instance instance, const fmi3ValueReference[], size_t,
                                       const fmi3Int32[], fmi3Float64[], size_t))
RSI_REFUSED(fmi3EnterConfigurationMode, (fmi3Instance instance))
RSI_REFUSED(fmi3ExitConfigurationMode, (fmi3Instance instance))
RSI_REFUSED(fmi3EnterEventMode, (fmi3Instance instance))
RSI_REFUSED(fmi3EvaluateDiscreteStates, (fmi3Instance instance))
RSI_REFUSED(fmi3UpdateDiscreteStates, (fmi3Instance instance, fmi3Boolean*, fmi3Boolean*, fmi3Boolean*,
                                       fmi3Boolean*, fmi3Boolean*, fmi3Float64*))
RSI_REFUSED(fmi3GetIntervalDecimal, (fmi3Instance instance, const fmi3ValueReference[], size_t, fmi3Float64[],
                                     fmi3IntervalQualifier[]))
RSI_REFUSED(fmi3GetIntervalFraction, (fmi3Instance instance, const fmi3ValueReference[], size_t, fmi3UInt64[],
                                      fmi3UInt64[], fmi3IntervalQualifier[]))
RSI_REFUSED(fmi3GetShiftDecimal, (fmi3Instance instance, const fmi3ValueReference[], size_t, fmi3Float64[]))
RSI_REFUSED(fmi3GetShiftFraction,
            (fmi3Instance instance, const fmi3ValueReference[], size_t, fmi3UInt64[], fmi3UInt64[]))
RSI_REFUSED(fmi3SetIntervalDecimal,
            (fmi3Instance instance, const fmi3ValueReference[], size_t, const fmi3Float64[]))
RSI_REFUSED(fmi3SetIntervalFraction, (fmi3Instance instance, const fmi3ValueReference[], size_t,
                                      const fmi3UInt64[], const fmi3UInt64[]))
RSI_REFUSED(fmi3SetShiftDecimal,
            (fmi3Instance instance, const fmi3ValueReference[], size_t, const fmi3Float64[]))
RSI_REFUSED(fmi3SetShiftFraction, (fmi3Instance instance, const fmi3ValueReference[], size_t,
                                   const fmi3UInt64[], const fmi3UInt64[]))
RSI_REFUSED(fmi3EnterContinuousTimeMode, (fmi3Instance instance))
RSI_REFUSED(fmi3CompletedIntegratorStep, (fmi3Instance instance, fmi3Boolean, fmi3Boolean*, fmi3Boolean*))
RSI_REFUSED(fmi3SetTime, (fmi3Instance instance, fmi3Float64))
RSI_REFUSED(fmi3SetContinuousStates, (fmi3Instance instance, const fmi3Float64[], size_t))
RSI_REFUSED(fmi3GetContinuousStateDerivatives, (fmi3Instance instance, fmi3Float64[], size_t))
RSI_REFUSED(fmi3GetEventIndicators, (fmi3Instance instance, fmi3Float64[], size_t))
RSI_REFUSED(fmi3GetContinuousStates, (fmi3Instance instance, fmi3Float64[], size_t))
RSI_REFUSED(fmi3GetNominalsOfContinuousStates, (fmi3Instance instance, fmi3Float64[], size_t))
RSI_REFUSED(fmi3GetNumberOfEventIndicators, (fmi3Instance instance, size_t*))
RSI_REFUSED(fmi3GetNumberOfContinuousStates, (fmi3Instance instance, size_t*))
RSI_REFUSED(fmi3ActivateModelPartition, (fmi3Instance instance, fmi3ValueReference, fmi3Float64))
#undef RSI_REFUSED_TYPE
#undef RSI_REFUSED
