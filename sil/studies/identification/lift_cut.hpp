// Lift cut: up to where a drive may be used, which is the first wheel lift or what may be one.
#pragma once

#include <optional>
#include <string>

#include "sil/studies/identification/drive_signals.hpp"
#include "sil/studies/identification/prepared_drive.hpp"

namespace sil {

struct Cut {
    std::optional<double> time_s;
    std::string reason;  // in words
    bool by_load_transfer{false};
};

// `cycles` must not be empty.
Cut find_cut(const Drive& drive, const Cycles& cycles, const VehicleData& vehicle,
             const PreparationOptions& options, const SensorOffsets& offsets);

}  // namespace sil
