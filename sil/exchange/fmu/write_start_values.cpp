// Reads a calibration or a vehicle as the programs do, and prints the parameters' values for
// start_values.hpp.
#include <fmt/format.h>

#include <exception>
#include <string_view>

#include "rsi/parameters.hpp"
#include "sil/files/calibration_file.hpp"
#include "sil/world/vehicle/parameter_file.hpp"
#include "sil/world/vehicle/parameter_table.hpp"

namespace {

void print_calibration(const char* path) {
    const rsi::Parameters calibration = sil::load_calibration(path);
    for (const rsi::ParameterField& field : rsi::parameter_fields) {
        fmt::print("{},\n", calibration.*field.member);  // the shortest text that gives this float
    }
    for (const rsi::SelectionField& field : rsi::selection_fields) {
        fmt::print("{},\n", calibration.*field.member);
    }
}

void print_vehicle(const char* path) {
    sil::VehicleParameters vehicle = sil::load_vehicle(path);
    for (const sil::VehicleField& field : sil::vehicle_fields) {
        fmt::print("{},\n", field.of(vehicle));
    }
}

}  // namespace

int main(int count, char** words) {
    if (count != 3 ||
        (std::string_view{words[1]} != "calibration" && std::string_view{words[1]} != "vehicle")) {
        fmt::print(stderr,
                   "Use: fmu-start-values calibration|vehicle FILE.toml      For sil/exchange/fmu/build.\n");
        return 2;
    }
    try {
        std::string_view{words[1]} == "calibration" ? print_calibration(words[2]) : print_vehicle(words[2]);
        return 0;
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 1;
    }
}
