// Vehicle model: the simulated vehicle with its sensors, under a driver of the importer's or in a manoeuvre.
#include <cmath>
#include <limits>
#include <optional>

#include "sil/exchange/fmu/model.hpp"
#include "sil/exchange/fmu/start_values.hpp"
#include "sil/judge/two_wheel_lift.hpp"
#include "sil/results/indices.hpp"
#include "sil/simulation/component_inputs.hpp"
#include "sil/simulation/mounted_sensors.hpp"
#include "sil/world/manoeuvres/catalogue.hpp"
#include "sil/world/manoeuvres/manoeuvre_run.hpp"
#include "sil/world/sensors/sensor_suite.hpp"
#include "sil/world/vehicle/parameter_table.hpp"

namespace fmu {
namespace {

constexpr const char* by_inputs = "inputs";
constexpr int steps_per_cycle = 10;
constexpr double longest_s = 1.0e6;  // the importer ends the run
constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

struct Plant {
    sil::ManoeuvreRun run;
    sil::SensorSuite sensors;
    sil::TwoWheelLiftObserver lift{};
};

// True values without a sensor.
struct TrueOutput {
    const char* name;
    const char* meaning;
    double (*of)(const Plant&);
};
constexpr TrueOutput true_outputs[] = {
    {"true.wheel_load_front_left_n", "0 when the wheel has lifted",
     [](const Plant& p) { return p.run.truth().wheel_load_n[sil::front_left]; }},
    {"true.wheel_load_front_right_n", "0 when the wheel has lifted",
     [](const Plant& p) { return p.run.truth().wheel_load_n[sil::front_right]; }},
    {"true.wheel_load_rear_left_n", "0 when the wheel has lifted",
     [](const Plant& p) { return p.run.truth().wheel_load_n[sil::rear_left]; }},
    {"true.wheel_load_rear_right_n", "0 when the wheel has lifted",
     [](const Plant& p) { return p.run.truth().wheel_load_n[sil::rear_right]; }},
    {"true.load_transfer_ratio", "of the wheel loads, right less left over all; no number in the air",
     [](const Plant& p) { return sil::true_load_transfer_ratio(p.run.truth()); }},
    {"true.two_wheel_lift_time_s",
     "since the start: when both wheels of a side began to carry nothing for 50 ms or longer; no number "
     "before",
     [](const Plant& p) { return p.lift.lift_off() ? p.lift.lift_off()->moment.time_s : nothing; }},
    {"true.roll_angle_rad", "of the body against the road",
     [](const Plant& p) { return p.run.truth().roll_angle_rad; }},
    {"true.roll_rate_radps", "about the body's x axis",
     [](const Plant& p) { return p.run.truth().angular_velocity_radps[0]; }},
    {"true.lateral_acceleration_mps2", "horizontal, at the CG",
     [](const Plant& p) { return p.run.truth().lateral_acceleration_mps2; }},
    {"true.speed_mps", "along the heading", [](const Plant& p) { return p.run.truth().speed_mps; }},
    {"true.position_x_m", "of the CG", [](const Plant& p) { return p.run.truth().position_x_m; }},
    {"true.position_y_m", "of the CG", [](const Plant& p) { return p.run.truth().position_y_m; }},
    {"true.position_z_m", "of the CG", [](const Plant& p) { return p.run.truth().position_z_m; }},
    {"true.yaw_angle_rad", "of the heading", [](const Plant& p) { return p.run.truth().yaw_angle_rad; }},
};

struct Flag {
    const char* name;
    const char* meaning;
    bool (*of)(const sil::Truth&);
};
constexpr Flag flags[] = {
    {"true.two_left_wheels_lifted", "both wheels of the left side carry nothing", sil::left_side_has_lifted},
    {"true.two_right_wheels_lifted", "both wheels of the right side carry nothing",
     sil::right_side_has_lifted},
};

// First rows of the groups.
struct Layout {
    std::size_t settings{0U};  // after the vehicle's own parameters
    std::size_t inputs{0U};
    std::size_t outputs{0U};
};
enum Setting : std::size_t {
    manoeuvre,
    mirrored,
    initial_speed,
    noise,
    seed,
    bank_sensor,
    attitude_sensor,
    mass_sensor
};
enum Input : std::size_t { steering, speed, brake, off_throttle };

class Table {
 public:
    Table() {
        add("time", Role::time, Kind::number, "simulated time");
        const double* start = start_values;
        for (const sil::VehicleField& field : sil::vehicle_fields) {
            add(std::string{field.table} + "." + field.key, Role::parameter, Kind::number, "", *start++)
                .within(field.lowest, field.highest);
        }
        layout.settings = rows.size();
        add("manoeuvre", Role::parameter, Kind::text,
            "inputs: the driver's inputs are followed; else the name of a manoeuvre, as `rsi-sil run --list` "
            "has them");
        rows.back().start_text = by_inputs;
        add("mirrored", Role::parameter, Kind::boolean, "the manoeuvre's first turn is to the right");
        add("initial_speed_mps", Role::parameter, Kind::number, "with the driver's inputs", 25.0)
            .within(1.0, 80.0);
        add("sensors.noise", Role::parameter, Kind::boolean, "that of ordinary automotive sensors");
        add("sensors.seed", Role::parameter, Kind::integer, "of the noise", 1.0).within(0.0, 2147483647.0);
        add("sensors.bank_sensor", Role::parameter, Kind::boolean, "the road's bank is measured");
        add("sensors.attitude_sensor", Role::parameter, Kind::boolean,
            "the roll angle is measured against the horizon");
        add("sensors.mass_sensor", Role::parameter, Kind::boolean, "the vehicle's mass is measured");
        layout.inputs = rows.size();
        add("driver.steering_wheel_angle_rad", Role::input, Kind::number, "positive to the left")
            .within(-30.0, 30.0);
        add("driver.speed_mps", Role::input, Kind::number, "to be held; no number: the initial speed",
            nothing);
        rows.back().may_be_missing = true;
        add("driver.brake", Role::input, Kind::number, "0 released, 1 full").within(0.0, 1.0);
        add("driver.off_throttle", Role::input, Kind::boolean, "no speed is held, the engine brakes");
        layout.outputs = rows.size();
        for (const sil::ComponentInput& output : sil::component_inputs) {
            add(output.name, Role::output, Kind::number, "as a sensor reports it; no number: not available");
        }
        for (const TrueOutput& output : true_outputs) {
            add(output.name, Role::output, Kind::number, output.meaning);
        }
        for (const Flag& output : flags) {
            add(output.name, Role::output, Kind::boolean, output.meaning);
        }
    }

