// Vehicle draw: quantities between the ends of the class, and the parameters that follow from them.
#include "sil/studies/population/vehicle_draw.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "sil/random.hpp"
#include "sil/units.hpp"

namespace sil {
namespace {

constexpr unsigned most_attempts = 200U;
// How much of a dimension goes with the vehicle's size; the rest is its own.
constexpr double size_part = 0.7;
// The shares of the stops' and the wheels' rule of thumb values.
constexpr double rotor_mass_share = 0.35;    // of a wheel's unsprung mass, at its rim
constexpr double axle_gyration_share = 0.9;  // of half the track: the masses are at the ends

// The numbers are part of the reproducible result: never change one, only add.
enum class Quantity : std::uint64_t {
    size = 1,
    mass = 2,
    wheelbase = 3,
    track = 4,
    static_stability_factor = 5,
    front_load = 6,
    unsprung = 7,
    wheel_radius = 8,
    roll_gyration = 9,
    pitch_gyration = 10,
    yaw_gyration = 11,
    rigid_front = 12,
    rigid_rear = 13,
    front_roll_centre = 14,
    rear_roll_centre = 15,
    front_frequency = 16,
    rear_frequency = 17,
    spring_base = 18,
    roll_gradient = 19,
    front_stiffness_share = 20,
    bump_damping = 21,
    rebound_damping = 22,
    early_front_stop = 23,
    early_rear_stop = 24,
    front_jounce_clearance = 25,
    front_rebound_clearance = 26,
    rear_jounce_clearance = 27,
    rear_rebound_clearance = 28,
    front_stop = 29,
    rear_stop = 30,
    tyre_deflection = 31,
    cornering = 32,
    cornering_peak = 33,
    relaxation = 34,
    camber_thrust = 35,
    grip = 36,
    friction_loss = 37,
    front_friction = 38,
    rear_friction = 39,
    shape = 40,
    curvature = 41,
    slip_stiffness = 42,
    rolling_resistance = 43,
    steering_ratio = 44,
    steering_lag = 45,
    imu_height = 46,
    imu_forward = 47,
    imu_left = 48,
    body_height = 49,
    length = 50,
    drag_area = 51,
    front_drive = 52,
    path_change = 53,
    camber_gain = 54,
    damper_base = 55,
    panhard_length = 56,
};

class RandomNumbers {
 public:
    RandomNumbers(std::uint64_t seed, std::uint64_t vehicle, unsigned attempt)
        : key_{scrambled(scrambled(scrambled(seed) ^ vehicle) ^ attempt)} {}

    double unit(Quantity quantity) const {
        return unit_interval(scrambled(key_ ^ scrambled(static_cast<std::uint64_t>(quantity))));
    }
    double within(Quantity quantity, const Interval& interval) const {
        return interval.lowest + unit(quantity) * (interval.highest - interval.lowest);
    }
    // A dimension that large vehicles of the class have more of.
    double sized(Quantity quantity, const Interval& interval) const {
        const double part = size_part * unit(Quantity::size) + (1.0 - size_part) * unit(quantity);
        return interval.lowest + part * (interval.highest - interval.lowest);
    }
    bool happens(Quantity quantity, const Interval& share) const { return unit(quantity) < share.lowest; }

 private:
    std::uint64_t key_;
};

std::string slug(std::string name) {
    for (char& letter : name) {
        letter =
            letter == ' ' ? '-' : static_cast<char>(letter >= 'A' && letter <= 'Z' ? letter + 32 : letter);
    }
    return name;
}

// The parameters one after the other, from the large (masses) to what needs them.
class Builder {
 public:
    Builder(const VehicleClass& from, const RandomNumbers& random) : from_{from}, random_{random} {}

    VehicleParameters build(bool& rigid_front, bool& rigid_rear) {
        rigid_front = rigid_front_ = random_.happens(Quantity::rigid_front, from_.rigid_front_share);
        rigid_rear = rigid_rear_ = random_.happens(Quantity::rigid_rear, from_.rigid_rear_share);
        masses();
        geometry();
        inertias();
        tyre_stiffness();
        roll_centres();
        springs();
        dampers();
        stops();
        tyre_forces();
        the_rest();
        grip();
        return v_;
    }

