// Fishhooks after NHTSA: 1b, with roll-rate feedback, is the rollover test of its New Car Assessment Program;
// 1a, with a fixed dwell, comes from the research before it.
#include "sil/studies/procedures/catalogue.hpp"
#include "sil/studies/procedures/speed_ladder.hpp"
#include "sil/world/manoeuvres/rule_book.hpp"

namespace sil {
namespace {

// Entrance speeds: Laboratory Test Procedure for Dynamic Rollover, section 3.2.2.1; in the research steps of
// five miles per hour.
ProcedureResult run_fishhook_1a(const ProcedureWorld& world) {
    SpeedLadder ladder;
    ladder.speeds_mph = {35.0, 40.0, 45.0, 50.0};
    ladder.factor = fishhook_amplitude_factor;
    ladder.source = "DOT HS 809 513";
    ladder.manoeuvre = [](double speed_mps, double handwheel_rad) {
        return fishhook(FishhookReversal::after_a_fixed_dwell, speed_mps, handwheel_rad);
    };
    return run_speed_ladder(world, ladder);
}

ProcedureResult run_fishhook_1b(const ProcedureWorld& world) {
    SpeedLadder ladder;
    ladder.speeds_mph = {35.0, 40.0, 45.0, 47.5, 50.0};
    ladder.factor = fishhook_amplitude_factor;
    ladder.source = "NHTSA Laboratory Test Procedure for Dynamic Rollover, section 3.2";
    ladder.manoeuvre = [](double speed_mps, double handwheel_rad) {
        return fishhook(FishhookReversal::at_small_roll_rate, speed_mps, handwheel_rad);
    };
    ProcedureResult result = run_speed_ladder(world, ladder);
    result.notes.push_back(
        "Only the default series is driven; the supplemental ones, with new tyres or another steering angle, "
        "are not.");
    return result;
}

}  // namespace

Procedure fishhook_1a_procedure() {
    return {"fishhook-1a",
            "6.5 A at 720 degrees/s, reversed after 250 ms, from 35 to 50 mph in steps of 5, both directions",
            {"NHTSA, DOT HS 809 513 (Phase IV of the rollover research, 2002): Fishhook 1a"},
            run_fishhook_1a};
}

Procedure fishhook_1b_procedure() {
    return {
        "fishhook-1b",
        "6.5 A at 720 degrees/s, reversed at a roll rate of 1.5 degrees/s, at 35, 40, 45, 47.5 and 50 mph, "
        "both directions",
        {"NHTSA, Laboratory Test Procedure for Dynamic Rollover (NCAP, March 2013), sections 3.1 and 3.2",
         "68 FR 59250 (14 October 2003)"},
        run_fishhook_1b};
}

}  // namespace sil
