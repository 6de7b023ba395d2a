// J-turn after NHTSA: one fast turn of the handwheel, held.
#include "sil/studies/procedures/catalogue.hpp"
#include "sil/studies/procedures/speed_ladder.hpp"

namespace sil {
namespace {

constexpr double start_s = 2.0;
constexpr double rate_radps = from_degrees(1000.0);
constexpr double held_s = 4.0;
constexpr double return_s = 2.0;
constexpr double amplitude_factor = 8.0;

Manoeuvre j_turn(double speed_mps, double handwheel_rad) {
    const double back_s = start_s + handwheel_rad / rate_radps + held_s;
    Manoeuvre manoeuvre;
    manoeuvre.duration_s = back_s + return_s;
    manoeuvre.initial_speed_mps = speed_mps;
    manoeuvre.make_road = flat_road();
    manoeuvre.make_driver = open_loop([handwheel_rad, back_s](double time_s) {
        return DriverCommand{ramp_and_hold(time_s, start_s, rate_radps, handwheel_rad) -
                                 ramp_and_hold(time_s, back_s, handwheel_rad / return_s, handwheel_rad),
                             time_s < start_s ? SpeedPolicy::held : SpeedPolicy::off_throttle};
    });
    return manoeuvre;
}

ProcedureResult run_j_turn(const ProcedureWorld& world) {
    SpeedLadder ladder;
    ladder.speeds_mph = {35.0, 40.0, 45.0, 50.0, 55.0, 60.0};
    ladder.factor = amplitude_factor;
    ladder.start_s = start_s;
    ladder.source = "DOT HS 809 513";
    ladder.manoeuvre = j_turn;
    return run_speed_ladder(world, ladder);
}

}  // namespace

Procedure j_turn_procedure() {
    return {"j-turn",
            "8 A at 1000 degrees/s, held for 4 s, from 35 to 60 mph in steps of 5, both directions",
            {"NHTSA, DOT HS 809 513 (Phase IV of the rollover research, 2002): J-Turn"},
            run_j_turn};
}

}  // namespace sil