 private:
    double within(Quantity quantity, Interval VehicleClass::* range) const {
        return random_.within(quantity, from_.*range);
    }
    double sized(Quantity quantity, Interval VehicleClass::* range) const {
        return random_.sized(quantity, from_.*range);
    }

    void masses() {
        mass_ = sized(Quantity::mass, &VehicleClass::mass_kg);
        const double unsprung = mass_ * within(Quantity::unsprung, &VehicleClass::unsprung_share);
        // A rigid axle carries its own beam, and a driven one its gear.
        const double rear_share = rigid_rear_ && !rigid_front_ ? 0.58 : 0.52;
        v_.mass.front_unsprung_kg = 0.5 * (1.0 - rear_share) * unsprung;
        v_.mass.rear_axle_kg = rear_share * unsprung;
        v_.mass.sprung_kg = mass_ - unsprung;
        front_share_ = within(Quantity::front_load, &VehicleClass::front_load_share);
    }

    void geometry() {
        GeometryParameters& g = v_.geometry;
        const double wheelbase = sized(Quantity::wheelbase, &VehicleClass::wheelbase_m);
        g.track_width_m = sized(Quantity::track, &VehicleClass::track_width_m);
        g.wheel_radius_m = sized(Quantity::wheel_radius, &VehicleClass::wheel_radius_m);
        g.front_axle_to_cg_m = (1.0 - front_share_) * wheelbase;
        g.rear_axle_to_cg_m = front_share_ * wheelbase;
        const double height =
            0.5 * g.track_width_m /
            within(Quantity::static_stability_factor, &VehicleClass::static_stability_factor);
        const double unsprung = mass_ - v_.mass.sprung_kg;
        g.cg_height_m = (mass_ * height - unsprung * g.wheel_radius_m) / v_.mass.sprung_kg;
        wheelbase_ = wheelbase;
    }

    void inertias() {
        const auto squared = [](double x) { return x * x; };
        const double track = v_.geometry.track_width_m;
        InertiaParameters& i = v_.inertia;
        i.sprung_roll_kgm2 =
            v_.mass.sprung_kg *
            squared(track * within(Quantity::roll_gyration, &VehicleClass::roll_gyration_of_track));
        i.sprung_pitch_kgm2 =
            v_.mass.sprung_kg * squared(wheelbase_ * within(Quantity::pitch_gyration,
                                                            &VehicleClass::pitch_gyration_of_wheelbase));
        i.sprung_yaw_kgm2 =
            v_.mass.sprung_kg *
            squared(wheelbase_ * within(Quantity::yaw_gyration, &VehicleClass::yaw_gyration_of_wheelbase));
        i.rear_axle_kgm2 = v_.mass.rear_axle_kg * squared(axle_gyration_share * 0.5 * track);
        i.wheel_spin_kgm2 =
            rotor_mass_share * v_.mass.front_unsprung_kg * squared(v_.geometry.wheel_radius_m);
    }

    double front_sprung_kg() const { return 0.5 * front_share_ * v_.mass.sprung_kg; }
    double rear_sprung_kg() const { return 0.5 * (1.0 - front_share_) * v_.mass.sprung_kg; }
    double front_wheel_n() const { return g_mps2 * (front_sprung_kg() + v_.mass.front_unsprung_kg); }
    double rear_wheel_n() const { return g_mps2 * (rear_sprung_kg() + 0.5 * v_.mass.rear_axle_kg); }

    void tyre_stiffness() {
        const double deflection = within(Quantity::tyre_deflection, &VehicleClass::tyre_deflection_m);
        v_.tyre.vertical_stiffness_npm = 0.25 * g_mps2 * mass_ / deflection;
        // A few per cent of critical, at the wheel's own frequency.
        v_.tyre.vertical_damping_nspm =
            0.06 * std::sqrt(v_.tyre.vertical_stiffness_npm * v_.mass.front_unsprung_kg);
    }

