// RAM of XCP and diagnosis beside the ECU; their storage belongs to the platform.
//   access_sizes ANSWER    words: bytes of XCP with its calibration pages, of diagnosis with the place for a
//   section, of
//                          the seed and key that each of them has
#include "access/seed_and_key.hpp"
#include "application/calibrated_ecu.hpp"
#include "diagnosis/diagnosis.hpp"
#include "diagnosis/section_store.hpp"
#include "tests/targets/budgets/target/answer_writer.hpp"

namespace {

enum Failure { bad_arguments = 1, bad_answer };

budgets::AnswerWriter answer;

}  // namespace

int target::run(int argc, const char* const* argv) {
    if (argc != 2) {
        return bad_arguments;
    }
    answer.add(sizeof(application::CalibratedEcu) - sizeof(application::RolloverEcu));
    answer.add(sizeof(diagnosis::Diagnosis) + sizeof(diagnosis::SectionStore));
    answer.add(sizeof(access_control::SeedAndKey));
    return answer.save(argv[1]) ? 0 : bad_answer;
}
