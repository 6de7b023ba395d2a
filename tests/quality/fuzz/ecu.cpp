// The whole ECU on an in-memory bus: any frames, lengths, counters and times, good and damaged ones, floods,
// missed cycles, states of the bus. For any input, each cycle sends every frame, protected and with defined
// signals, and never anything but "unavailable" when no good Imu frame came within the last 50 ms.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <string_view>
#include <type_traits>
#include <vector>

#include "hal/memory/memory_bus.hpp"
#include "hal/memory/virtual_clock.hpp"
#include "rsi/can_dbc/codec/message.hpp"
#include "rsi/can_dbc/generated/rollover_warning.hpp"
#include "rsi/ecu/application/rollover_ecu.hpp"
#include "tests/application/end_to_end.hpp"
#include "tests/quality/fuzz/support/any_calibration.hpp"
#include "tests/quality/fuzz/support/byte_reader.hpp"
#include "tests/quality/fuzz/support/require.hpp"
#include "tests/support/large_suv.h"

// Length of firmware/calibrations/generated/large_suv.c.
extern "C" const unsigned char rsi_parameter_section[];

namespace {

using fuzz::ByteReader;
using fuzz::require;
using rsi::can_dbc::RolloverStatus;
using rsi::can_dbc::RolloverWarning;
using testing_application::protect;

constexpr int most_cycles = 64;
// Cycles of a recovery: holds of at most 1 s, faults that heal after 1 s, a filter with a lag of 4 s; then
// for so long.
constexpr int longest_recovery = 3000;
constexpr int lasting = 100;
constexpr rsi::hal::Time longest_silence = rsi::hal::Time::from_milliseconds(50);
constexpr rsi::hal::Time never = rsi::hal::Time::from_milliseconds(-1'000'000);

struct NoWatchdog final : rsi::hal::Watchdog {
    void feed() noexcept override {}
};

// Layout of a sensor's frame, by its number; the signals begin behind the two bytes of the protection.
struct SensorFrame {
    std::uint32_t identifier;
    std::uint16_t data_id;
};
constexpr std::array<SensorFrame, 3> sensor_frames{
    {{rsi::can_dbc::Imu::identifier, rsi::can_dbc::Imu::e2e_data_id},
     {rsi::can_dbc::RollAngle::identifier, rsi::can_dbc::RollAngle::e2e_data_id},
     {rsi::can_dbc::VehicleMotion::identifier, rsi::can_dbc::VehicleMotion::e2e_data_id}}};

// Straight on at 80 km/h: f_z 9.806 m/s^2; bank not available; the rest zero.
constexpr std::array<std::array<std::uint8_t, 8>, 3> calm_payloads{{{0U, 0U, 0U, 0U, 0x27U, 0x13U, 0U, 0U},
                                                                    {0U, 0U, 0U, 0U, 0x80U, 0U, 0U, 0U},
                                                                    {0U, 0U, 0x40U, 0x1FU, 0U, 0U, 0U, 0U}}};

std::int16_t little_endian_at(const rsi::hal::CanFrame& frame, std::size_t at) {
    return static_cast<std::int16_t>(frame.data[at] | (frame.data[at + 1U] << 8U));
}

// An Imu frame that a receiver may use, read without the codec: undamaged, and with the two signals without
// which there is no warning (60 m/s^2 and 300 deg/s are code 30000).
bool is_good_imu(const rsi::hal::CanFrame& frame) {
    return !frame.extended && !frame.flexible_data_rate && frame.identifier == 0x120U && frame.length == 8U &&
           testing_application::is_profile_11(frame, 0x3A7U) &&
           testing_application::counter_of(frame) <= 14U &&
           std::abs(int{little_endian_at(frame, 2U)}) <= 30000 &&
           std::abs(int{little_endian_at(frame, 6U)}) <= 30000;
}

using Section = std::array<std::uint8_t, rsi::application::section::length>;

// A good one, of which some bytes have changed.
Section any_section(ByteReader& bytes) {
    Section section{};
    std::copy_n(&rsi_parameter_section[0], section.size(), section.begin());
    for (unsigned changes = bytes.below(4U); changes > 0U; --changes) {
        section[bytes.take<std::uint16_t>() % section.size()] = bytes.take<std::uint8_t>();
    }
    return section;
}

rsi::Parameters any_parameters(ByteReader& bytes) {
    rsi::Parameters parameters = rsi_test_large_suv();
    if (fuzz::choose_any(parameters, bytes)) {
        parameters.warning_confirmation_s = 0.0F;
    }
    return parameters;
}

// One input in 64. A recovery takes longer than all the rest; drawn by the whole input, because the search
// keeps whatever byte or length brings one.
bool is_drawn(const std::uint8_t* data, std::size_t size) {
    const std::string_view input{reinterpret_cast<const char*>(data), size};
    return std::hash<std::string_view>{}(input) % 64U == 0U;
}

class World {
 public:
    explicit World(ByteReader& bytes) : bytes_{bytes} { start(); }

