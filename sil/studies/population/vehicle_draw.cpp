// Vehicle draw: draft after draft until one is plausible.
#include "sil/studies/population/vehicle_draw.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "sil/studies/population/random_quantities.hpp"
#include "sil/studies/population/vehicle_draft.hpp"

namespace sil {
namespace {

constexpr unsigned most_attempts = 200U;

std::string slug(std::string name) {
    for (char& letter : name) {
        letter =
            letter == ' ' ? '-' : static_cast<char>(letter >= 'A' && letter <= 'Z' ? letter + 32 : letter);
    }
    return name;
}

VehicleDraft drafted(const VehicleClass& from, const RandomQuantities& random) {
    VehicleDraft draft{from, random};
    draw_axles_and_masses(draft);
    draw_geometry(draft);
    draw_inertias(draft);
    draw_tyre_stiffness(draft);
    draw_suspension(draft);
    draw_tyre_forces(draft);
    draw_equipment(draft);
    draw_grip(draft);
    return draft;
}

std::string outside(const char* what, double value, double lowest, double highest) {
    return value >= lowest && value <= highest
               ? std::string{}
               : fmt::format("{} {:.3g}, plausible are {:.3g} to {:.3g}", what, value, lowest, highest);
}

}  // namespace

std::string implausible(const VehicleParameters& v, const VehicleClass& from) {
    const VehicleProperties p = properties(v);
    const VehicleProperties with_load = properties(loaded(v, from.load));
    // Manoeuvres take their handwheel angles from a ramp that must reach 0.3 g (slowly_increasing_steer.hpp).
    constexpr double lowest_threshold_g = 0.42;
    constexpr double lowest_grip_g = 0.57;  // 0.4 g with 0.7 of the friction, the least that campaigns draw
    for (const std::string& reason :
         {outside("static stability factor", p.static_stability_factor,
                  from.static_stability_factor.lowest - 1e-9, from.static_stability_factor.highest + 1e-9),
          outside("height of the CG over that of the body",
                  p.cg_height_m / (v.hull.top_above_cg_m + v.geometry.cg_height_m), 0.25, 0.60),
          outside("roll arm in m", p.roll_arm_m, 0.15, 2.0),
          outside("roll frequency in Hz", p.roll_frequency_hz, 0.6, 2.7),
          outside("roll frequency in Hz, laden", with_load.roll_frequency_hz, 0.4, 2.7),
          outside("roll damping ratio", p.roll_damping_ratio, 0.018, 0.80),
          outside("roll gradient in deg/g", p.roll_gradient_degpg, 0.8, 16.0),
          outside("roll gradient in deg/g, laden", with_load.roll_gradient_degpg, 0.8, 22.0),
          outside("rollover threshold in g", p.threshold_g, lowest_threshold_g, 2.0),
          outside("rollover threshold in g, laden", with_load.threshold_g, lowest_threshold_g, 2.0),
          outside("grip in g", p.grip, lowest_grip_g, 2.0),
          outside("understeer gradient in s2/m", p.understeer_gradient_s2pm,
                  from.understeer_gradient_s2pm.lowest, from.understeer_gradient_s2pm.highest),
          outside("rear pivot in m", v.rear_suspension.panhard_pivot_m, -0.5, 0.5)}) {
        if (!reason.empty()) {
            return reason;
        }
    }
    return {};
}

DrawnVehicle draw_vehicle(std::uint64_t seed, std::uint64_t number) {
    const std::vector<VehicleClass>& classes = vehicle_classes();
    DrawnVehicle drawn;
    drawn.number = number;
    drawn.in_class = static_cast<std::size_t>(number % classes.size());
    drawn.half = number / classes.size() % 2U == 0U ? PopulationHalf::choose : PopulationHalf::report;
    const VehicleClass& from = classes[drawn.in_class];
    drawn.name = fmt::format("{}-{:04}", slug(from.name), number);
    std::string reason;
    for (drawn.attempt = 0U; drawn.attempt < most_attempts; ++drawn.attempt) {
        const RandomQuantities random{seed, number, drawn.attempt};
        const VehicleDraft draft = drafted(from, random);
        drawn.rigid_front = draft.rigid_front;
        drawn.rigid_rear = draft.rigid_rear;
        drawn.parameters = draft.vehicle;
        drawn.parameters.name = drawn.name;
        reason = implausible(drawn.parameters, from);
        if (reason.empty()) {
            drawn.properties = properties(drawn.parameters);
            return drawn;
        }
    }
    throw std::runtime_error(fmt::format("no plausible {} in {} draws (vehicle {}): {}", from.name,
                                         most_attempts, number, reason));
}

const char* half_name(PopulationHalf half) {
    return half == PopulationHalf::choose ? "choose" : "report";
}

}  // namespace sil
