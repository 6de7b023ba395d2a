#include "sil/studies/faults/known_undetected.hpp"

#include <algorithm>

namespace sil {

const std::vector<KnownUndetected>& known_undetected_errors() {
    static const std::vector<KnownUndetected> all{
        {FaultKind::frozen, FaultPlace::lateral_acceleration, 0,
         "found after 0.21 s of equal values at the earliest: a warning that is due sooner has to wait"},
        {FaultKind::offset, FaultPlace::lateral_acceleration, -1,
         "to every other sensor 2 m/s^2 less is a road's bank of 12 deg; and once a turn has begun, yaw rate "
         "and roll angle do not agree well enough to isolate a larger one in time"},
        {FaultKind::offset, FaultPlace::vertical_acceleration, 1,
         "found after 0.6 s: until then a body that its road pushes up"},
        {FaultKind::drift, FaultPlace::lateral_acceleration, -1, "as its offset, and smaller"},
        {FaultKind::drift, FaultPlace::vertical_acceleration, 1,
         "found after 1.1 s to 1.5 s: until then as its offset"},
        {FaultKind::offset, FaultPlace::yaw_rate, -1,
         "5 m/s^2 too little at 100 km/h, below the 7 of a spin: the forecast looks less far ahead"},
        {FaultKind::sign_flip, FaultPlace::yaw_rate, 0,
         "found after 1.2 s alone of its sign: until then the forecast looks less far ahead"},
        {FaultKind::offset, FaultPlace::steering_wheel_angle, 0,
         "nothing else says where the driver steers: the prediction loses the lead that it had by him"},
        {FaultKind::sign_flip, FaultPlace::steering_wheel_angle, 0, "as its offset"},
        {FaultKind::delayed, FaultPlace::vehicle_motion_frame, 0, "only the silence at its beginning shows"},
    };
    return all;
}

const std::vector<KnownUndetected>& undetected_in_states() {
    static const std::vector<KnownUndetected> all{
        {FaultKind::offset, FaultPlace::vehicle_mass, 0,
         "from the start, or at a stop, it may be a load: used as far as driving shows that"},
        {FaultKind::drift, FaultPlace::vehicle_mass, 0, "at a stop it may be a load"},
        {FaultKind::noise, FaultPlace::vehicle_mass, 0, "at a stop it may be a load"},
        {FaultKind::not_available, FaultPlace::vehicle_mass, 0, "most vehicles do not know their mass"},
        {FaultKind::gain, FaultPlace::vehicle_mass, 0,
         "from the start it may be a load: used as far as driving shows that, and refuted after minutes"},
        {FaultKind::gain, FaultPlace::inertial_signals, 0,
         "a tenth is within what load, calibration and bank can do, and all three agree"},
        {FaultKind::gain, FaultPlace::motion_signals, 0,
         "slides and banks have as much between yaw rate times speed and the lateral acceleration"},
        {FaultKind::gain, FaultPlace::all_signals, 0,
         "all agree, but for gravity in the vertical acceleration"},
        {FaultKind::gain, FaultPlace::roll_rate, 0,
         "open: no check compares the gains of roll rate and roll angle"},
        {FaultKind::gain, FaultPlace::yaw_rate, 0,
         "open: without speed, yaw rate or the right steering angle nothing bounds the trend, and the "
         "forecast takes the force for them"},
        {FaultKind::noise_alone, FaultPlace::yaw_rate, 0,
         "open: it makes another acceleration at the CG for a moment, and the warning is held for 1 s"},
        {FaultKind::turned_about_x, FaultPlace::inertial_signals, 0,
         "6 deg are 1 m/s^2 of gravity, a road's bank to every other sensor; minutes of driving show it "
         "(offsets that last)"},
    };
    return all;
}

bool is_known_undetected(const Fault& fault) {
    const std::vector<KnownUndetected>& all = known_undetected_errors();
    return std::any_of(all.begin(), all.end(), [&fault](const KnownUndetected& each) {
        return each.kind == fault.kind && each.place == fault.place &&
               (each.sign == 0 || each.sign * fault.magnitude > 0.0);
    });
}

Fault in_turn_to_the_other_side(const Fault& fault) {
    const bool has_side =
        fault.place != FaultPlace::vertical_acceleration && fault.place != FaultPlace::speed;
    return {fault.kind, fault.place, has_side ? -fault.magnitude : fault.magnitude};
}

}  // namespace sil
