// Instance: one FMU that an importer has instantiated; what FMI 2 and FMI 3 have in common.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "sil/exchange/fmu/model.hpp"

namespace fmu {

enum class Phase : std::uint8_t { instantiated, initialisation, stepping, terminated };

// All that changes while an instance lives.
struct SavedState {
    Phase phase;
    bool outputs_known;
    double start_s;
    std::uint64_t cycles;
    double into_cycle_s;  // time that has passed since the end of the last cycle
    Values values;
    Values sampled;  // of the inputs at the beginning of the cycle that goes on
    std::unique_ptr<Model> model;
};

// A bool result is false after a refusal; the importer's log then has the reason, and nothing has
// changed.
class Instance {
 public:
    // Takes a sentence: what is wrong, where, and what to do.
    using Log = std::function<void(const std::string&)>;

    // Null when the FMU cannot be instantiated; then `log` has the reason.
    static std::unique_ptr<Instance> create(const std::string& name, const char* token, Log log);

    bool enter_initialisation(double start_s);
    bool exit_initialisation();
    bool terminate();
    bool reset();

    // From `now_s`, which must be the time that it has reached, on. A cycle takes the inputs of its beginning
    // and shows its outputs from its end on, however many steps it takes.
    bool step(double now_s, double step_s);
    double time_s() const;

    // `kind` is the one that the caller's function is for; an integer function of FMI 2 is also for choices.
    bool get(Kind kind, std::uint32_t reference, double& value);
    bool set(Kind kind, std::uint32_t reference, double value);
    bool get(std::uint32_t reference, const char*& text);  // valid until the next change
    bool set(std::uint32_t reference, const char* text);
    bool is_choice(std::uint32_t reference) const;

    // States belong to the instance that has handed them out; another's, or one that is freed, is refused.
    bool save(void** state);
    bool restore(const void* state);
    bool free_state(void** state);
    bool serialised_size(const void* state, std::size_t& size);
    bool serialise(const void* state, unsigned char* bytes, std::size_t size);
    bool deserialise(const unsigned char* bytes, std::size_t size, void** state);

    // For functions that this FMU does not have.
    bool refuse(const std::string& sentence);

 private:
    Instance(std::string name, Log log, std::unique_ptr<Model> model);

    const Variable* settable(Kind kind, std::uint32_t reference);
    const Variable* readable(Kind kind, std::uint32_t reference);
    const Variable* known(Kind kind, std::uint32_t reference);
    const SavedState* saved(const void* state);
    bool accept(const Complaint& complaint);
    void* keep(std::unique_ptr<SavedState> state, void* in_place_of);
    bool know_outputs();
    bool end_cycle();
    void show_outputs();
    SavedState copy_of(const SavedState& state) const;

    std::string name_;
    Log log_;
    Variables variables_;
    std::unique_ptr<Model> fresh_;  // as instantiated
    SavedState now_;
    std::vector<std::unique_ptr<SavedState>> kept_{};
};

}  // namespace fmu