    void roll_centres() {
        FrontSuspensionParameters& front = v_.front_suspension;
        RearSuspensionParameters& rear = v_.rear_suspension;
        const double half_track = 0.5 * v_.geometry.track_width_m;
        const double front_height =
            within(Quantity::front_roll_centre, rigid_front_ ? &VehicleClass::rigid_front_roll_centre_m
                                                             : &VehicleClass::independent_roll_centre_m);
        const double rear_height =
            within(Quantity::rear_roll_centre, rigid_rear_ ? &VehicleClass::rigid_rear_roll_centre_m
                                                           : &VehicleClass::independent_roll_centre_m);
        front.path_slope_0 = front_height / half_track;
        // The roll centre of links sinks with the body; a rigid axle's stays, and neither side lifts the
        // body.
        front.path_slope_1_pm = random_.within(Quantity::path_change, {0.8, 2.5}) +
                                (rigid_front_ ? 4.0 * front.path_slope_0 : 0.0);
        front.path_slope_2_pm2 = 1.5;
        // A rigid axle keeps its wheels upright.
        front.camber_gain_radpm =
            rigid_front_ ? 1.0 / half_track : random_.within(Quantity::camber_gain, {0.0, 0.7});
        const double centre = v_.geometry.wheel_radius_m - rear_wheel_n() / v_.tyre.vertical_stiffness_npm;
        rear.panhard_pivot_m = rear_height - centre;
        rear.panhard_slope = 0.0;
        rear.panhard_length_m = rigid_rear_ ? random_.within(Quantity::panhard_length, {0.8, 1.6}) : 3.0;
    }

    void springs() {
        FrontSuspensionParameters& front = v_.front_suspension;
        RearSuspensionParameters& rear = v_.rear_suspension;
        const double track = v_.geometry.track_width_m;
        const double front_hz = within(Quantity::front_frequency, &VehicleClass::front_ride_frequency_hz);
        const double rear_hz =
            front_hz * within(Quantity::rear_frequency, &VehicleClass::rear_over_front_frequency);
        const auto rate = [](double hz, double kg) { return 4.0 * pi * pi * hz * hz * kg; };
        front.spring_damper.spring_npm = rate(front_hz, front_sprung_kg());
        rear.spring_damper.spring_npm = rate(rear_hz, rear_sprung_kg());
        const double base =
            rigid_rear_ ? within(Quantity::spring_base, &VehicleClass::rigid_spring_base_of_track) : 1.0;
        rear.spring_half_base_m = 0.5 * track * base;
        rear.damper_half_base_m =
            rear.spring_half_base_m * (rigid_rear_ ? random_.within(Quantity::damper_base, {0.9, 1.1}) : 1.0);
        // What the springs lack of the wanted stiffness, the anti-roll bars give.
        const double tipping_nm = v_.mass.sprung_kg * g_mps2 * properties(v_).roll_arm_m;
        const double gradient_radpg =
            within(Quantity::roll_gradient, &VehicleClass::roll_gradient_degpg) / degrees_per_radian;
        const double wanted = tipping_nm / gradient_radpg + tipping_nm;
        const double share =
            within(Quantity::front_stiffness_share, &VehicleClass::front_roll_stiffness_share);
        const double front_springs = 0.5 * track * track * front.spring_damper.spring_npm;
        const double rear_springs =
            2.0 * rear.spring_half_base_m * rear.spring_half_base_m * rear.spring_damper.spring_npm;
        front.anti_roll_bar_npm = std::max(0.0, share * wanted - front_springs) / (track * track);
        rear.anti_roll_bar_nmprad = std::max(0.0, (1.0 - share) * wanted - rear_springs);
    }

