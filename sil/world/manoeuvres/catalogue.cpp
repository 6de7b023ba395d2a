// Catalogue: a new manoeuvre is one file and one line in each of the two lists here.
#include "sil/world/manoeuvres/catalogue.hpp"

#include <algorithm>

#include "sil/world/manoeuvres/slow_ramp.hpp"

namespace sil {

Manoeuvre j_turn_110();
Manoeuvre j_turn_45();
Manoeuvre j_turn_banked();
Manoeuvre fishhook_1a();
Manoeuvre fishhook_1b();
Manoeuvre roll_centre_moving();
Manoeuvre roll_centre_fixed();
Manoeuvre slowly_increasing_steer();
Manoeuvre double_lane_change();
Manoeuvre sine_with_dwell();
Manoeuvre slalom();
Manoeuvre step_steer();
Manoeuvre braking_in_turn();
Manoeuvre rough_turn();
Manoeuvre rough_road();
Manoeuvre banked_straight();
Manoeuvre one_sided_bump();
Manoeuvre decreasing_radius();
Manoeuvre crowned_road();
Manoeuvre split_friction();
Manoeuvre gust();
Manoeuvre tyre_failure();
Manoeuvre sloshing_load();
Manoeuvre sliding_load();
Manoeuvre trailer();
Manoeuvre kerb_trip();
Manoeuvre soil_trip();
Manoeuvre straight();

std::vector<Manoeuvre> all_manoeuvres() {
    return {
        j_turn_110(),
        j_turn_45(),
        j_turn_banked(),
        fishhook_1a(),
        fishhook_1b(),
        roll_centre_moving(),
        roll_centre_fixed(),
        slowly_increasing_steer(),
        double_lane_change(),
        sine_with_dwell(),
        slalom(),
        slow_ramp(),
        step_steer(),
        braking_in_turn(),
        rough_turn(),
        rough_road(),
        banked_straight(),
        one_sided_bump(),
        straight(),
        decreasing_radius(),
        crowned_road(),
        split_friction(),
        gust(),
        tyre_failure(),
        sloshing_load(),
        sliding_load(),
        trailer(),
        kerb_trip(),
        soil_trip(),
    };
}

std::vector<Manoeuvre> undisturbed_manoeuvres() {
    std::vector<Manoeuvre> manoeuvres = all_manoeuvres();
    manoeuvres.erase(std::remove_if(manoeuvres.begin(), manoeuvres.end(),
                                    [](const Manoeuvre& manoeuvre) { return manoeuvre.is_disturbed; }),
                     manoeuvres.end());
    return manoeuvres;
}

Manoeuvre find_manoeuvre(std::string_view name) {
    std::string known;
    for (Manoeuvre& manoeuvre : all_manoeuvres()) {
        if (manoeuvre.name == name) {
            return manoeuvre;
        }
        known += (known.empty() ? "" : ", ") + manoeuvre.name;
    }
    throw UnknownManoeuvre("There is no manoeuvre '" + std::string{name} + "'. Choose one of: " + known +
                           ".");
}

}  // namespace sil
