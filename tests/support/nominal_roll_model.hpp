// The paper's roll-plane model of each simulated vehicle, which the tests compare its behaviour with.
#pragma once

#include <stdexcept>
#include <string>

namespace rsi_test {

// The stiffness curve, K(phi) = stiffness_0 + stiffness_2 phi^2 + stiffness_4 phi^4 (the moment is K phi),
// comes from a ramp steer of 3 deg/s at the handwheel at 60 km/h.
struct NominalRollModel {
    double roll_centre_height_m;  // h_frc
    double stiffness_nmprad;      // K_f
    double damping_nmsprad;       // c_f
    double stiffness_0_nmprad;
    double stiffness_2_nmprad3;
    double stiffness_4_nmprad5;
};

// By the name that its file in sil/vehicles gives.
inline NominalRollModel nominal_roll_model(const std::string& name) {
    if (name == "large SUV") {
        return {0.281, 96.0e3, 8000.0, 94.8e3, 4.22e3, 5.46e7};
    }
    if (name == "ordinary SUV") {
        return {0.185, 75.5e3, 3500.0, 76.7e3, -4.36e5, 2.20e7};
    }
    if (name == "van") {
        // Height from the geometry of both axles at rest, damping from a step there and back.
        return {0.22, 100.2e3, 3500.0, 100.8e3, -3.57e5, 3.72e7};
    }
    throw std::invalid_argument{"no nominal roll model of " + name};
}

}  // namespace rsi_test