    void dampers() {
        const double ratio = within(Quantity::bump_damping, &VehicleClass::bump_damping_ratio);
        const double rebound = within(Quantity::rebound_damping, &VehicleClass::rebound_over_bump);
        const auto damp = [&](SpringDamperParameters& p, double kg) {
            p.damper_bump_nspm = 2.0 * ratio * std::sqrt(p.spring_npm * kg);
            p.damper_rebound_nspm = rebound * p.damper_bump_nspm;
        };
        damp(v_.front_suspension.spring_damper, front_sprung_kg());
        // Nearer to the middle they must be stronger to do the same in roll; designers go half the way.
        RearSuspensionParameters& rear = v_.rear_suspension;
        damp(rear.spring_damper, rear_sprung_kg());
        const double lever = 0.5 * v_.geometry.track_width_m / rear.damper_half_base_m;
        rear.spring_damper.damper_bump_nspm *= std::max(1.0, lever);
        rear.spring_damper.damper_rebound_nspm *= std::max(1.0, lever);
    }

    void stops() {
        const auto stop = [&](SpringDamperParameters& p, Quantity early, Quantity jounce, Quantity rebound,
                              Quantity rate) {
            const Interval& clearance =
                random_.happens(early, from_.early_stop_share) ? from_.early_clearance_m : from_.clearance_m;
            p.jounce_clearance_m = random_.within(jounce, clearance);
            p.rebound_clearance_m = random_.within(rebound, clearance);
            p.jounce_stop_npm2 = p.spring_npm * within(rate, &VehicleClass::stop_over_spring_pm);
            p.rebound_stop_npm2 = 0.7 * p.jounce_stop_npm2;
        };
        stop(v_.front_suspension.spring_damper, Quantity::early_front_stop, Quantity::front_jounce_clearance,
             Quantity::front_rebound_clearance, Quantity::front_stop);
        stop(v_.rear_suspension.spring_damper, Quantity::early_rear_stop, Quantity::rear_jounce_clearance,
             Quantity::rear_rebound_clearance, Quantity::rear_stop);
    }

    void tyre_forces() {
        TyreParameters& t = v_.tyre;
        const double static_n = 0.25 * g_mps2 * mass_;
        t.cornering_stiffness_load_n =
            std::max(front_wheel_n(), rear_wheel_n()) *
            within(Quantity::cornering_peak, &VehicleClass::cornering_peak_over_load);
        const double x = static_n / t.cornering_stiffness_load_n;
        t.cornering_stiffness_nprad = static_n *
                                      within(Quantity::cornering, &VehicleClass::cornering_per_load_prad) *
                                      (1.0 + x * x) / (2.0 * x);
        t.slip_stiffness_ratio = within(Quantity::slip_stiffness, &VehicleClass::slip_stiffness_ratio);
        t.shape = within(Quantity::shape, &VehicleClass::shape);
        t.curvature = within(Quantity::curvature, &VehicleClass::curvature);
        t.relaxation_length_m = within(Quantity::relaxation, &VehicleClass::relaxation_length_m);
        t.camber_thrust_prad = within(Quantity::camber_thrust, &VehicleClass::camber_thrust_prad);
        t.rolling_resistance = within(Quantity::rolling_resistance, &VehicleClass::rolling_resistance);
        t.front_friction_factor = within(Quantity::front_friction, &VehicleClass::front_friction_factor);
        t.rear_friction_factor = within(Quantity::rear_friction, &VehicleClass::rear_friction_factor);
    }

    void the_rest() {
        const double height = v_.geometry.cg_height_m;
        v_.steering.ratio = within(Quantity::steering_ratio, &VehicleClass::steering_ratio);
        v_.steering.lag_s = within(Quantity::steering_lag, &VehicleClass::steering_lag_s);
        DrivelineParameters& d = v_.driveline;
        d.front_drive_share = within(Quantity::front_drive, &VehicleClass::front_drive_share);
        d.drive_force_limit_n = 3.0 * mass_;
        d.engine_braking_n = 0.28 * mass_;
        d.differential_damping_nmsprad = 5.0e-3 * mass_;
        // Full braking is 0.9 g, two thirds of it in front.
        d.front_brake_nm = 0.3 * g_mps2 * mass_ * v_.geometry.wheel_radius_m;
        d.rear_brake_nm = 0.5 * d.front_brake_nm;
        v_.aerodynamics.drag_area_m2 = within(Quantity::drag_area, &VehicleClass::drag_area_m2);
        HullParameters& hull = v_.hull;
        hull.half_length_m =
            0.5 * wheelbase_ * within(Quantity::length, &VehicleClass::length_over_wheelbase);
        hull.half_width_m = 0.59 * v_.geometry.track_width_m;
        hull.top_above_cg_m = within(Quantity::body_height, &VehicleClass::body_height_m) - height;
        hull.bottom_below_cg_m = height - 0.6 * v_.geometry.wheel_radius_m;
        v_.imu_mount.x_m =
            wheelbase_ * within(Quantity::imu_forward, &VehicleClass::imu_forward_of_wheelbase);
        v_.imu_mount.y_m = within(Quantity::imu_left, &VehicleClass::imu_left_m);
        v_.imu_mount.z_m = within(Quantity::imu_height, &VehicleClass::imu_height_m) - height;
    }

