// Records what the component gets in whole manoeuvres, and a drive made to be dear, for the program on the
// target.
//   record FOLDER      writes into FOLDER steps.bin and search.bin, each with what is in it as .json, and
//                      regressions.bin
#include <cmath>
#include <cstring>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "hal/memory/memory_bus.hpp"
#include "hal/memory/virtual_clock.hpp"
#include "rsi/component.hpp"
#include "rsi/ecu/application/sensor_reception.hpp"
#include "sil/files/calibration_file.hpp"
#include "sil/files/candump_log.hpp"
#include "sil/files/sensor_frame.hpp"
#include "sil/simulation/in_process_run.hpp"
#include "sil/simulation/mounted_sensors.hpp"
#include "sil/world/manoeuvres/catalogue.hpp"
#include "sil/world/vehicle/parameter_file.hpp"
#include "tests/rsi/support/estimation_chain.hpp"
#include "tests/targets/budgets/dear_drive.hpp"
#include "tests/targets/budgets/output_digest.hpp"
#include "tests/targets/budgets/recording.hpp"

namespace {

struct Drive {
    std::string name;
    std::string estimator;
    rsi::Parameters parameters;
    std::vector<budgets::Record> records;
};

rsi::Parameters calibration(const std::string& estimator) {
    return sil::load_calibration(RSI_SOURCE_DIR "/firmware/calibrations/large_suv.toml",
                                 {"estimator=" + estimator});
}

// The sensors' frames of a whole run, cycle by cycle through the firmware's own reception.
std::vector<budgets::Record> manoeuvre(const std::string& name, const rsi::Parameters& parameters,
                                       const std::string& log_path) {
    const sil::VehicleParameters vehicle = sil::load_vehicle(RSI_SOURCE_DIR "/sil/vehicles/large_suv.toml");
    sil::CandumpLogWriter log{log_path};
    sil::InProcessRun run{
        vehicle, sil::find_manoeuvre(name), {}, sil::mounted_sensors(vehicle, {}), parameters, &log};
    run.run();
    log.close();

    rsi::hal::VirtualClock clock;
    rsi::hal::MemoryBus<2U> bus{clock};
    rsi::application::SensorReception reception;
    std::vector<budgets::Record> records;
    const auto end_cycle = [&] {
        reception.receive(bus.endpoint(0U), 0U);
        records.push_back(budgets::Record{reception.inputs(reception.report(clock.now())), 0U});
    };
    bool begun = false;
    for (const sil::LoggedFrame& logged : sil::read_candump_log(log_path)) {
        if (!sil::is_sensor_frame(logged.frame)) {
            continue;
        }
        if (begun && (logged.frame.receive_time.nanoseconds != clock.now().nanoseconds)) {
            end_cycle();
        }
        begun = true;
        clock.set(logged.frame.receive_time);
        bus.endpoint(1U).send(logged.frame);
    }
    end_cycle();

    rsi::Component component;
    component.init(parameters);
    rsi::Outputs outputs{};
    for (const budgets::Record& record : records) {
        component.step(record.inputs, outputs);
    }
    if (std::memcmp(&outputs.warning_level, &run.outputs().warning_level, sizeof(float)) != 0) {
        throw std::runtime_error("the recorded inputs of " + name + " do not give what the run gave");
    }
    return records;
}

// Expected answers of the target.
std::uint32_t digest(const Drive& drive) {
    rsi::Component component;
    component.init(drive.parameters);
    std::uint32_t value = budgets::fnv_offset;
    for (const budgets::Record& record : drive.records) {
        rsi::Component copy = component;
        rsi::Outputs outputs{};
        ((record.on_copy != 0U) ? copy : component).step(record.inputs, outputs);
        value = budgets::digest(value, outputs);
    }
    return value;
}

template <typename Value>
void write(std::ofstream& file, const Value& value) {
    file.write(reinterpret_cast<const char*>(&value), sizeof(value));
}

std::ofstream open(const std::string& path) {
    std::ofstream file{path, std::ios::binary};
    file.exceptions(std::ios::failbit | std::ios::badbit);
    return file;
}

void write_steps(const std::string& path, const std::vector<Drive>& drives) {
    std::ofstream file = open(path + ".bin");
    write(file, budgets::recording_magic);
    write(file, static_cast<std::uint32_t>(drives.size()));
    nlohmann::json list = nlohmann::json::array();
    for (const Drive& drive : drives) {
        write(file, drive.parameters);
        write(file, static_cast<std::uint32_t>(drive.records.size()));
        for (const budgets::Record& record : drive.records) {
            write(file, record);
        }
        list.push_back({{"name", drive.name},
                        {"estimator", drive.estimator},
                        {"steps", drive.records.size()},
                        {"digest", digest(drive)}});
    }
    file.close();
    std::ofstream json = open(path + ".json");
    json << list.dump(2) << '\n';
}

void write_regressions(const std::string& path, const Drive& drive) {
    rsi_test::EstimationChain chain{drive.parameters};
    std::vector<budgets::LeastSquaresRecord> records;
    for (const budgets::Record& record : drive.records) {
        rsi::Regression regression;
        if ((record.on_copy == 0U) && chain.step(record.inputs, regression)) {
            records.push_back(
                {regression.output_nm, {regression.psi.x(), regression.psi.y(), regression.psi.z()}});
        }
    }
    std::ofstream file = open(path);
    write(file, budgets::regression_magic);
    write(file, drive.parameters);
    write(file, static_cast<std::uint32_t>(records.size()));
    for (const budgets::LeastSquaresRecord& record : records) {
        write(file, record);
    }
}

}  // namespace

int main(int argument_count, char** arguments) try {
    if (argument_count != 2) {
        std::cerr << "Use: record FOLDER\n";
        return 2;
    }
    const std::string folder = arguments[1];
    std::vector<Drive> drives;
    std::vector<Drive> searches;
    const budgets::DearDriveOptions thorough{5000, 10, 72U};
    for (const std::string estimator : {"consider_kalman", "published"}) {
        const rsi::Parameters parameters = calibration(estimator);
        for (const std::string name : {"j-turn-110", "fishhook-1a"}) {
            drives.push_back({name, estimator, parameters, manoeuvre(name, parameters, folder + "/run.log")});
        }
        drives.push_back({"worst-case", estimator, parameters, budgets::dear_drive(parameters, {})});
        searches.push_back({"search", estimator, parameters, budgets::dear_drive(parameters, thorough)});
    }
    write_steps(folder + "/steps", drives);
    write_steps(folder + "/search", searches);
    write_regressions(folder + "/regressions.bin", drives[2]);
    return 0;
} catch (const std::exception& error) {
    std::cerr << "record: " << error.what() << '\n';
    return 1;
}
