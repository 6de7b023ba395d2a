#include "sil/live/live_ecu.hpp"

#include "sil/simulation/in_process_ecu.hpp"
#include "sil/simulation/in_process_pace.hpp"

namespace sil {
namespace {

class InProcess final : public LiveEcu {
 public:
    explicit InProcess(const rsi::Parameters& calibration) : firmware_{calibration} {}

    rsi::hal::CanBus& bus() override { return firmware_.world_bus(); }
    Pace& pace() override { return pace_; }
    const rsi::Outputs* outputs() const override { return &firmware_.ecu().outputs(); }

 private:
    InProcessEcu firmware_;
    InProcessPace pace_{firmware_};
};

}  // namespace

std::unique_ptr<LiveEcu> live_ecu_in_process(const rsi::Parameters& calibration) {
    return std::make_unique<InProcess>(calibration);
}

}  // namespace sil