    // Friction at the load F is a - b F; its loss by doubling the static load is drawn, and what is left
    // then.
    void grip() {
        const double wanted =
            properties(v_).threshold_g * within(Quantity::grip, &VehicleClass::grip_over_threshold);
        const double at_double_load = std::clamp(wanted, from_.friction.lowest, from_.friction.highest);
        const double loss = within(Quantity::friction_loss, &VehicleClass::friction_loss);
        const double static_n = 0.25 * g_mps2 * mass_;
        const double at_static_load = at_double_load / (1.0 - loss);
        const double slope_pn = loss * at_static_load / static_n;
        const double at_no_load = at_static_load + slope_pn * static_n;
        constexpr double reference_load_n = 6000.0;  // of TyreParameters
        v_.tyre.friction = at_no_load - reference_load_n * slope_pn;
        v_.tyre.friction_load_sensitivity = reference_load_n * slope_pn / v_.tyre.friction;
    }

    const VehicleClass& from_;
    const RandomNumbers& random_;
    VehicleParameters v_{};
    bool rigid_front_{false};
    bool rigid_rear_{false};
    double mass_{0.0};
    double front_share_{0.5};
    double wheelbase_{0.0};
};

std::string outside(const char* what, double value, double lowest, double highest) {
    return value >= lowest && value <= highest
               ? std::string{}
               : fmt::format("{} {:.3g}, plausible are {:.3g} to {:.3g}", what, value, lowest, highest);
}

}  // namespace

std::string implausible(const VehicleParameters& v, const VehicleClass& from) {
    const VehicleProperties p = properties(v);
    const VehicleProperties with_load = properties(loaded(v, from.load));
    // Below 0.4 g the tests that manoeuvres take their handwheel angles from cannot be driven, laden neither.
    constexpr double lowest_threshold_g = 0.42;
    for (const std::string& reason :
         {outside("static stability factor", p.static_stability_factor,
                  from.static_stability_factor.lowest - 1e-9, from.static_stability_factor.highest + 1e-9),
          outside("height of the CG over that of the body",
                  p.cg_height_m / (v.hull.top_above_cg_m + v.geometry.cg_height_m), 0.25, 0.60),
          outside("roll arm in m", p.roll_arm_m, 0.15, 2.0),
          outside("roll frequency in Hz", p.roll_frequency_hz, 0.6, 2.5),
          outside("roll frequency in Hz, laden", with_load.roll_frequency_hz, 0.4, 2.5),
          outside("roll damping ratio", p.roll_damping_ratio, 0.10, 0.80),
          outside("roll gradient in deg/g", p.roll_gradient_degpg, 0.8, 9.0),
          outside("roll gradient in deg/g, laden", with_load.roll_gradient_degpg, 0.8, 14.0),
          outside("rollover threshold in g", p.threshold_g, lowest_threshold_g, 2.0),
          outside("rollover threshold in g, laden", with_load.threshold_g, lowest_threshold_g, 2.0),
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
        const RandomNumbers random{seed, number, drawn.attempt};
        drawn.parameters = Builder{from, random}.build(drawn.rigid_front, drawn.rigid_rear);
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
