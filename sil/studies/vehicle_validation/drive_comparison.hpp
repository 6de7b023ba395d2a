// Drive comparison: what a calibration predicts of a drive, beside what was measured in it, and whether that
// is near enough.
#pragma once

#include <string>
#include <vector>

#include "rsi/types.hpp"
#include "sil/studies/drives/drive.hpp"
#include "sil/studies/identification/prepared_drive.hpp"

namespace sil {

// A bound is offset + share |measured| away from the measured signal, of which within so much time the
// extreme counts.
struct Tolerance {
    double offset{};
    double share{};
    double time_s{};
};

struct Corridor {
    std::vector<double> lower{};
    std::vector<double> upper{};
};

// `measured` has a value every `step_s`, all of them finite.
Corridor corridor_about(const std::vector<double>& measured, double step_s, const Tolerance& tolerance);

// Share of the values that count that lies within; one that is not finite does not. NaN when none counts.
// All are as long as the corridor.
double share_within(const Corridor& corridor, const std::vector<double>& predicted,
                    const std::vector<bool>& counts);

// The tolerances are this project's own. The campaigns draw errors of stiffness of up to 10 % and of the CG
// height of up to 5 % (sil/studies/campaign/default.toml): with errors as large the warning has been judged.
// The offsets are what sensors leave after their mean over the straight start is taken off.
inline constexpr Tolerance roll_angle_tolerance_deg{0.3, 0.10, 0.03};
inline constexpr Tolerance load_transfer_tolerance{0.03, 0.05, 0.03};

// Least share of the samples that count that must lie within.
inline constexpr double least_share_within = 0.95;

// A sample counts in turns of at least so much |A|: elsewhere a body that does not roll at all lies within,
// too. With less than so long a time of them a drive says nothing.
inline constexpr double least_turn_mps2 = 2.0;
inline constexpr double least_turn_s = 0.5;

enum class ComparisonVerdict : unsigned char { within, outside, too_calm, not_comparable };

// "within", "outside", "too calm", "not comparable".
const char* to_string(ComparisonVerdict verdict);

// One quantity over the drive.
struct ComparedQuantity {
    std::string name{};   // roll_angle_deg, load_transfer_ratio
    std::string words{};  // "roll angle"
    std::string unit{};
    std::vector<double> measured{};
    std::vector<double> predicted{};
    Corridor corridor{};
    double share_within{};  // of the samples that count; NaN when none does
    double rms_error{};     // of them
};

struct DriveComparison {
    std::string name{};
    ComparisonVerdict verdict{ComparisonVerdict::not_comparable};
    // Why no later or not comparable, and doubts about its sensors, in words; may be empty.
    std::string reason{};
    std::vector<double> time_s{};
    std::vector<bool> counts{};  // which samples do
    double largest_force_mps2{};
    double turn_s{};  // how long samples count
    std::vector<ComparedQuantity>
        quantities{};  // the roll angle, and the load transfer where wheel loads are known
};

// Roll angle: by the calibration's roll model from the measured lateral force alone. Load transfer ratio: as
// the component has it, from lateral force, roll angle and rate, against that of the wheel loads. Only what
// comes before a wheel lifts is compared, and without wheel loads before one can have: where the heights and
// the measured forces mean |LTR| = 0.7. A drive without roll angle, or too short before that, is not
// comparable.
DriveComparison compare_drive(const Drive& drive, const VehicleData& vehicle,
                              const rsi::Parameters& parameters);

// time_s, counts (0 or 1), and of each quantity NAME_measured, NAME_lower, NAME_upper, NAME_predicted.
std::string comparison_csv(const DriveComparison& comparison);

}  // namespace sil
