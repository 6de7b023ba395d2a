// Prints the accuracy of the roll centre's height and of the compensated roll angle over every manoeuvre, as
// the table of docs/theory.md.
#include <fmt/format.h>

#include <cstdio>
#include <exception>

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

struct Row {
    std::string height{};
    std::string roll{};
    std::string statistics{};
};

Row row(const RecordedDrive& drive, rsi_estimator estimator, float forgetting_factor) {
    rsi::Parameters parameters = sil::accuracy::calibration_of(drive, estimator);
    parameters.forgetting_factor = forgetting_factor;
    Row row;
    for (const double bias_g : biases_g) {
        const RollCentreAccuracy result = accuracy(drive, parameters, bias_g);
        const char* separator = row.height.empty() ? "" : " / ";
        row.height += fmt::format("{}{:.1f}", separator, 1000.0 * result.estimate_rms_m);
        row.roll += fmt::format("{}{:.2f}", separator, result.compensated_roll_rms_deg);
        row.statistics = fmt::format("{:.1f} %", 100.0 * result.within_three_deviations);
    }
    return row;
}

void print(const RecordedDrive& drive) {
    const rsi::Parameters parameters = sil::accuracy::calibration_of(drive, RSI_ESTIMATOR_PUBLISHED);
    const RollCentreAccuracy nominal = accuracy(drive, parameters, 0.0);
    if (nominal.cycles == 0) {
        return;
    }
    const Row fast = row(drive, RSI_ESTIMATOR_PUBLISHED, 0.99F);
    const Row slow = row(drive, RSI_ESTIMATOR_PUBLISHED, 0.999F);
    const Row second = row(drive, RSI_ESTIMATOR_CONSIDER_KALMAN, 0.999F);
    fmt::print("| {} | {} | {:.1f} | {} | {} | {} | {} | {} | {} |\n", drive.manoeuvre, nominal.cycles,
               1000.0 * nominal.constant_rms_m, fast.height, slow.height, second.height, second.statistics,
               slow.roll, second.roll);
}

}  // namespace

int main() try {
    for (const char* vehicle : {"large_suv", "ordinary_suv"}) {
        fmt::print(
            "\n{}: RMS error of h_rc against (24), mm, and of the compensated roll angle, deg; sensor noise "
            "with\naccelerometer bias 0 / 0.005 / 0.03 g\n\n"
            "| manoeuvre | cycles | constant | published, 0.99 | published, 0.999 | consider-Kalman | within "
            "3 "
            "deviations | roll, published | roll, consider-Kalman |\n|---|---|---|---|---|---|---|---|---|\n",
            vehicle);
        for (const sil::Manoeuvre& manoeuvre : sil::all_manoeuvres()) {
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
