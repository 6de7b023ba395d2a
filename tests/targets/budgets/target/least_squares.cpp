// Runs the firmware's least squares and the textbook's over the same recorded samples, for a trace of the
// emulator.
//   least_squares RECORDING
#include "rsi/estimation/robust_least_squares.hpp"
#include "tests/support/textbook_least_squares.hpp"
#include "tests/targets/budgets/recording.hpp"
#include "tests/targets/budgets/target/recording_reader.hpp"

namespace {

enum Failure { bad_arguments = 1, bad_recording };

budgets::RecordingReader recording;

}  // namespace

// Marks that the trace looks for.
extern "C" {

[[gnu::noipa]] void update_firmware(rsi::RobustLeastSquares& estimator,
                                    const rsi::RobustLeastSquares::Constants& constants,
                                    const rsi::Regression& regression) {
    estimator.update(constants, regression);
}

[[gnu::noipa]] void update_textbook(rsi_test::TextbookLeastSquares& estimator,
                                    const rsi::Regression& regression) {
    estimator.update(regression);
}
}

int target::run(int argc, const char* const* argv) {
    if (argc != 2) {
        return bad_arguments;
    }
    if (!recording.load(argv[1], budgets::regression_magic)) {
        return bad_recording;
    }
    const rsi::Parameters parameters = recording.take<rsi::Parameters>();
    rsi::RobustLeastSquares firmware;
    const rsi::RobustLeastSquares::Constants constants{parameters};
    rsi_test::TextbookLeastSquares textbook{parameters};
    const uint32_t samples = recording.take<uint32_t>();
    for (uint32_t i = 0U; i < samples; ++i) {
        const auto record = recording.take<budgets::LeastSquaresRecord>();
        const rsi::Regression regression{record.output_nm, {record.psi[0], record.psi[1], record.psi[2]}};
        update_firmware(firmware, constants, regression);
        update_textbook(textbook, regression);
    }
    return recording.complete() ? 0 : bad_recording;
}
