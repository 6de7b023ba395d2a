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

// |LTR| by the data sheet and the measured forces, [(m_s h + m_u h_u) f - Ixx phi''] / (m N c_w/2): nothing
// of a calibration is in it. The body's arm is taken from the road on, which in slow turns is the most.
double load_transfer_by_heights(const VehicleData& vehicle, const RollSample& sample);

// `cycles` must not be empty.
Cut find_cut(const Drive& drive, const Cycles& cycles, const VehicleData& vehicle,
             const PreparationOptions& options, const SensorOffsets& offsets);

}  // namespace sil
