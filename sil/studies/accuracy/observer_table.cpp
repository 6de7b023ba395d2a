// Prints how well the component knows roll and bank without a roll sensor, over every manoeuvre:
// docs/reports/data/validation_observer.csv.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>

#include "sil/files/csv_writer.hpp"
#include "sil/files/standard_streams.hpp"
#include "sil/studies/accuracy/roll_centre_accuracy.hpp"
#include "sil/units.hpp"
#include "sil/world/manoeuvres/catalogue.hpp"

namespace {

using sil::accuracy::Cycle;
using sil::accuracy::RecordedDrive;

constexpr double bias_g = 0.005;

struct Accuracy {
    double roll_rms_deg{0.0};
    double bank_rms_deg{0.0};
};

// Before the first wheel lifts.
Accuracy accuracy(const RecordedDrive& drive, double stiffness_factor) {
    rsi::Parameters parameters = sil::accuracy::calibration_of(drive, RSI_ESTIMATOR_CONSIDER_KALMAN);
    for (float* stiffness : {&parameters.roll_stiffness_nmprad, &parameters.roll_stiffness_cubic_nmprad3,
                             &parameters.roll_stiffness_quintic_nmprad5}) {
        *stiffness *= static_cast<float>(stiffness_factor);
    }
    double roll_square = 0.0;
    double bank_square = 0.0;
    int samples = 0;
    for (const Cycle& cycle : sil::accuracy::evaluate(drive, {true, bias_g, bias_g, 7U}, parameters)) {
        const auto& load = cycle.truth->wheel_load_n;
        if (std::any_of(load.begin(), load.end(), [](double load_n) { return load_n <= 0.0; })) {
            break;
        }
        const double roll_error =
            static_cast<double>(cycle.outputs.observed_roll_angle_rad) - cycle.truth->roll_angle_rad;
        const double bank_error =
            static_cast<double>(cycle.outputs.observed_bank_angle_rad) - cycle.truth->bank_angle_rad;
        if (std::isfinite(roll_error) && std::isfinite(bank_error)) {
            roll_square += roll_error * roll_error;
            bank_square += bank_error * bank_error;
            ++samples;
        }
    }
    const double mean = 1.0 / std::max(samples, 1);
    return {sil::degrees_per_radian * std::sqrt(roll_square * mean),
            sil::degrees_per_radian * std::sqrt(bank_square * mean)};
}

void print(const RecordedDrive& drive) {
    const Accuracy nominal = accuracy(drive, 1.0);
    sil::CsvRow row;
    row.text(drive.vehicle).text(drive.manoeuvre).fixed(nominal.roll_rms_deg, 2);
    row.fixed(nominal.bank_rms_deg, 2).fixed(accuracy(drive, 0.9).roll_rms_deg, 2);
    fmt::print("{}\n", row.fixed(accuracy(drive, 1.1).roll_rms_deg, 2).line());
}

}  // namespace

int main() try {
    fmt::print("{}\n",
               sil::csv_header({"vehicle", "manoeuvre", "roll", "bank", "roll with K 10 % low / high, low",
                                "roll with K 10 % low / high, high"}));
    for (const char* vehicle : {"large_suv", "ordinary_suv"}) {
        for (const sil::Manoeuvre& manoeuvre : sil::undisturbed_manoeuvres()) {
            print(sil::accuracy::record(manoeuvre.name, vehicle));
        }
    }
    return sil::finish_output("observer_table");
} catch (const std::exception& error) {
    static_cast<void>(std::fprintf(stderr, "observer_table: %s\n", error.what()));
    return 1;
}