    void run(bool with_recovery) {
        while (!bytes_.empty() && cycles_ < most_cycles) {
            next_event();
        }
        if (with_recovery) {
            recover();
        }
    }

 private:
    void start() {
        switch (bytes_.below(4U)) {
            case 0U: {
                const Section section = any_section(bytes_);
                accepted_ = ecu_.init(section.data(), section.size()).refusal ==
                            rsi::application::ParametersRefusal::none;
                break;
            }
            case 1U:  // not started at all
                accepted_ = false;
                break;
            default:
                accepted_ = ecu_.init(any_parameters(bytes_)).accepted == 1;
        }
    }

    void next_event() {
        const unsigned control = bytes_.take<std::uint8_t>();
        const unsigned sensor = (control >> 4U) % 3U;
        switch (control % 16U) {
            case 0U:
            case 1U:
                send_calm(sensor);
                break;
            case 2U:  // the payload before, with a new value for one signal
                bytes_.take_into(payloads_[sensor].data() + 2U + 2U * ((control >> 6U) % 3U), 2U);
                send_good(sensor);
                break;
            case 3U:
                bytes_.take_into(payloads_[sensor].data() + 2U, 6U);
                send_good(sensor);
                break;
            case 4U:  // lost, repeated, out of order, or the reserved counter
                counters_[sensor] = bytes_.below(16U);
                send_good(sensor);
                break;
            case 5U:
                send_damaged(sensor);
                break;
            case 6U:
                send_any();
                break;
            case 7U:
                clock_.advance(
                    rsi::hal::Time::from_milliseconds(static_cast<std::int64_t>(bytes_.below(256U))));
                break;
            case 8U:
                cycle(10, bytes_.one_in(2U) ? bytes_.take<std::uint32_t>() : bytes_.below(8U));
                break;
            case 9U:
                set_bus_state(static_cast<rsi::hal::BusState>(bytes_.below(4U)));
                break;
            case 10U:
                flood(bytes_.below(256U), (control >> 4U) % 4U);
                break;
            case 11U:  // the cycle comes early or late
                cycle(static_cast<std::int64_t>(bytes_.below(64U)), 0U);
                break;
            case 12U:
                hold(bytes_.below(16U));
                break;
            case 13U:
                drive_on(bytes_.below(32U));
                break;
            default:
                cycle(10, 0U);
        }
    }

    // The ECU must find back to "ready" from anything, once all is well, and stay there.
    void recover() {
        set_bus_state(rsi::hal::BusState::error_active);
        payloads_ = calm_payloads;
        // With a bank: where the roll angle is against the horizon, an accelerometer that was found wrong
        // cannot be found right without.
        payloads_[1][4] = 0U;
        int ready_cycles = 0;
        for (int count = 0; count < longest_recovery && ready_cycles < lasting; ++count) {
            stir();
            sway(count);
            send_good(0U);
            send_good(1U);
            send_good(2U);
            cycle(10, 0U);
            const bool ready = !accepted_ || state_ == RolloverWarning::State::ready;
            ready_cycles = ready ? ready_cycles + 1 : 0;
        }
        require(ready_cycles == lasting, "ready again once all is well");
    }

    // Along a road that rolls the body to and fro, by a degree in a second: frames that were late are
    // accepted again when angle and rate move together.
    void sway(int count) {
        const double turn = 2.0 * 3.14159265358979 * 0.01 * count;
        const auto angle = static_cast<std::uint16_t>(static_cast<std::int16_t>(200.0 * std::sin(turn)));
        const auto rate = static_cast<std::uint16_t>(static_cast<std::int16_t>(628.0 * std::cos(turn)));
        payloads_[1][2] = static_cast<std::uint8_t>(angle >> 8U);
        payloads_[1][3] = static_cast<std::uint8_t>(angle & 0xFFU);
        payloads_[0][6] = static_cast<std::uint8_t>(rate & 0xFFU);
        payloads_[0][7] = static_cast<std::uint8_t>(rate >> 8U);
    }

    // The least that a living sensor does: the last bit of each signal goes up and down. One that repeats
    // itself for ever stays "stuck" once it has been found so, and rightly.
    void stir() {
        for (const std::size_t at : {2U, 4U, 6U}) {
            payloads_[0][at] = static_cast<std::uint8_t>(payloads_[0][at] ^ 1U);
            payloads_[2][at] = static_cast<std::uint8_t>(payloads_[2][at] ^ 1U);
        }
    }

