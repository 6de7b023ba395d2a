#include "sil/apps/ecu_loop.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdio>
#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include "hal/linux/periodic_tick.hpp"
#include "hal/linux/real_time.hpp"
#include "hal/linux/software_watchdog.hpp"
#include "hal/linux/steady_clock.hpp"
#include "hal/memory/virtual_clock.hpp"
#include "hal/socketcan/socket_can_bus.hpp"
#include "sil/apps/accessible_ecu.hpp"
#include "sil/simulation/lock_step_receiver.hpp"
#include "sil/simulation/pace.hpp"
#include "sil/simulation/simulation.hpp"

namespace sil {
namespace {

constexpr rsi::hal::Time watchdog_limit = rsi::hal::Time::from_milliseconds(500);

void open_or_throw(rsi::hal::SocketCanBus& bus, const EcuRequest& request) {
    std::vector<rsi::hal::CanIdentifier> identifiers;
    for (const std::uint32_t value : rsi::application::received_identifiers) {
        identifiers.push_back({value, false});
    }
    for (const std::uint32_t value : rsi::application::sent_identifiers) {
        identifiers.push_back({value, false});
    }
    if (request.xcp) {
        identifiers.push_back({rsi::xcp::default_identifiers.command, false});
    }
    if (request.diagnosis) {
        identifiers.push_back({rsi::diagnosis::Addresses{}.physical_request, false});
        identifiers.push_back({rsi::diagnosis::Addresses{}.functional_request, false});
    }
    if (request.lock_step) {
        identifiers.push_back({simulation_dbc::SimulationSync::identifier, false});
    }

    rsi::hal::SocketCanSettings settings;
    settings.interface_name = request.interface.c_str();
    settings.identifiers = identifiers.data();
    settings.identifier_count = request.receive_everything ? 0U : identifiers.size();
    settings.restart_when_bus_off = !request.lock_step;  // simulated time knows no bus-off
    const rsi::hal::OpenResult opened = bus.open(settings);
    if (!opened) {
        throw std::runtime_error(opened.message());
    }
}

const char* describe(rsi::hal::BusState state) {
    constexpr std::array words{"error-active again", "error-passive", "bus-off", "down or gone"};
    return words[static_cast<std::size_t>(state)];
}

// Tells the user when the bus fails, when it is back, and what keeps it away.
class BusStateReport {
 public:
    explicit BusStateReport(const std::string& interface) : interface_{interface} {}

    // Once a cycle. Prints a line when the state is not what it was, and when a restart is refused for
    // another reason than the last one.
    void follow(const rsi::hal::SocketCanBus& bus);

