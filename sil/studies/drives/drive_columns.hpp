// Drive columns: which quantities a drive's CSV may hold, in which units, and what a header's name stands
// for.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sil/studies/drives/drive.hpp"

namespace sil {

struct DriveUnit {
    const char* suffix;  // of the column's name, after '_'
    double factor;       // from this unit to SI
};

// How much a quantity matters.
enum class DriveNeed : unsigned char {
    always,            // column and every value
    roll_angle,        // either this one ...
    roll_observation,  // ... or both of these
    optional
};

struct DriveQuantity {
    const char* name;
    const char* origin;  // a prefix that the name may bear ("sensor_"), as in a run's signals.csv
    DriveNeed need;
    std::vector<DriveUnit> units;
    double& (*value)(DriveSample& sample);
};

// In the order of docs/drives.md.
const std::vector<DriveQuantity>& drive_quantities();

// Meaning of a column's name.
struct DriveColumn {
    enum class Kind : unsigned char { unknown, wrong_unit, known } kind{Kind::unknown};
    const DriveQuantity* quantity{nullptr};  // unless unknown
    double factor{1.0};                      // when known
};

// `name` in any case, without blanks around it. `wrong_unit`: a known quantity followed by something that is
// none of its units ("roll_rate_rpm", "roll_rate", "roll_rate [deg/s]").
DriveColumn read_column_name(std::string_view name);

// "roll_rate_degps or roll_rate_radps".
std::string admitted_names(const DriveQuantity& quantity);

}  // namespace sil