    Variables rows{};
    Layout layout{};

 private:
    Table& add(std::string name, Role role, Kind kind, std::string meaning, double start = 0.0) {
        Variable variable;
        variable.name = std::move(name);
        variable.role = role;
        variable.kind = kind;
        variable.meaning = std::move(meaning);
        variable.start = start;
        rows.push_back(std::move(variable));
        return *this;
    }
    void within(double least, double largest) {
        rows.back().least = least;
        rows.back().largest = largest;
    }
};

// Does what the importer asks for; `asked` may change between two cycles.
class ImportersDriver final : public sil::CopiedDriver<ImportersDriver> {
 public:
    explicit ImportersDriver(std::shared_ptr<const sil::DriverCommand> asked) : asked_{std::move(asked)} {}
    sil::DriverCommand command(const sil::Truth&) override { return *asked_; }

 private:
    std::shared_ptr<const sil::DriverCommand> asked_;
};

class VehicleModel final : public Model {
 public:
    const Variables& variables() const override { return table_->rows; }

    Complaint start(Values& values) override {
        const auto setting = [&](Setting which) { return values.numbers[table_->layout.settings + which]; };
        sil::VehicleParameters vehicle;
        std::size_t place = 1U;
        for (const sil::VehicleField& field : sil::vehicle_fields) {
            field.of(vehicle) = values.numbers[place++];
        }
        const std::string& name = values.texts[table_->layout.settings + manoeuvre];
        initial_speed_mps_ = setting(initial_speed);
        sil::Manoeuvre what;
        try {
            what = name == by_inputs ? driven_by_inputs() : sil::find_manoeuvre(name);
        } catch (const sil::UnknownManoeuvre& error) {
            return std::string{"parameter manoeuvre: "} + error.what() +
                   " Or inputs, to drive it by its inputs.";
        }
        sil::RunOptions options;
        options.mirrored = setting(mirrored) != 0.0;
        sil::SensorFlaws flaws;
        flaws.noise = setting(noise) != 0.0;
        flaws.seed = static_cast<std::uint64_t>(setting(seed));
        flaws.bank_sensor = setting(bank_sensor) != 0.0;
        flaws.attitude_sensor = setting(attitude_sensor) != 0.0;
        flaws.mass_sensor = setting(mass_sensor) != 0.0;
        hear(values);
        plant_.emplace(Plant{sil::ManoeuvreRun{vehicle, what, options},
                             sil::SensorSuite{sil::mounted_sensors(vehicle, flaws)}});
        plant_->sensors.observe(plant_->run.truth());
        tell(values);
        return {};
    }

