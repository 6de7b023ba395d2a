// Draw: what one run of a campaign is, drawn from the settings by seed and run number alone.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "sil/studies/campaign/settings.hpp"

namespace sil {

// The errors are shares of the true value of that run: the firmware gets true * (1 + error).
struct RunDraw {
    std::uint64_t number{0U};
    std::size_t vehicle{0U};    // index into the settings
    std::size_t manoeuvre{0U};  // index into the settings
    bool mirrored{false};
    double speed_factor{1.0};
    double steering_factor{1.0};
    double handwheel_rate_degps{0.0};  // 0: the manoeuvre's own; not in a row of runs.csv
    double friction_factor{1.0};
    double load_share{0.0};          // of the sprung mass
    double load_height_factor{1.0};  // of the height of the sprung CG
    double cg_height_error{0.0};
    double stiffness_error{0.0};
    double mass_error{0.0};
    double mass_sensor_error{0.0};
    double lateral_bias_g{0.0};
    double vertical_bias_g{0.0};
    // The inertial sensors' housing, about and along x, y and z; not in a row of runs.csv.
    std::array<double, 3> housing_tilt_deg{};
    std::array<double, 3> lever_arm_error_m{};
    std::uint64_t sensor_seed{1U};
};

// Every quantity has a random number of its own, so that none depends on how many others were drawn, on the
// other runs, or on the thread. `settings` must have passed check_campaign.
RunDraw draw_run(const CampaignSettings& settings, std::uint64_t number);

}  // namespace sil
