#include "sil/studies/vehicle_validation/drive_comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

#include "sil/files/csv_writer.hpp"
#include "sil/judge/warning_judgement.hpp"
#include "sil/studies/identification/lift_cut.hpp"
#include "sil/studies/identification/plausibility_checks.hpp"
#include "sil/studies/identification/roll_prediction.hpp"
#include "sil/studies/identification/roll_reference.hpp"
#include "sil/units.hpp"

namespace sil {
namespace {

std::vector<bool> turns(const PreparedDrive& drive) {
    std::vector<bool> counts;
    for (const RollSample& sample : drive.samples) {
        counts.push_back(std::fabs(sample.parallel_mps2) >= least_turn_mps2);
    }
    return counts;
}

void judge(ComparedQuantity& quantity, const Tolerance& tolerance, const std::vector<bool>& counts) {
    quantity.corridor = corridor_about(quantity.measured, sample_time_s, tolerance);
    quantity.share_within = share_within(quantity.corridor, quantity.predicted, counts);
    double squares = 0.0;
    for (std::size_t place = 0U; place < quantity.measured.size(); ++place) {
        const double error = counts[place] ? quantity.predicted[place] - quantity.measured[place] : 0.0;
        squares += error * error;
    }
    const auto counted = static_cast<double>(std::count(counts.begin(), counts.end(), true));
    quantity.rms_error = std::sqrt(squares / counted);
}

ComparedQuantity roll_angles(const PreparedDrive& drive, const rsi::Parameters& parameters) {
    ComparedQuantity quantity{"roll_angle_deg", "roll angle", "deg", {}, {}, {}, 0.0, 0.0};
    for (const RollSample& sample : drive.samples) {
        quantity.measured.push_back(sample.roll_angle_rad * degrees_per_radian);
    }
    for (const double angle : predicted_roll_angles_rad(roll_model(parameters), drive.samples)) {
        quantity.predicted.push_back(angle * degrees_per_radian);
    }
    judge(quantity, roll_angle_tolerance_deg, turns(drive));
    return quantity;
}

// 2/(m N c_w) times the moment.
ComparedQuantity load_transfers(const PreparedDrive& drive, const VehicleData& vehicle,
                                const rsi::Parameters& parameters) {
    ComparedQuantity quantity{"load_transfer_ratio", "load transfer ratio", "", {}, {}, {}, 0.0, 0.0};
    for (const RollSample& sample : drive.samples) {
        const double scale = 2.0 / (vehicle.total_mass_kg * sample.normal_mps2 * vehicle.track_width_m);
        quantity.measured.push_back(scale * sample.load_moment_nm);
        quantity.predicted.push_back(scale * load_moment_nm(parameters, sample));
    }
    judge(quantity, load_transfer_tolerance, turns(drive));
    return quantity;
}

// Whether the two run against each other, as with a wrong sign.
bool is_mirrored(const ComparedQuantity& quantity, const std::vector<bool>& counts) {
    double product = 0.0;
    for (std::size_t place = 0U; place < quantity.measured.size(); ++place) {
        product += counts[place] ? quantity.measured[place] * quantity.predicted[place] : 0.0;
    }
    return product < 0.0;
}

// Leaves what comes before a first wheel can have lifted, which no wheel loads show; why no later, in words.
std::string cut_before_lift(PreparedDrive& prepared, const VehicleData& vehicle) {
    const auto end =
        std::find_if(prepared.samples.begin(), prepared.samples.end(), [&vehicle](const RollSample& sample) {
            return load_band(load_transfer_by_heights(vehicle, sample)) != LoadBand::below_0_7;
        });
    if (end != prepared.samples.end()) {
        prepared.cut_s = end->time_s;
    }
    if (!prepared.cut_s) {
        return {};
    }
    prepared.samples.erase(end, prepared.samples.end());
    prepared.largest_parallel_mps2 = 0.0;
    for (const RollSample& sample : prepared.samples) {
        prepared.largest_parallel_mps2 =
            std::max(prepared.largest_parallel_mps2, std::fabs(sample.parallel_mps2));
    }
    return fmt::format(
        "from {:.2f} s on a first wheel may have lifted, by the heights of the vehicle data and without "
        "wheel loads: not compared",
        *prepared.cut_s);
}

std::string cut_words(const Drive& drive, PreparedDrive& prepared, const VehicleData& vehicle) {
    return prepared.has_wheel_loads || drive.lift_off_given ? prepared.cut_reason
                                                            : cut_before_lift(prepared, vehicle);
}

// The suspension alone.
RollFit fit_of(const rsi::Parameters& parameters) {
    RollFit fit;
    fit.arm_m = static_cast<double>(parameters.sprung_cg_height_m) -
                static_cast<double>(parameters.fixed_roll_centre_height_m);
    const RollModel model = roll_model(parameters);
    fit.stiffness_nmprad.value = model.stiffness_nmprad;
    fit.stiffness_cubic_nmprad3.value = model.cubic_nmprad3;
    fit.stiffness_quintic_nmprad5.value = model.quintic_nmprad5;
    return fit;
}

std::optional<std::string> reference_doubt(const PreparedDrive& prepared, const VehicleData& vehicle,
                                           const rsi::Parameters& parameters) {
    const auto seen = seen_roll_reference(vehicle, fit_of(parameters), prepared);
    const bool is_horizon = parameters.roll_angle_reference == RSI_ROLL_AGAINST_HORIZON;
    if (!seen || is_horizon == (seen->reference == RollReference::horizon)) {
        return std::nullopt;
    }
    return fmt::format("{}: the roll angle seems to be one against the {}, and the calibration says {}",
                       seen->by, is_horizon ? "road" : "horizon", is_horizon ? "horizon" : "road");
}

void add_remark(DriveComparison& comparison, const std::string& remark) {
    comparison.reason += (comparison.reason.empty() || remark.empty() ? "" : "; ") + remark;
}

// As identify doubts the drives that it takes.
void add_doubts(DriveComparison& comparison, const PreparedDrive& prepared, const VehicleData& vehicle,
                const rsi::Parameters& parameters) {
    for (const auto& doubt :
         {straight_start_doubt(prepared), reference_doubt(prepared, vehicle, parameters)}) {
        add_remark(comparison, doubt.value_or(""));
    }
    for (const ComparedQuantity& quantity : comparison.quantities) {
        if (is_mirrored(quantity, comparison.counts)) {
            add_remark(comparison,
                       fmt::format("the {} runs against its prediction: check the signs", quantity.words));
        }
    }
}

ComparisonVerdict verdict_of(const DriveComparison& comparison, bool was_cut) {
    if (comparison.turn_s < least_turn_s) {
        return was_cut ? ComparisonVerdict::not_comparable : ComparisonVerdict::too_calm;
    }
    const bool near =
        std::all_of(comparison.quantities.begin(), comparison.quantities.end(),
                    [](const ComparedQuantity& each) { return each.share_within >= least_share_within; });
    return near ? ComparisonVerdict::within : ComparisonVerdict::outside;
}

}  // namespace

Corridor corridor_about(const std::vector<double>& measured, double step_s, const Tolerance& tolerance) {
    const auto reach = static_cast<std::ptrdiff_t>(std::lround(tolerance.time_s / step_s));
    const auto count = static_cast<std::ptrdiff_t>(measured.size());
    Corridor corridor;
    for (std::ptrdiff_t place = 0; place < count; ++place) {
        const auto [lowest, highest] =
            std::minmax_element(measured.begin() + std::max<std::ptrdiff_t>(0, place - reach),
                                measured.begin() + std::min(count, place + reach + 1));
        corridor.lower.push_back(*lowest - tolerance.offset - tolerance.share * std::fabs(*lowest));
        corridor.upper.push_back(*highest + tolerance.offset + tolerance.share * std::fabs(*highest));
    }
    return corridor;
}

double share_within(const Corridor& corridor, const std::vector<double>& predicted,
                    const std::vector<bool>& counts) {
    double within = 0.0;
    double counted = 0.0;
    for (std::size_t place = 0U; place < predicted.size(); ++place) {
        if (counts[place]) {
            counted += 1.0;
            within += predicted[place] >= corridor.lower[place] && predicted[place] <= corridor.upper[place]
                          ? 1.0
                          : 0.0;
        }
    }
    return counted > 0.0 ? within / counted : std::numeric_limits<double>::quiet_NaN();
}

const char* to_string(ComparisonVerdict verdict) {
    static constexpr const char* words[] = {"within", "outside", "too calm", "not comparable"};
    return words[static_cast<std::size_t>(verdict)];
}

DriveComparison compare_drive(const Drive& drive, const VehicleData& vehicle,
                              const rsi::Parameters& parameters) {
    DriveComparison comparison;
    comparison.name = drive.name;
    PreparedDrive prepared;
    try {
        prepared = prepare_drive(drive, vehicle, {});
    } catch (const IdentificationError& error) {
        comparison.reason = error.what();
        return comparison;
    }
    add_remark(comparison, cut_words(drive, prepared, vehicle));
    if (prepared.samples.empty()) {
        return comparison;
    }
    comparison.largest_force_mps2 = prepared.largest_parallel_mps2;
    comparison.counts = turns(prepared);
    comparison.turn_s = sample_time_s * static_cast<double>(std::count(comparison.counts.begin(),
                                                                       comparison.counts.end(), true));
    for (const RollSample& sample : prepared.samples) {
        comparison.time_s.push_back(sample.time_s);
    }
    comparison.quantities.push_back(roll_angles(prepared, parameters));
    if (prepared.has_wheel_loads) {
        comparison.quantities.push_back(load_transfers(prepared, vehicle, parameters));
    }
    comparison.verdict = verdict_of(comparison, prepared.cut_s.has_value());
    if (comparison.verdict == ComparisonVerdict::not_comparable) {
        add_remark(comparison, fmt::format("only {:.2f} s of turns before it", comparison.turn_s));
    }
    add_doubts(comparison, prepared, vehicle, parameters);
    return comparison;
}

std::string comparison_csv(const DriveComparison& comparison) {
    std::string text = "time_s,counts";
    for (const ComparedQuantity& quantity : comparison.quantities) {
        for (const char* what : {"measured", "lower", "upper", "predicted"}) {
            text += "," + quantity.name + "_" + what;
        }
    }
    text += "\n";
    for (std::size_t place = 0U; place < comparison.time_s.size(); ++place) {
        CsvRow row;
        row.number(comparison.time_s[place], 9).count(comparison.counts[place] ? 1U : 0U);
        for (const ComparedQuantity& quantity : comparison.quantities) {
            for (const double value : {quantity.measured[place], quantity.corridor.lower[place],
                                       quantity.corridor.upper[place], quantity.predicted[place]}) {
                row.number(value, 7);
            }
        }
        text += row.line() + "\n";
    }
    return text;
}

}  // namespace sil
