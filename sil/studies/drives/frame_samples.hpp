// Frame samples: between a drive's samples and the sensors' frames.
#pragma once

#include "hal/interface/can_bus.hpp"
#include "sil/studies/drives/drive.hpp"
#include "sil/world/sensors/sensor_sample.hpp"

namespace sil {

// Content of SensorFrames.
SensorSample sensor_sample(const DriveSample& sample);

// Takes over what a sensor frame says; other frames change nothing. Its end-to-end protection is not checked:
// that is the firmware's business.
void take_frame(const hal::CanFrame& frame, DriveSample& sample);

}  // namespace sil
