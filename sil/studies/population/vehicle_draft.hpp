// Vehicle draft: a vehicle while it is drawn, part after part, from the large (masses) to what needs them.
#pragma once

#include "sil/studies/population/random_quantities.hpp"
#include "sil/studies/population/vehicle_class.hpp"
#include "sil/units.hpp"
#include "sil/world/vehicle/parameters.hpp"

namespace sil {

struct VehicleDraft {
    const VehicleClass& from;
    const RandomQuantities& random;
    VehicleParameters vehicle{};
    bool rigid_front{false};
    bool rigid_rear{false};
    double mass_kg{0.0};
    double front_share{0.5};
    double wheelbase_m{0.0};

    double within(Quantity quantity, Interval VehicleClass::* range) const {
        return random.within(quantity, from.*range);
    }
    double sized(Quantity quantity, Interval VehicleClass::* range) const {
        return random.sized(quantity, from.*range);
    }

    // Values of one wheel.
    double front_sprung_kg() const { return 0.5 * front_share * vehicle.mass.sprung_kg; }
    double rear_sprung_kg() const { return 0.5 * (1.0 - front_share) * vehicle.mass.sprung_kg; }
    double front_wheel_n() const { return g_mps2 * (front_sprung_kg() + vehicle.mass.front_unsprung_kg); }
    double rear_wheel_n() const { return g_mps2 * (rear_sprung_kg() + 0.5 * vehicle.mass.rear_axle_kg); }
};

// Each part needs those before it.
void draw_axles_and_masses(VehicleDraft& draft);
void draw_geometry(VehicleDraft& draft);
void draw_inertias(VehicleDraft& draft);
void draw_tyre_stiffness(VehicleDraft& draft);
void draw_suspension(VehicleDraft& draft);
void draw_tyre_forces(VehicleDraft& draft);
void draw_equipment(VehicleDraft& draft);
void draw_grip(VehicleDraft& draft);  // by the threshold of all the rest

}  // namespace sil
