// The image's part in the reaction to a fault: one warning frame "unavailable".
#include "hal/zynqmp_r5/startup/exceptions.hpp"
#include "images/zynqmp_r5/ecu_image.hpp"
#include "images/zynqmp_r5/warning_recorder.hpp"
#include "rsi/can_dbc/codec/message.hpp"
#include "rsi/can_dbc/e2e/profile_11.hpp"
#include "rsi/can_dbc/generated/rollover_warning.hpp"

namespace {

// Register accesses to wait for: some 20 ms on silicon at 100 ns each, time for all 64 frames of the FIFO at
// 500 kbit/s.
constexpr std::uint32_t most_polls = 200'000U;

rsi::hal::CanFrame unavailable() {
    using rsi::can_dbc::RolloverWarning;
    RolloverWarning message{};
    message.state = RolloverWarning::State::unavailable;
    message.side = RolloverWarning::Side::none;
    message.warning_level = rsi::can_dbc::not_available;
    message.lateral_acceleration_mps2 = rsi::can_dbc::not_available;
    message.lateral_acceleration_threshold_mps2 = rsi::can_dbc::not_available;
    auto payload = rsi::can_dbc::encode(message);
    rsi::can_dbc::e2e::protect_profile_11(payload, RolloverWarning::e2e_data_id,
                                          rsi::image::last_warning().next_counter());

    rsi::hal::CanFrame frame{};
    frame.identifier = RolloverWarning::identifier;
    frame.length = RolloverWarning::length;
    for (std::size_t byte = 0U; byte < payload.size(); ++byte) {
        frame.data[byte] = payload[byte];
    }
    return frame;
}

rsi::image::LastWarning last;

}  // namespace

rsi::image::LastWarning& rsi::image::last_warning() noexcept {
    return last;
}

void rsi::hal::zynqmp_r5::on_fault(const Fault&) noexcept {
    static_cast<void>(rsi::image::Controller::send_last(MemoryMappedRegisters{}, unavailable(), most_polls));
}
