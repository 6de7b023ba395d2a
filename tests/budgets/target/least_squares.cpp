// Runs the firmware's least squares and the textbook's over the same recorded samples.
//   least_squares RECORDING ANSWER    words: ticks of an empty call, then for each sample ticks of the
//                                     firmware's update, of the textbook's
#include "rsi/estimation/robust_least_squares.hpp"
#include "tests/budgets/recording.hpp"
#include "tests/budgets/target/answer_writer.hpp"
#include "tests/budgets/target/instruction_counter.hpp"
#include "tests/budgets/target/recording_reader.hpp"
#include "tests/support/textbook_least_squares.hpp"

namespace {

enum Failure { bad_arguments = 1, bad_recording, bad_answer };

budgets::RecordingReader recording;
budgets::AnswerWriter answer;

template <typename Estimator>
[[gnu::noipa]] void update(Estimator& estimator, const rsi::Regression& regression) {
    estimator.update(regression);
}

template <>
[[gnu::noipa]] void update(int&, const rsi::Regression&) {}

template <typename Estimator>
[[gnu::noipa]] uint32_t ticks_of(Estimator& estimator, const rsi::Regression& regression) {
    const uint32_t before = budgets::InstructionCounter::now();
    update(estimator, regression);
    const uint32_t after = budgets::InstructionCounter::now();
    return budgets::InstructionCounter::between(before, after);
}

}  // namespace

int target::run(int argc, const char* const* argv) {
    if (argc != 3) {
        return bad_arguments;
    }
    if (!recording.load(argv[1], budgets::regression_magic)) {
        return bad_recording;
    }
    const rsi::Parameters parameters = recording.take<rsi::Parameters>();
    rsi::RobustLeastSquares firmware;
    firmware.init(parameters);
    rsi_test::TextbookLeastSquares textbook{parameters};
    budgets::InstructionCounter::start();
    int nothing = 0;
    answer.add(ticks_of(nothing, rsi::Regression{}));
    const uint32_t samples = recording.take<uint32_t>();
    for (uint32_t i = 0U; i < samples; ++i) {
        const auto record = recording.take<budgets::LeastSquaresRecord>();
        const rsi::Regression regression{record.output_nm, {record.psi[0], record.psi[1], record.psi[2]}};
        answer.add(ticks_of(firmware, regression));
        answer.add(ticks_of(textbook, regression));
    }
    if (!recording.complete()) {
        return bad_recording;
    }
    return answer.save(argv[2]) ? 0 : bad_answer;
}