    Complaint cycle(Values& values) override {
        hear(values);
        for (int step = 0; step < steps_per_cycle; ++step) {
            plant_->run.step();
            const sil::Truth& truth = plant_->run.truth();
            plant_->sensors.observe(truth);
            plant_->lift.observe({truth.time_s, truth.lateral_acceleration_mps2, truth.roll_angle_rad},
                                 sil::left_side_has_lifted(truth), sil::right_side_has_lifted(truth));
        }
        tell(values);
        return {};
    }

    std::unique_ptr<Model> copy() const override { return std::make_unique<VehicleModel>(*this); }

 private:
    sil::Manoeuvre driven_by_inputs() const {
        sil::Manoeuvre by_importer;
        by_importer.name = by_inputs;
        by_importer.duration_s = longest_s;
        by_importer.initial_speed_mps = initial_speed_mps_;
        by_importer.make_road = sil::flat_road();
        by_importer.make_driver = [asked = asked_](const sil::VehicleParameters&) {
            return std::make_unique<ImportersDriver>(asked);
        };
        return by_importer;
    }

    void hear(const Values& values) {
        const auto input = [&](Input which) { return values.numbers[table_->layout.inputs + which]; };
        asked_->steering_wheel_angle_rad = input(steering);
        asked_->speed_share = std::isfinite(input(speed)) ? input(speed) / initial_speed_mps_ : 1.0;
        asked_->brake = input(brake);
        asked_->speed_policy =
            input(off_throttle) != 0.0 ? sil::SpeedPolicy::off_throttle : sil::SpeedPolicy::held;
    }

    void tell(Values& values) {
        std::size_t place = table_->layout.outputs;
        const sil::SensorSample sample = plant_->sensors.report(plant_->run.truth());
        for (const sil::ComponentInput& output : sil::component_inputs) {
            values.numbers[place++] = sample.*output.measured;
        }
        for (const TrueOutput& output : true_outputs) {
            values.numbers[place++] = output.of(*plant_);
        }
        for (const Flag& output : flags) {
            values.numbers[place++] = output.of(plant_->run.truth()) ? 1.0 : 0.0;
        }
    }

    std::shared_ptr<const Table> table_{std::make_shared<Table>()};
    // Shared with the driver and all copies: written before each cycle, so that no copy sees another's.
    std::shared_ptr<sil::DriverCommand> asked_{std::make_shared<sil::DriverCommand>()};
    double initial_speed_mps_{1.0};
    std::optional<Plant> plant_{};
};

}  // namespace

std::unique_ptr<Model> make_model() {
    return std::make_unique<VehicleModel>();
}

}  // namespace fmu
