// rsi-ecu-r5f: the firmware on the Cortex-R5F of the Zynq UltraScale+ MPSoC.
#include "images/zynqmp_r5/ecu_image.hpp"
#include "images/zynqmp_r5/warning_recorder.hpp"

namespace {

image::EcuImage<image::WarningRecorder> ecu;

}  // namespace

int main() {
    ecu.run(image::can_settings());
}
