// Vehicle draw: the same vehicle for the same seed and number, within its class, plausible, and hanging
// together.
#include "sil/studies/population/vehicle_draw.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <vector>

#include "sil/studies/population/vehicle_writer.hpp"

namespace vehicle_draw_test {
namespace {

using Take = std::function<double(const sil::DrawnVehicle&)>;

const std::vector<sil::DrawnVehicle>& population() {
    static const std::vector<sil::DrawnVehicle> drawn = [] {
        std::vector<sil::DrawnVehicle> vehicles;
        for (std::uint64_t number = 0U; number < 900U; ++number) {
            vehicles.push_back(sil::draw_vehicle(1U, number));
        }
        return vehicles;
    }();
    return drawn;
}

std::vector<sil::DrawnVehicle> of_class(std::size_t index) {
    std::vector<sil::DrawnVehicle> vehicles;
    for (const sil::DrawnVehicle& vehicle : population()) {
        if (vehicle.in_class == index) {
            vehicles.push_back(vehicle);
        }
    }
    return vehicles;
}

double correlation(const std::vector<sil::DrawnVehicle>& vehicles, const Take& x, const Take& y) {
    double sx = 0.0, sy = 0.0, sxx = 0.0, syy = 0.0, sxy = 0.0;
    const auto n = static_cast<double>(vehicles.size());
    for (const sil::DrawnVehicle& vehicle : vehicles) {
        sx += x(vehicle);
        sy += y(vehicle);
        sxx += x(vehicle) * x(vehicle);
        syy += y(vehicle) * y(vehicle);
        sxy += x(vehicle) * y(vehicle);
    }
    return (sxy - sx * sy / n) / std::sqrt((sxx - sx * sx / n) * (syy - sy * sy / n));
}

double mass_kg(const sil::DrawnVehicle& vehicle) {
    return sil::total_mass_kg(vehicle.parameters);
}

double wheelbase_m(const sil::DrawnVehicle& vehicle) {
    return vehicle.parameters.geometry.front_axle_to_cg_m + vehicle.parameters.geometry.rear_axle_to_cg_m;
}

TEST(VehicleDraw, ASeedAndANumberGiveTheSameVehicleAgainAndOthersAnother) {
    std::set<std::string> texts;
    std::set<std::string> names;
    for (const sil::DrawnVehicle& vehicle : population()) {
        const sil::DrawnVehicle again = sil::draw_vehicle(1U, vehicle.number);
        EXPECT_EQ(sil::vehicle_toml(again.parameters, ""), sil::vehicle_toml(vehicle.parameters, ""));
        EXPECT_EQ(again.name, vehicle.name);
        texts.insert(sil::vehicle_toml(vehicle.parameters, "").substr(20U));
        names.insert(vehicle.name);
    }
    EXPECT_EQ(texts.size(), population().size());
    EXPECT_EQ(names.size(), population().size());
    EXPECT_NE(sil::draw_vehicle(2U, 0U).parameters.mass.sprung_kg,
              sil::draw_vehicle(1U, 0U).parameters.mass.sprung_kg);
}

TEST(VehicleDraw, ClassesAndHalvesAreOfOneSize) {
    std::map<std::pair<std::size_t, sil::PopulationHalf>, int> counts;
    for (const sil::DrawnVehicle& vehicle : population()) {
        ++counts[{vehicle.in_class, vehicle.half}];
    }
    EXPECT_EQ(counts.size(), 2U * sil::vehicle_classes().size());
    for (const auto& [key, count] : counts) {
        EXPECT_EQ(count, 50);
    }
}

TEST(VehicleDraw, DimensionsLieBetweenTheEndsOfTheClassAndReachNearThem) {
    struct Quantity {
        const char* name;
        sil::Interval sil::VehicleClass::* range;
        Take take;
    };
    const Quantity quantities[] = {
        {"mass", &sil::VehicleClass::mass_kg, mass_kg},
        {"wheelbase", &sil::VehicleClass::wheelbase_m, wheelbase_m},
        {"track", &sil::VehicleClass::track_width_m,
         [](const auto& v) { return v.parameters.geometry.track_width_m; }},
        {"SSF", &sil::VehicleClass::static_stability_factor,
         [](const auto& v) { return v.properties.static_stability_factor; }},
        {"steering ratio", &sil::VehicleClass::steering_ratio,
         [](const auto& v) { return v.parameters.steering.ratio; }},
        {"steering lag", &sil::VehicleClass::steering_lag_s,
         [](const auto& v) { return v.parameters.steering.lag_s; }},
        {"relaxation length", &sil::VehicleClass::relaxation_length_m,
         [](const auto& v) { return v.parameters.tyre.relaxation_length_m; }},
        {"IMU height", &sil::VehicleClass::imu_height_m,
         [](const auto& v) { return v.parameters.imu_mount.z_m + v.parameters.geometry.cg_height_m; }},
        {"understeer", &sil::VehicleClass::understeer_gradient_s2pm,
         [](const auto& v) { return v.properties.understeer_gradient_s2pm; }},
    };
    for (std::size_t index = 0U; index < sil::vehicle_classes().size(); ++index) {
        const sil::VehicleClass& from = sil::vehicle_classes()[index];
        for (const Quantity& quantity : quantities) {
            const sil::Interval& range = from.*quantity.range;
            const double rounding = 1e-9 * range.highest;
            double lowest = range.highest;
            double highest = range.lowest;
            for (const sil::DrawnVehicle& vehicle : of_class(index)) {
                const double value = quantity.take(vehicle);
                EXPECT_GE(value, range.lowest - rounding) << vehicle.name << " " << quantity.name;
                EXPECT_LE(value, range.highest + rounding) << vehicle.name << " " << quantity.name;
                lowest = std::min(lowest, value);
                highest = std::max(highest, value);
            }
            EXPECT_GT(highest - lowest, 0.3 * (range.highest - range.lowest))
                << from.name << " " << quantity.name;
        }
    }
}

TEST(VehicleDraw, SpringsAndFramesAreThoseOfTheClass) {
    for (std::size_t index = 0U; index < sil::vehicle_classes().size(); ++index) {
        const sil::VehicleClass& from = sil::vehicle_classes()[index];
        const std::vector<sil::DrawnVehicle> vehicles = of_class(index);
        int leaves = 0, twist = 0, rigid = 0;
        double most_progressive = 0.0;
        for (const sil::DrawnVehicle& vehicle : vehicles) {
            const sil::RearSuspensionParameters& rear = vehicle.parameters.rear_suspension;
            const sil::SpringDamperParameters& front = vehicle.parameters.front_suspension.spring_damper;
            const double progression = rear.spring_damper.progression_pm2 * 0.08 * 0.08;
            EXPECT_GE(progression, from.spring_progression.lowest) << vehicle.name;
            EXPECT_LE(progression, from.spring_progression.highest) << vehicle.name;
            EXPECT_EQ(front.progression_pm2, rear.spring_damper.progression_pm2) << vehicle.name;
            most_progressive = std::max(most_progressive, progression);
            const double friction = rear.spring_damper.dry_friction;
            rigid += vehicle.rigid_rear ? 1 : 0;
            leaves += friction > 0.0 ? 1 : 0;
            EXPECT_TRUE(friction == 0.0 || (vehicle.rigid_rear && friction >= from.leaf_friction.lowest &&
                                            friction <= from.leaf_friction.highest))
                << vehicle.name;
            EXPECT_EQ(front.dry_friction, vehicle.rigid_front ? friction : 0.0) << vehicle.name;
            twist += rear.frame_torsion_nmprad > 0.0 ? 1 : 0;
            if (rear.frame_torsion_nmprad > 0.0) {
                const double share = rear.frame_torsion_nmprad / vehicle.properties.roll_stiffness_nmprad;
                EXPECT_GE(share, from.frame_over_roll_stiffness.lowest - 1e-9) << vehicle.name;
                EXPECT_LE(share, from.frame_over_roll_stiffness.highest + 1e-9) << vehicle.name;
                EXPECT_GE(rear.frame_rear_share, from.frame_rear_share.lowest) << vehicle.name;
                EXPECT_LE(rear.frame_rear_share, from.frame_rear_share.highest) << vehicle.name;
            }
        }
        const auto share_of = [&](int count, int all) {
            return static_cast<double>(count) / std::max(1, all);
        };
        EXPECT_GT(most_progressive, 0.9 * from.spring_progression.highest) << from.name;
        EXPECT_NEAR(share_of(leaves, rigid), from.leaf_spring_share.lowest, 0.17) << from.name;
        EXPECT_NEAR(share_of(twist, static_cast<int>(vehicles.size())), from.twisting_frame_share.lowest,
                    0.15)
            << from.name;
    }
}

TEST(VehicleDraw, TheWholeReachesBeyondOthersVehicles) {
    sil::VehicleProperties least = population().front().properties;
    double most_grip = 0.0;
    for (const sil::DrawnVehicle& vehicle : population()) {
        const sil::VehicleProperties& p = vehicle.properties;
        least.threshold_g = std::min(least.threshold_g, p.threshold_g);
        least.roll_frequency_hz = std::min(least.roll_frequency_hz, p.roll_frequency_hz);
        least.roll_damping_ratio = std::min(least.roll_damping_ratio, p.roll_damping_ratio);
        most_grip = std::max(most_grip, p.grip / p.threshold_g);
    }
    EXPECT_LT(least.threshold_g, 0.55);
    EXPECT_LT(least.roll_frequency_hz, 0.75);
    EXPECT_LT(least.roll_damping_ratio, 0.0235);
    EXPECT_GT(most_grip, 1.9);
}

TEST(VehicleDraw, TheWholeCoversWhatWasAskedFor) {
    double lightest = 1e9, heaviest = 0.0, lowest_centre = 1.0, highest_centre = 0.0;
    int rigid = 0, can_lift = 0;
    for (const sil::DrawnVehicle& vehicle : population()) {
        lightest = std::min(lightest, mass_kg(vehicle));
        heaviest = std::max(heaviest, mass_kg(vehicle));
        // Values of the axles: that of the whole vehicle lies between them.
        const sil::VehicleParameters& v = vehicle.parameters;
        const double front = v.front_suspension.path_slope_0 * 0.5 * v.geometry.track_width_m;
        const double rear = v.geometry.wheel_radius_m + v.rear_suspension.panhard_pivot_m;
        lowest_centre = std::min(lowest_centre, front);
        highest_centre = std::max(highest_centre, rear);
        rigid += vehicle.rigid_rear ? 1 : 0;
        can_lift += vehicle.properties.grip > vehicle.properties.threshold_g ? 1 : 0;
    }
    EXPECT_LT(lightest, 600.0);
    EXPECT_GE(lightest, 450.0);
    EXPECT_GT(heaviest, 18000.0);
    EXPECT_LE(heaviest, 20000.0);
    EXPECT_LT(lowest_centre, 0.02);
    EXPECT_GT(highest_centre, 0.85);
    EXPECT_GT(rigid, 400);
    EXPECT_LT(rigid, 700);
    // Many, but not all, find the grip that it takes to lift two wheels.
    EXPECT_GT(can_lift, 700);
    EXPECT_LT(can_lift, 850);
}

TEST(VehicleDraw, LargeVehiclesOfAClassAreHeavyAndLong) {
    for (std::size_t index = 0U; index < sil::vehicle_classes().size(); ++index) {
        const std::vector<sil::DrawnVehicle> vehicles = of_class(index);
        EXPECT_GT(correlation(vehicles, mass_kg, wheelbase_m), 0.5);
        EXPECT_GT(correlation(vehicles, mass_kg,
                              [](const auto& v) { return v.parameters.inertia.sprung_roll_kgm2; }),
                  0.5);
        EXPECT_LT(std::abs(correlation(vehicles, mass_kg,
                                       [](const auto& v) { return v.parameters.steering.ratio; })),
                  0.35)
            << "what has nothing to do with size does not follow it";
    }
}

TEST(VehicleDraw, EveryVehicleIsPlausibleAndFewDrawsWereNot) {
    unsigned refused = 0U;
    for (const sil::DrawnVehicle& vehicle : population()) {
        EXPECT_EQ(sil::implausible(vehicle.parameters, sil::vehicle_classes()[vehicle.in_class]), "")
            << vehicle.name;
        refused += vehicle.attempt;
    }
    EXPECT_GT(refused, 0U);
    EXPECT_LT(refused, population().size());
}

TEST(VehicleDraw, ImplausibleValuesAreReported) {
    const sil::DrawnVehicle drawn = population().front();
    const sil::VehicleClass& from = sil::vehicle_classes()[drawn.in_class];
    const auto reason = [&](const std::function<void(sil::VehicleParameters&)>& change) {
        sil::VehicleParameters vehicle = drawn.parameters;
        change(vehicle);
        return sil::implausible(vehicle, from);
    };
    EXPECT_EQ(reason([](auto&) {}), "");
    EXPECT_NE(reason([](auto& v) { v.geometry.cg_height_m *= 1.4; }).find("static stability"),
              std::string::npos);
    EXPECT_NE(reason([](auto& v) { v.inertia.sprung_roll_kgm2 *= 12.0; }).find("roll frequency"),
              std::string::npos);
    EXPECT_NE(reason([](auto& v) {
                  v.front_suspension.spring_damper.damper_bump_nspm = 0.0;
                  v.front_suspension.spring_damper.damper_rebound_nspm = 0.0;
                  v.rear_suspension.spring_damper.damper_bump_nspm = 0.0;
                  v.rear_suspension.spring_damper.damper_rebound_nspm = 0.0;
              }).find("damping"),
              std::string::npos);
    EXPECT_NE(reason([](auto& v) { v.steering.compliance_radpn = 1.0e-4; }).find("understeer"),
              std::string::npos);
    EXPECT_NE(reason([](auto& v) {
                  v.front_suspension.anti_roll_bar_npm = 0.0;
                  v.front_suspension.spring_damper.spring_npm = 1000.0;
                  v.rear_suspension.anti_roll_bar_nmprad = 0.0;
                  v.rear_suspension.spring_damper.spring_npm = 1000.0;
              }).find("nan"),
              std::string::npos)
        << "a body that its springs do not hold up has no frequency";
}

}  // namespace
}  // namespace vehicle_draw_test
