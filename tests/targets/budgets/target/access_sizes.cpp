// RAM of XCP and diagnosis beside the ECU; their storage belongs to the platform.
//   access_sizes ANSWER    words: bytes of XCP with its calibration pages, of diagnosis with the place for a
//   section, of
//                          the seed and key that each of them has
#include "rsi/ecu/access/seed_and_key.hpp"
#include "rsi/ecu/application/calibrated_ecu.hpp"
#include "rsi/ecu/diagnosis/diagnosis.hpp"
#include "rsi/ecu/diagnosis/section_store.hpp"
#include "tests/targets/budgets/target/answer_writer.hpp"

namespace {

enum Failure { bad_arguments = 1, bad_answer };

budgets::AnswerWriter answer;

}  // namespace

int target::run(int argc, const char* const* argv) {
    if (argc != 2) {
        return bad_arguments;
    }
    answer.add(sizeof(rsi::application::CalibratedEcu) - sizeof(rsi::application::RolloverEcu));
    answer.add(sizeof(rsi::diagnosis::Diagnosis) + sizeof(rsi::diagnosis::SectionStore));
    answer.add(sizeof(rsi::access::SeedAndKey));
    return answer.save(argv[1]) ? 0 : bad_answer;
}