    void hold(unsigned count) {
        for (; count > 0U && cycles_ < most_cycles; --count) {
            cycle(10, 0U);
        }
    }

    // All sensors go on as they are.
    void drive_on(unsigned count) {
        for (; count > 0U && cycles_ < most_cycles; --count) {
            send_good(0U);
            send_good(1U);
            send_good(2U);
            cycle(10, 0U);
        }
    }

    void send(const rsi::hal::CanFrame& frame) {
        const bool heard =
            bus_state_ == rsi::hal::BusState::error_active || bus_state_ == rsi::hal::BusState::error_passive;
        if (world().send(frame) == rsi::hal::SendResult::sent && heard && is_good_imu(frame)) {
            last_good_imu_ = clock_.now();
        }
    }

    rsi::hal::CanFrame good_frame(unsigned sensor) {
        rsi::hal::CanFrame frame{};
        frame.identifier = sensor_frames[sensor].identifier;
        frame.length = 8U;
        std::copy(payloads_[sensor].begin(), payloads_[sensor].end(), frame.data.begin());
        protect(frame, sensor_frames[sensor].data_id, counters_[sensor]);
        counters_[sensor] = (counters_[sensor] + 1U) % 15U;
        return frame;
    }

    void send_good(unsigned sensor) { send(good_frame(sensor)); }

    void send_calm(unsigned sensor) {
        payloads_[sensor] = calm_payloads[sensor];
        send_good(sensor);
    }

    // A good frame with something wrong: a bit, the length, the format, another frame's identifier.
    void send_damaged(unsigned sensor) {
        rsi::hal::CanFrame frame = good_frame(sensor);
        const unsigned change = bytes_.below(128U);
        if (change < 64U) {
            frame.data[change / 8U] =
                static_cast<std::uint8_t>(frame.data[change / 8U] ^ (1U << (change % 8U)));
        } else if (change < 80U) {
            frame.length = static_cast<std::uint8_t>(change - 64U);
            frame.flexible_data_rate = frame.length > 8U;
        } else if (change < 90U) {
            frame.extended = true;
        } else if (change < 100U) {
            frame.flexible_data_rate = true;
        } else {
            frame.identifier = sensor_frames[change % 3U].identifier;
        }
        send(frame);
    }

    void send_any() {
        rsi::hal::CanFrame frame{};
        const unsigned kind = bytes_.below(8U);
        frame.identifier =
            kind < 3U ? sensor_frames[kind].identifier : bytes_.take<std::uint32_t>() & 0x1FFFFFFFU;
        frame.extended = bytes_.one_in(4U);
        frame.flexible_data_rate = bytes_.one_in(4U);
        frame.length = static_cast<std::uint8_t>(bytes_.below(70U));
        bytes_.take_into(frame.data.data(), std::min<std::size_t>(frame.length, frame.data.size()));
        send(frame);
    }

    // More than is read in one cycle, and more than the bus holds.
    void flood(unsigned count, unsigned kind) {
        rsi::hal::CanFrame foreign{};
        foreign.identifier = 0x3FFU;
        for (; count > 0U; --count) {
            if (kind < 3U) {
                send_good(kind);
            } else {
                send(foreign);
            }
        }
    }

    void set_bus_state(rsi::hal::BusState state) {
        bus_state_ = state;
        bus_.endpoint(0U).set_state(state);
    }

    void cycle(std::int64_t milliseconds, std::uint32_t missed) {
        clock_.advance(rsi::hal::Time::from_milliseconds(milliseconds));
        ecu_.step(missed);
        ++cycles_;
        missed_cycles_ = std::min<std::uint64_t>(missed_cycles_ + missed, 0xFFFFFFFFU);
        frames_.clear();
        rsi::hal::CanFrame frame{};
        while (world().receive(frame) == rsi::hal::ReceiveResult::frame) {
            require(find(frame.identifier) == nullptr, "no frame is sent twice in a cycle");
            frames_.push_back(frame);
        }
        const bool can_send =
            bus_state_ == rsi::hal::BusState::error_active || bus_state_ == rsi::hal::BusState::error_passive;
        if (!can_send) {
            require(frames_.empty(), "nothing comes from an ECU that cannot send");
            counters_known_ = false;
            return;
        }
        judge(missed);
        counters_known_ = true;
    }

