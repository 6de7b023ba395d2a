// rsi-ecu-r5f: the firmware on the Cortex-R5F of the Zynq UltraScale+ MPSoC.
#include "images/zynqmp_r5/ecu_image.hpp"
#include "images/zynqmp_r5/warning_recorder.hpp"

namespace {

rsi::image::EcuImage<rsi::image::WarningRecorder> ecu;

}  // namespace

int main() {
    ecu.run(rsi::image::can_settings());
}
