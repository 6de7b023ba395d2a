// Prints what in the paper's Fig. 2 makes the vehicle roll over, as CSV: the manoeuvre of roll-centre-moving
// with a roll centre that moves or not and a suspension as it is, without its stops, or linear.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <string>
#include <utility>

#include "sil/files/standard_streams.hpp"
#include "sil/units.hpp"
#include "sil/world/manoeuvres/catalogue.hpp"
#include "sil/world/manoeuvres/manoeuvre_run.hpp"
#include "sil/world/manoeuvres/roll_centre_comparison.hpp"
#include "sil/world/vehicle/parameter_file.hpp"

namespace {

constexpr double lies_on_its_side_rad = 1.2;

// Up to the end of the manoeuvre, or the vehicle's side.
double largest_roll_deg(const sil::VehicleParameters& vehicle, double speed_kmh) {
    sil::Manoeuvre manoeuvre = sil::find_manoeuvre("roll-centre-moving");
    manoeuvre.initial_speed_mps = sil::from_kmh(speed_kmh);
    sil::ManoeuvreRun run{vehicle, manoeuvre};
    double largest_rad = 0.0;
    while (!run.finished() && largest_rad < lies_on_its_side_rad) {
        run.step();
        largest_rad = std::max(largest_rad, std::abs(run.truth().roll_angle_rad));
    }
    return largest_rad * sil::degrees_per_radian;
}

sil::VehicleParameters without_stops(sil::VehicleParameters parameters) {
    for (sil::SpringDamperParameters* unit :
         {&parameters.front_suspension.spring_damper, &parameters.rear_suspension.spring_damper}) {
        unit->jounce_stop_npm2 = 0.0;
        unit->rebound_stop_npm2 = 0.0;
    }
    return parameters;
}

void print_row(const sil::VehicleParameters& vehicle, double speed_kmh, const char* roll_centre,
               const char* suspension) {
    fmt::print("{},{},{},{:.3f}\n", speed_kmh, roll_centre, suspension, largest_roll_deg(vehicle, speed_kmh));
}

void print(const std::string& vehicle_file) {
    const sil::VehicleParameters moving = sil::load_vehicle(vehicle_file);
    const sil::VehicleParameters fixed = sil::with_fixed_roll_centre(moving);
    fmt::print("speed_kmh,roll_centre,suspension,largest_roll_deg\n");
    for (const double speed_kmh : {60.0, 64.0, 68.0, 72.0, 76.0}) {
        for (const auto& [vehicle, name] : {std::pair{moving, "moving"}, std::pair{fixed, "fixed"}}) {
            print_row(vehicle, speed_kmh, name, "as it is");
            print_row(without_stops(vehicle), speed_kmh, name, "without stops");
            print_row(sil::with_linear_suspension(vehicle), speed_kmh, name, "linear");
        }
    }
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        fmt::print(stderr, "usage: roll_centre_ablation VEHICLE_FILE\n");
        return 2;
    }
    try {
        print(argv[1]);
        return sil::finish_output("roll_centre_ablation");
    } catch (const std::exception& error) {
        fmt::print(stderr, "roll_centre_ablation: {}\n", error.what());
        return 1;
    }
}
