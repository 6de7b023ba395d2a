#include "sil/exchange/fmu/instance.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "sil/exchange/fmu/sentence.hpp"
#include "sil/exchange/fmu/serial_state.hpp"
#include "sil/exchange/fmu/start_values.hpp"

namespace fmu {
namespace {

// Importers add up times, which rounds.
constexpr double time_tolerance_s = 1.0e-3 * cycle_s;
constexpr double most_cycles_a_step = 1.0e6;

Complaint wrong_value(const Variable& variable, double value) {
    const bool finite = std::isfinite(value);
    const bool whole = variable.kind == Kind::number || value == std::floor(value);
    if (!variable.has_range()) {
        return finite || variable.may_be_missing ? "" : "is no finite number; give one";
    }
    if (finite && whole && value >= variable.least && value <= variable.largest) {
        return {};
    }
    return "is outside its range, " + text_of(variable.least) + " to " + text_of(variable.largest) +
           "; give a value within it";
}

std::string named(const Variable& variable) {
    return (variable.role == Role::parameter ? "parameter " : "input ") + variable.name;
}

const char* name_of(Kind kind) {
    constexpr const char* names[] = {"a number", "an integer", "a boolean", "a text", "an enumeration"};
    return names[static_cast<std::size_t>(kind)];
}

}  // namespace

std::unique_ptr<Instance> Instance::create(const std::string& name, const char* token, Log log) {
    if (token == nullptr || std::strcmp(token, instantiation_token) != 0) {
        log(name + ": the modelDescription.xml that was read is not this FMU's; unpack the FMU anew");
        return nullptr;
    }
    return std::unique_ptr<Instance>{new Instance{name, std::move(log), make_model()}};
}

Instance::Instance(std::string name, Log log, std::unique_ptr<Model> model)
    : name_{std::move(name)},
      log_{std::move(log)},
      variables_{model->variables()},
      fresh_{std::move(model)},
      now_{Phase::instantiated, false, 0.0, 0U, 0.0, Values{variables_}, Values{variables_}, fresh_->copy()} {
}

bool Instance::refuse(const std::string& sentence) {
    log_(name_ + ": " + sentence);
    return false;
}

bool Instance::accept(const Complaint& complaint) {
    return complaint.empty() || refuse(complaint);
}

bool Instance::enter_initialisation(double start_s) {
    if (now_.phase != Phase::instantiated) {
        return refuse("is initialised already; reset it first");
    }
    if (!std::isfinite(start_s)) {
        return refuse("the start time is no finite number; give one");
    }
    now_.start_s = start_s;
    now_.phase = Phase::initialisation;
    return true;
}

bool Instance::know_outputs() {
    if (now_.phase != Phase::initialisation || now_.outputs_known) {
        return true;
    }
    now_.outputs_known = accept(now_.model->start(now_.values));
    return now_.outputs_known;
}

bool Instance::exit_initialisation() {
    if (now_.phase != Phase::initialisation) {
        return refuse("is not in initialisation mode; enter that first");
    }
    if (!know_outputs()) {
        return false;
    }
    now_.phase = Phase::stepping;
    return true;
}

bool Instance::terminate() {
    now_.phase = Phase::terminated;
    return true;
}

bool Instance::reset() {
    now_ = SavedState{Phase::instantiated, false,         0.0, 0U, 0.0, Values{variables_},
                      Values{variables_},  fresh_->copy()};
    return true;
}

double Instance::time_s() const {
    return now_.start_s + static_cast<double>(now_.cycles) * cycle_s + now_.into_cycle_s;
}

bool Instance::step(double now_s, double step_s) {
    if (now_.phase != Phase::stepping) {
        return refuse("a step before initialisation has ended, or after termination; initialise first");
    }
    if (!(std::abs(now_s - time_s()) <= time_tolerance_s)) {
        return refuse("a step from " + text_of(now_s) + " s, but " + text_of(time_s()) +
                      " s is reached; step from there, or restore a state of that time");
    }
    if (!(step_s > 0.0 && step_s <= most_cycles_a_step * cycle_s)) {
        return refuse("a step of " + text_of(step_s) + " s; give one above 0 and up to " +
                      text_of(most_cycles_a_step * cycle_s) + " s, best 0.01 s");
    }
    if (now_.into_cycle_s < time_tolerance_s) {
        now_.sampled = now_.values;
    }
    now_.into_cycle_s += step_s;
    while (now_.into_cycle_s >= cycle_s - time_tolerance_s) {
        if (!end_cycle()) {
            return false;
        }
        now_.sampled = now_.values;
    }
    return true;
}

bool Instance::end_cycle() {
    if (!accept(now_.model->cycle(now_.sampled))) {
        return false;
    }
    ++now_.cycles;
    now_.into_cycle_s -= cycle_s;
    show_outputs();
    return true;
}

void Instance::show_outputs() {
    for (std::size_t place = 0U; place < variables_.size(); ++place) {
        if (variables_[place].role == Role::output) {
            now_.values.numbers[place] = now_.sampled.numbers[place];
        }
    }
}

bool Instance::is_choice(std::uint32_t reference) const {
    return reference < variables_.size() && variables_[reference].kind == Kind::choice;
}

const Variable* Instance::known(Kind kind, std::uint32_t reference) {
    if (reference >= variables_.size()) {
        refuse("there is no variable with the value reference " + std::to_string(reference) +
               "; modelDescription.xml names them");
        return nullptr;
    }
    const Variable& variable = variables_[reference];
    if (variable.kind != kind) {
        refuse(variable.name + " is " + name_of(variable.kind) + " and not " + name_of(kind) +
               "; get and set it as such");
        return nullptr;
    }
    return &variable;
}

const Variable* Instance::readable(Kind kind, std::uint32_t reference) {
    const Variable* const variable = known(kind, reference);
    const bool computed = variable != nullptr && variable->role == Role::output;
    return !computed || know_outputs() ? variable : nullptr;
}

const Variable* Instance::settable(Kind kind, std::uint32_t reference) {
    const Variable* const variable = known(kind, reference);
    if (variable == nullptr) {
        return nullptr;
    }
    const bool before = now_.phase == Phase::instantiated || now_.phase == Phase::initialisation;
    if (variable->role != Role::input && variable->role != Role::parameter) {
        refuse(variable->name + " cannot be set; only parameters and inputs can");
        return nullptr;
    }
    if (variable->role == Role::parameter && !before) {
        refuse("parameter " + variable->name +
               " is fixed; set it before initialisation ends, or reset the instance first");
        return nullptr;
    }
    return variable;
}

bool Instance::get(Kind kind, std::uint32_t reference, double& value) {
    const Variable* const variable = readable(kind, reference);
    if (variable == nullptr) {
        return false;
    }
    value = variable->role == Role::time ? time_s() : now_.values.numbers[reference];
    return true;
}

bool Instance::get(std::uint32_t reference, const char*& text) {
    if (readable(Kind::text, reference) == nullptr) {
        return false;
    }
    text = now_.values.texts[reference].c_str();
    return true;
}

bool Instance::set(Kind kind, std::uint32_t reference, double value) {
    const Variable* const variable = settable(kind, reference);
    if (variable == nullptr) {
        return false;
    }
    const Complaint complaint = wrong_value(*variable, value);
    if (!complaint.empty()) {
        return refuse(named(*variable) + ": " + text_of(value) + " " + complaint);
    }
    now_.values.numbers[reference] = value;
    now_.outputs_known = false;
    return true;
}

bool Instance::set(std::uint32_t reference, const char* text) {
    if (settable(Kind::text, reference) == nullptr) {
        return false;
    }
    if (text == nullptr) {
        return refuse(named(variables_[reference]) + ": no text was given; give one");
    }
    now_.values.texts[reference] = text;
    now_.outputs_known = false;
    return true;
}

SavedState Instance::copy_of(const SavedState& state) const {
    return SavedState{state.phase,        state.outputs_known, state.start_s, state.cycles,
                      state.into_cycle_s, state.values,        state.sampled, state.model->copy()};
}

void* Instance::keep(std::unique_ptr<SavedState> state, void* in_place_of) {
    for (std::unique_ptr<SavedState>& each : kept_) {
        if (each.get() == in_place_of && in_place_of != nullptr) {
            *each = std::move(*state);
            return in_place_of;
        }
    }
    kept_.push_back(std::move(state));
    return kept_.back().get();
}

const SavedState* Instance::saved(const void* state) {
    const auto place =
        std::find_if(kept_.begin(), kept_.end(), [state](const auto& each) { return each.get() == state; });
    if (place == kept_.end()) {
        refuse("the state was not saved by this instance, or it was freed; save one first");
        return nullptr;
    }
    return place->get();
}

bool Instance::save(void** state) {
    *state = keep(std::make_unique<SavedState>(copy_of(now_)), *state);
    return true;
}

bool Instance::restore(const void* state) {
    const SavedState* const kept = saved(state);
    if (kept == nullptr) {
        return false;
    }
    now_ = copy_of(*kept);
    return true;
}

bool Instance::free_state(void** state) {
    if (*state == nullptr) {
        return true;
    }
    if (saved(*state) == nullptr) {
        return false;
    }
    kept_.erase(std::remove_if(kept_.begin(), kept_.end(),
                               [state](const auto& each) { return each.get() == *state; }),
                kept_.end());
    *state = nullptr;
    return true;
}

bool Instance::serialised_size(const void* state, std::size_t& size) {
    const SavedState* const kept = saved(state);
    if (kept == nullptr) {
        return false;
    }
    size = to_bytes(*kept).size();
    return size > 0U || refuse("its state cannot be serialised; save and restore it within the process");
}

bool Instance::serialise(const void* state, unsigned char* bytes, std::size_t size) {
    const SavedState* const kept = saved(state);
    if (kept == nullptr) {
        return false;
    }
    const std::string all = to_bytes(*kept);
    if (all.empty() || all.size() != size) {
        return refuse("a serialised state has " + std::to_string(all.size()) + " bytes and not " +
                      std::to_string(size) + "; ask for its size");
    }
    std::memcpy(bytes, all.data(), size);
    return true;
}

bool Instance::deserialise(const unsigned char* bytes, std::size_t size, void** state) {
    auto fresh = std::make_unique<SavedState>(copy_of(now_));
    if (bytes == nullptr || !from_bytes(std::string{bytes, bytes + size}, *fresh)) {
        return refuse(
            "these bytes are no state of this FMU, or they are damaged; give those that it serialised");
    }
    *state = keep(std::move(fresh), *state);
    return true;
}

}  // namespace fmu