    void judge(std::uint32_t missed) {
        RolloverWarning warning;
        RolloverStatus status;
        rsi::can_dbc::MessagesFromRolloverEcu::visit([&](auto type) {
            using Message = typename decltype(type)::Type;
            [[maybe_unused]] const Message message = judged<Message>();
            if constexpr (std::is_same_v<Message, RolloverWarning>) {
                warning = message;
            } else if constexpr (std::is_same_v<Message, RolloverStatus>) {
                status = message;
            }
        });
        require(frames_.front().identifier == RolloverWarning::identifier, "the warning is sent first");
        require(frames_.back().identifier == RolloverStatus::identifier, "the status is sent last");

        using State = RolloverWarning::State;
        state_ = warning.state;
        const bool available = warning.state != State::unavailable;
        const bool sided = warning.state == State::advisory || warning.state == State::warning;
        require(sided || (warning.side == RolloverWarning::Side::none), "only a risk has a side");
        require(accepted_ || !available, "unavailable without good parameters");
        require(status.parameters_invalid == !accepted_, "refused parameters are reported");
        require((warning.parameters_refusal == RolloverWarning::ParametersRefusal::none) == accepted_,
                "the reason of a refusal is given");
        require(missed <= 2U || !available, "unavailable after a stall");
        require(status.cycle_overrun == (missed > 0U), "an overrun is reported");
        require(status.cycle_overruns == std::min<std::uint64_t>(missed_cycles_, 255U),
                "overruns are counted");

        const bool silent = longest_silence < clock_.now() - last_good_imu_;
        require(!silent || !available, "unavailable when no good Imu came within 50 ms");
        require(!silent || status.imu_timeout || status.imu_signal_invalid, "a missing Imu is reported");
        require(!available || !status.imu_timeout, "available only with a fresh Imu");
        require(status.frames_rejected >= frames_rejected_ && status.frames_lost >= frames_lost_,
                "what was counted is not forgotten");
        frames_rejected_ = status.frames_rejected;
        frames_lost_ = status.frames_lost;
    }

    // The frame with this identifier that the last cycle sent, if there is one.
    const rsi::hal::CanFrame* find(std::uint32_t identifier) const {
        for (const rsi::hal::CanFrame& frame : frames_) {
            if (frame.identifier == identifier) {
                return &frame;
            }
        }
        return nullptr;
    }

    // The message, after its frame was found to be whole.
    template <typename Message>
    Message judged() {
        const rsi::hal::CanFrame* const found = find(Message::identifier);
        require(found != nullptr, "every frame is sent in every cycle");
        const rsi::hal::CanFrame& frame = *found;
        require(!frame.extended && !frame.flexible_data_rate && frame.length == Message::length,
                "a frame has its format");
        require(testing_application::is_profile_11(frame, Message::e2e_data_id), "a frame is protected");
        judge_counter(Message::identifier, testing_application::counter_of(frame));

        const rsi::can_dbc::Decoded<Message> decoded = rsi::can_dbc::decode<Message>(frame.data);
        Message::visit_signals([&](const char*, const char*, auto, auto status) {
            require(decoded.status.*status != rsi::can_dbc::SignalStatus::out_of_range,
                    "no undefined signal is sent");
        });
        if constexpr (std::is_same_v<Message, RolloverWarning>) {
            require(decoded.value.state == RolloverWarning::State::unavailable || decoded.status.all_valid(),
                    "a statement on the risk comes with its numbers");
        }
        return decoded.value;
    }

    void judge_counter(std::uint32_t identifier, unsigned counter) {
        unsigned& before = sent_counters_[identifier];
        if (counters_known_) {
            require(counter == (before + 1U) % 15U, "the counter goes up by one");
        }
        require(counter <= 14U, "the counter is one that a sender may use");
        before = counter;
    }

    rsi::hal::MemoryBus<2U, 80U>::Endpoint& world() { return bus_.endpoint(1U); }

    ByteReader& bytes_;
    rsi::hal::VirtualClock clock_;
    rsi::hal::MemoryBus<2U, 80U> bus_{clock_};
    NoWatchdog watchdog_;
    rsi::application::RolloverEcu ecu_{bus_.endpoint(0U), clock_, watchdog_};
    rsi::hal::BusState bus_state_{rsi::hal::BusState::error_active};

    std::array<std::array<std::uint8_t, 8>, 3> payloads_{calm_payloads};
    std::array<unsigned, 3> counters_{};
    rsi::hal::Time last_good_imu_{never};

    bool accepted_{false};
    int cycles_{0};
    std::uint64_t missed_cycles_{0U};
    std::vector<rsi::hal::CanFrame> frames_{};     // of the last cycle, in the order of sending
    std::array<unsigned, 0x800> sent_counters_{};  // by identifier, of 11 bits
    bool counters_known_{false};
    RolloverWarning::State state_{};
    unsigned frames_rejected_{0U};
    unsigned frames_lost_{0U};
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    ByteReader bytes{data, size};
    World{bytes}.run(is_drawn(data, size));
    return 0;
}
