// Steps the component through the recorded drives and gives back what each step cost.
//   steps RECORDING ANSWER count     words: ticks of an empty call, then for each drive: ticks of every step,
//                                    digest of the outputs
//   steps RECORDING ANSWER trace     the same, for a trace of the emulator: every step is made once only
//   steps RECORDING ANSWER stack     words: bytes of stack that rsi_init and rsi_step used at most, over all;
//                                    size of the component; ticks of an empty call and, at most, of a reset
#include <string.h>

#include "rsi/component.hpp"
#include "tests/targets/budgets/output_digest.hpp"
#include "tests/targets/budgets/recording.hpp"
#include "tests/targets/budgets/target/answer_writer.hpp"
#include "tests/targets/budgets/target/instruction_counter.hpp"
#include "tests/targets/budgets/target/painted_stack.hpp"
#include "tests/targets/budgets/target/recording_reader.hpp"

namespace {

enum Failure { bad_arguments = 1, bad_recording, refused_parameters, bad_answer };

budgets::RecordingReader recording;
budgets::AnswerWriter answer;
rsi_component component;
rsi_component copy;
rsi_component rehearsal;
rsi::Component to_reset;

// QEMU's counter has been seen to count a few instructions twice when the machine is busy: the least counts.
constexpr int repetitions = 3;

using Step = void (*)(rsi_component*, const rsi_inputs*, rsi_outputs*);

[[gnu::noinline]] void empty_step(rsi_component*, const rsi_inputs*, rsi_outputs*) {
    asm volatile("");
}

[[gnu::noipa]] uint32_t ticks_of(Step step, rsi_component* on, const rsi_inputs& inputs,
                                 rsi_outputs& outputs) {
    const uint32_t before = budgets::InstructionCounter::now();
    step(on, &inputs, &outputs);
    const uint32_t after = budgets::InstructionCounter::now();
    return budgets::InstructionCounter::between(before, after);
}

[[gnu::noipa]] uint32_t ticks_of_reset(const rsi_parameters& parameters) {
    const uint32_t before = budgets::InstructionCounter::now();
    to_reset.reset(parameters);
    const uint32_t after = budgets::InstructionCounter::now();
    return budgets::InstructionCounter::between(before, after);
}

rsi_component* choose(const budgets::Record& record) {
    if (record.on_copy == 0U) {
        return &component;
    }
    memcpy(&copy, &component, sizeof(copy));
    return &copy;
}

class Counts {
 public:
    explicit Counts(bool traced) : repetitions_{traced ? 0 : repetitions} {}
    void begin() {
        budgets::InstructionCounter::start();
        rsi_inputs inputs{};
        rsi_outputs outputs{};
        answer.add(ticks_of(empty_step, &component, inputs, outputs));
    }
    bool begin_drive(const rsi_parameters& parameters) {
        digest_ = budgets::fnv_offset;
        return rsi_init(&component, &parameters).accepted != 0;
    }
    void step(const budgets::Record& record) {
        rsi_outputs outputs;
        rsi_component* const on = choose(record);
        uint32_t least = UINT32_MAX;
        for (int i = 0; i < repetitions_; ++i) {
            memcpy(&rehearsal, on, sizeof(rehearsal));
            const uint32_t ticks = ticks_of(rsi_step, &rehearsal, record.inputs, outputs);
            least = (ticks < least) ? ticks : least;
        }
        const uint32_t ticks = ticks_of(rsi_step, on, record.inputs, outputs);
        answer.add((ticks < least) ? ticks : least);
        if (repetitions_ > 0) {
            digest_ = budgets::digest(digest_, outputs);
        }
    }
    void end_drive() { answer.add(digest_); }
    void end() {}

 private:
    int repetitions_;
    uint32_t digest_{0U};
};

class Stack {
 public:
    void begin() {
        budgets::InstructionCounter::start();
        rsi_inputs inputs{};
        rsi_outputs outputs{};
        empty_call_ = ticks_of(empty_step, &component, inputs, outputs);
    }
    bool begin_drive(const rsi_parameters& parameters) {
        to_reset.init(parameters);
        uint32_t least = UINT32_MAX;
        for (int i = 0; i < repetitions; ++i) {
            const uint32_t ticks = ticks_of_reset(parameters);
            least = (ticks < least) ? ticks : least;
        }
        note(reset_, least);
        rsi_validation validation{};
        note(in_init_, budgets::stack_used([&] { validation = rsi_init(&component, &parameters); }));
        return validation.accepted != 0;
    }
    void step(const budgets::Record& record) {
        rsi_outputs outputs;
        rsi_component* const on = choose(record);
        note(in_step_, budgets::stack_used([&] { rsi_step(on, &record.inputs, &outputs); }));
    }
    void end_drive() {}
    void end() {
        answer.add(in_init_);
        answer.add(in_step_);
        answer.add(sizeof(rsi::Component));
        answer.add(empty_call_);
        answer.add(reset_);
    }

 private:
    static void note(uint32_t& most, uint32_t used) { most = (used > most) ? used : most; }
    uint32_t in_init_{0U};
    uint32_t in_step_{0U};
    uint32_t empty_call_{0U};
    uint32_t reset_{0U};
};

template <typename Measure>
int drive_all(Measure measure) {
    measure.begin();
    const uint32_t drives = recording.take<uint32_t>();
    for (uint32_t drive = 0U; drive < drives; ++drive) {
        if (!measure.begin_drive(recording.take<rsi_parameters>())) {
            return refused_parameters;
        }
        const uint32_t records = recording.take<uint32_t>();
        for (uint32_t i = 0U; i < records; ++i) {
            measure.step(recording.take<budgets::Record>());
        }
        measure.end_drive();
    }
    measure.end();
    return recording.complete() ? 0 : bad_recording;
}

}  // namespace

int target::run(int argc, const char* const* argv) {
    if (argc != 4) {
        return bad_arguments;
    }
    if (!recording.load(argv[1], budgets::recording_magic)) {
        return bad_recording;
    }
    const bool stack = (strcmp(argv[3], "stack") == 0);
    const bool trace = (strcmp(argv[3], "trace") == 0);
    const int failure = stack ? drive_all(Stack{}) : drive_all(Counts{trace});
    return ((failure == 0) && !answer.save(argv[2])) ? bad_answer : failure;
}