 private:
    const std::string& interface_;
    rsi::hal::BusState state_{rsi::hal::BusState::error_active};
    int refusal_{0};
};

void BusStateReport::follow(const rsi::hal::SocketCanBus& bus) {
    const rsi::hal::BusState state = bus.state();
    const int refusal = bus.bus_off_report().refusal;
    if (state == state_ && refusal == refusal_) {
        return;
    }
    if (state != state_) {
        fmt::print("rsi-ecu: {} is {}\n", interface_, describe(state));
    }
    if (refusal != 0 && refusal != refusal_) {
        fmt::print(
            "rsi-ecu: {} cannot be restarted: {}. Next: run rsi-ecu as root or with CAP_NET_ADMIN, or let "
            "the "
            "kernel do it: ip link set {} type can restart-ms 100\n",
            interface_, std::generic_category().message(refusal), interface_);
    }
    std::fflush(stdout);
    state_ = state;
    refusal_ = refusal;
}

void say_listening(const EcuRequest& request, const AccessibleEcu& ecu) {
    const std::string stored =
        ecu.has_stored() ? fmt::format(", with what XCP has stored in {}", request.xcp_storage) : "";
    fmt::print("rsi-ecu: listening on {}{}{}\n", request.interface, request.lock_step ? ", in lock-step" : "",
               stored);
    std::fflush(stdout);
}

double to_ms(rsi::hal::Time time) {
    return static_cast<double>(time.nanoseconds) * 1.0e-6;
}

void print_punctuality(const rsi::hal::PeriodicTick<rsi::hal::SteadyClock>& tick,
                       const rsi::hal::SocketCanBus& bus) {
    const rsi::hal::DurationHistogram& lateness = tick.lateness();
    const rsi::hal::BusStatistics statistics = bus.statistics();
    fmt::print(
        "rsi-ecu: {} cycles, {} overruns, {} missed; woken late by median {:.3f} ms, 99th percentile {:.3f} "
        "ms, "
        "largest {:.3f} ms\n",
        tick.ticks(), tick.overruns(), tick.missed_periods(), to_ms(lateness.quantile(0.5)),
        to_ms(lateness.quantile(0.99)), to_ms(lateness.largest()));
    fmt::print("rsi-ecu: {} frames received, {} sent, {} lost, {} error frames\n", statistics.frames_received,
               statistics.frames_sent, statistics.frames_lost, statistics.error_frames);
    const rsi::hal::BusOffReport bus_off = bus.bus_off_report();
    if (bus_off.times != 0U) {
        fmt::print("rsi-ecu: {} times bus-off, {} restarts\n", bus_off.times, bus_off.restarts);
    }
}

void run_in_real_time(const EcuRequest& request, const rsi::Parameters& parameters, const Accesses& accesses,
                      rsi::hal::SocketCanBus& bus, const volatile std::sig_atomic_t& end_requested) {
    rsi::hal::SteadyClock clock;
    rsi::hal::SoftwareWatchdog watchdog{clock, watchdog_limit};
    std::optional<AccessibleEcu> ecu;
    ecu.emplace(bus, clock, watchdog, parameters, accesses, true);
    const rsi::hal::RealTimeResult real_time =
        rsi::hal::enter_real_time({request.fifo_priority, request.lock_memory});
    if (!real_time) {
        throw std::runtime_error(real_time.message());
    }
    say_listening(request, *ecu);
    BusStateReport bus_state{request.interface};
    rsi::hal::PeriodicTick<rsi::hal::SteadyClock> tick{clock, cycle_time};
    while (end_requested == 0) {
        ecu->step(tick.wait());
        tick.shift(ecu->cycle_shift());
        if (ecu->is_reset_requested()) {
            fmt::print("rsi-ecu: a tester resets it\n");
            ecu.emplace(bus, clock, watchdog, parameters, accesses, false);
        }
        bus_state.follow(bus);
        if (watchdog.expired()) {
            throw std::runtime_error("the watchdog expired: a cycle took longer than 500 ms");
        }
    }
    ecu->stop();
    print_punctuality(tick, bus);
}

void run_in_lock_step(const EcuRequest& request, const rsi::Parameters& parameters, const Accesses& accesses,
                      rsi::hal::SocketCanBus& socket, const volatile std::sig_atomic_t& end_requested) {
    rsi::hal::VirtualClock clock;
    LockStepReceiver<256U> bus{socket, clock};
    rsi::hal::SoftwareWatchdog watchdog{clock, watchdog_limit};
    std::optional<AccessibleEcu> ecu;
    ecu.emplace(bus, clock, watchdog, parameters, accesses, true);
    say_listening(request, *ecu);
    while (end_requested == 0) {
        // Short enough to notice a request to end, long enough to cost nothing.
        if (!socket.wait_for_frame(rsi::hal::Time::from_milliseconds(100))) {
            continue;
        }
        while (bus.cycle_is_complete()) {
            // A new run must not see what the ECU has learnt and counted in the one before.
            if (bus.run_begins()) {
                ecu.emplace(bus, clock, watchdog, parameters, accesses, true);
            }
            ecu->step(0U);
            if (ecu->is_reset_requested()) {
                ecu.emplace(bus, clock, watchdog, parameters, accesses, false);
            }
        }
    }
    ecu->stop();
}

}  // namespace

void run_ecu(const EcuRequest& request, const rsi::Parameters& parameters,
             const volatile std::sig_atomic_t& end_requested) {
    rsi::hal::SocketCanBus bus;
    std::optional<CalibrationAccess> access;
    if (request.xcp) {
        access.emplace(parameters, request.calibration_name, request.xcp_storage, request.key);
    }
    std::optional<DiagnosisAccess> workshop;
    if (request.diagnosis) {
        workshop.emplace(request.calibration_name, request.diagnosis_storage,
                         access ? &access->stored_section() : nullptr, request.key);
    }
    const Accesses given{access ? &*access : nullptr, workshop ? &*workshop : nullptr};
    open_or_throw(bus, request);
    if (request.lock_step) {
        run_in_lock_step(request, parameters, given, bus, end_requested);
    } else {
        run_in_real_time(request, parameters, given, bus, end_requested);
    }
}

}  // namespace sil
