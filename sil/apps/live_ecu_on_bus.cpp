#include "sil/apps/live_ecu_on_bus.hpp"

#include "hal/linux/steady_clock.hpp"
#include "sil/apps/open_socket.hpp"

namespace sil {
namespace {

// The ECU runs on its own clock; what it sends between two cycles is read in the later one, and was received
// when the socket says.
class BusPace final : public Pace {
 public:
    void begin_cycle(std::uint32_t number) override {
        ahead_ = hal::Time{number * cycle_time.nanoseconds} - clock_.now();
    }
    void frames_sent(std::uint32_t) override {}
    bool wait_for_answer(std::uint32_t) override { return false; }
    double reception_time_s(const hal::CanFrame& frame) const override {
        return static_cast<double>((frame.receive_time + ahead_).nanoseconds) * 1.0e-9;
    }

 private:
    hal::SteadyClock clock_;
    hal::Time ahead_{};  // of simulated time, to the clock
};

class OnBus final : public LiveEcu {
 public:
    explicit OnBus(const std::string& interface) { open_or_throw(socket_, interface); }

    hal::CanBus& bus() override { return socket_; }
    Pace& pace() override { return pace_; }
    const rsi::Outputs* outputs() const override { return nullptr; }

 private:
    hal::SocketCanBus socket_;
    BusPace pace_;
};

}  // namespace

std::unique_ptr<LiveEcu> live_ecu_on_bus(const std::string& interface) {
    return std::make_unique<OnBus>(interface);
}

}  // namespace sil
