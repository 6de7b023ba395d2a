// Prints the RMS error of h_rc against (24), mm, and of the compensated roll angle, deg, over every
// manoeuvre, with sensor noise and biases of the accelerometer: docs/reports/data/validation_estimator.csv.
#include <fmt/format.h>

#include <cstdio>
#include <exception>

#include "sil/files/csv_writer.hpp"
#include "sil/files/standard_streams.hpp"
#include "sil/studies/accuracy/roll_centre_accuracy.hpp"
#include "sil/world/manoeuvres/catalogue.hpp"

namespace {

using sil::accuracy::RecordedDrive;
using sil::accuracy::RollCentreAccuracy;
using sil::accuracy::SensorQuality;

constexpr double biases_g[] = {0.0, 0.005, 0.03};

RollCentreAccuracy accuracy(const RecordedDrive& drive, const rsi::Parameters& parameters, double bias_g) {
    const SensorQuality quality{true, bias_g, bias_g, 1U};
    return sil::accuracy::roll_centre_accuracy(sil::accuracy::evaluate(drive, quality, parameters),
                                               parameters);
}

std::vector<RollCentreAccuracy> for_each_bias(const RecordedDrive& drive, rsi_estimator estimator,
                                              float forgetting_factor) {
    rsi::Parameters parameters = sil::accuracy::calibration_of(drive, estimator);
    parameters.forgetting_factor = forgetting_factor;
    std::vector<RollCentreAccuracy> found;
    for (const double bias_g : biases_g) {
        found.push_back(accuracy(drive, parameters, bias_g));
    }
    return found;
}

void print(const RecordedDrive& drive) {
    const rsi::Parameters parameters = sil::accuracy::calibration_of(drive, RSI_ESTIMATOR_PUBLISHED);
    const RollCentreAccuracy nominal = accuracy(drive, parameters, 0.0);
    if (nominal.cycles == 0) {
        return;
    }
    const auto fast = for_each_bias(drive, RSI_ESTIMATOR_PUBLISHED, 0.99F);
    const auto slow = for_each_bias(drive, RSI_ESTIMATOR_PUBLISHED, 0.999F);
    const auto second = for_each_bias(drive, RSI_ESTIMATOR_CONSIDER_KALMAN, 0.999F);
    sil::CsvRow row;
    row.text(drive.vehicle).text(drive.manoeuvre).number(nominal.cycles, 9);
    row.fixed(1000.0 * nominal.constant_rms_m, 1);
    for (const auto& results : {fast, slow, second}) {
        for (const RollCentreAccuracy& result : results) {
            row.fixed(1000.0 * result.estimate_rms_m, 1);
        }
    }
    row.text(fmt::format("{:.1f} %", 100.0 * second.back().within_three_deviations));
    for (const auto& results : {slow, second}) {
        for (const RollCentreAccuracy& result : results) {
            row.fixed(result.compensated_roll_rms_deg, 2);
        }
    }
    fmt::print("{}\n", row.line());
}

std::string header() {
    std::vector<std::string> names{"vehicle", "manoeuvre", "cycles", "constant"};
    const auto add = [&names](const char* name) {
        for (const double bias_g : biases_g) {
            names.push_back(fmt::format("{}, {:g} g", name, bias_g));
        }
    };
    add("published, 0.99");
    add("published, 0.999");
    add("consider-Kalman");
    names.emplace_back("within 3 deviations");
    add("roll, published");
    add("roll, consider-Kalman");
    return sil::csv_header(names);
}

}  // namespace

int main() try {
    fmt::print("{}\n", header());
    for (const char* vehicle : {"large_suv", "ordinary_suv"}) {
        for (const sil::Manoeuvre& manoeuvre : sil::undisturbed_manoeuvres()) {
            if (manoeuvre.name != "straight") {
                print(sil::accuracy::record(manoeuvre.name, vehicle));
            }
        }
    }
    return sil::finish_output("roll_centre_table");
} catch (const std::exception& error) {
    static_cast<void>(std::fprintf(stderr, "roll_centre_table: %s\n", error.what()));
    return 1;
}
