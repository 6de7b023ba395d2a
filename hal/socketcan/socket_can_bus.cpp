// SocketCAN bus: receiving, sending, and coming back after the interface was down.
#include "hal/socketcan/socket_can_bus.hpp"

#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "hal/linux/steady_clock.hpp"
#include "hal/linux/timespec.hpp"
#include "hal/socketcan/frame_translation.hpp"
#include "rsi/hal/saturating_count.hpp"
#include "rsi/hal/well_formed.hpp"

namespace rsi::hal {
namespace {

// A flood of error frames must not hold up the caller: after so many, receive() says `empty` and goes on next
// time.
constexpr int most_frames_skipped_per_call{64};
constexpr Time recovery_interval{Time::from_milliseconds(100)};

Time now_on(clockid_t clock) noexcept {
    timespec value{};
    clock_gettime(clock, &value);
    return to_time(value);
}

can_filter exact_filter(const CanIdentifier& identifier) noexcept {
    // The two flags in the mask keep remote frames out, and frames of the other identifier length.
    const canid_t flags = CAN_EFF_FLAG | CAN_RTR_FLAG;
    return identifier.extended ? can_filter{identifier.value | CAN_EFF_FLAG, CAN_EFF_MASK | flags}
                               : can_filter{identifier.value, CAN_SFF_MASK | flags};
}

constexpr can_filter every_data_frame{0U, CAN_RTR_FLAG};

OpenFailure copy_filters(const SocketCanSettings& from, CanSocketSettings& to) noexcept {
    if (from.identifier_count > most_receive_filters) {
        return OpenFailure::identifiers;
    }
    for (std::size_t i = 0U; i < from.identifier_count; ++i) {
        if (!is_identifier_possible(from.identifiers[i].value, from.identifiers[i].extended)) {
            return OpenFailure::identifiers;
        }
        to.filters[i] = exact_filter(from.identifiers[i]);
    }
    to.filter_count = from.identifier_count;
    if (to.filter_count == 0U) {
        to.filters[0] = every_data_frame;
        to.filter_count = 1U;
    }
    return OpenFailure::none;
}

OpenFailure copy_name(const char* from, CanSocketSettings& to) noexcept {
    const std::size_t length = from == nullptr ? 0U : std::strlen(from);
    if (length == 0U || length >= to.interface_name.size()) {
        return OpenFailure::interface_name;
    }
    std::memcpy(to.interface_name.data(), from, length);
    return OpenFailure::none;
}

}  // namespace

SocketCanBus::~SocketCanBus() {
    close();
}

OpenResult SocketCanBus::open(const SocketCanSettings& settings) noexcept {
    close();
    const char* shown_name = settings.interface_name == nullptr ? "" : settings.interface_name;
    CanSocketSettings wanted;
    OpenFailure failure = copy_name(settings.interface_name, wanted);
    if (failure == OpenFailure::none) {
        failure = copy_filters(settings, wanted);
    }
    if (failure != OpenFailure::none) {
        return describe_open_failure(failure, 0, shown_name);
    }
    wanted.receive_buffer_bytes = settings.receive_buffer_bytes;
    wanted.receive_own_frames = settings.receive_own_frames;

    const Time before = now_on(CLOCK_MONOTONIC);
    const CanSocketResult opened = open_can_socket(wanted);
    if (opened.failure != OpenFailure::none) {
        return describe_open_failure(opened.failure, opened.system_error, shown_name);
    }
    settings_ = wanted;
    bit_rate_switch_ = settings.bit_rate_switch;
    restart_when_bus_off_ = settings.restart_when_bus_off;
    bus_off_ = BusOffReport{};
    bus_off_schedule_.reset();
    statistics_ = BusStatistics{};
    descriptor_ = opened.descriptor;
    is_open_ = true;
    vanished_ = false;
    drop_count_ = 0U;
    last_empty_ = before;
    state_ = BusState::error_active;
    return OpenResult{};
}

void SocketCanBus::close() noexcept {
    if (descriptor_ >= 0) {
        ::close(descriptor_);
    }
    descriptor_ = -1;
    is_open_ = false;
    state_ = BusState::closed;
}

ReceiveResult SocketCanBus::receive(CanFrame& frame) noexcept {
    if (!is_usable()) {
        return ReceiveResult::failed;
    }
    follow_bus_off();
    for (int skipped = 0; skipped < most_frames_skipped_per_call; ++skipped) {
        canfd_frame kernel_frame{};
        const Time before = now_on(CLOCK_MONOTONIC);
        const ReadResult read = read_frame(descriptor_, kernel_frame);
        if (read.system_error == EAGAIN) {
            last_empty_ = before;
            return ReceiveResult::empty;
        }
        if (read.system_error != 0) {
            return after_read_error(read.system_error);
        }
        if (read.has_drop_count) {
            take_drop_count(read.drop_count);
        }
        const KernelFrameKind kind = kind_of(kernel_frame, read.bytes);
        if (kind == KernelFrameKind::error) {
            take_error_frame(kernel_frame);
        } else if (kind == KernelFrameKind::data) {
            frame = from_kernel(kernel_frame, read.bytes, receive_time_of(read));
            count_up(statistics_.frames_received);
            take_sign_of_life();
            return ReceiveResult::frame;
        }
    }
    return ReceiveResult::empty;
}

SendResult SocketCanBus::send(const CanFrame& frame) noexcept {
    if (!is_usable() || state_ == BusState::bus_off || !is_well_formed(frame)) {
        return send_failed(SendResult::failed);
    }
    canfd_frame kernel_frame;
    const std::size_t bytes = to_kernel(frame, bit_rate_switch_, kernel_frame);
    if (::send(descriptor_, &kernel_frame, bytes, MSG_DONTWAIT) == static_cast<ssize_t>(bytes)) {
        count_up(statistics_.frames_sent);
        return SendResult::sent;
    }
    switch (errno) {
        case EAGAIN:
        case ENOBUFS:  // the interface's transmit queue is full
            return send_failed(SendResult::full);
        case ENETDOWN:
        case ENODEV:
        case ENXIO:
            lose_interface(errno);
            return send_failed(SendResult::failed);
        default:  // among them EINVAL: a CAN FD frame on a classic interface
            return send_failed(SendResult::failed);
    }
}

ReceiveResult SocketCanBus::after_read_error(int system_error) noexcept {
    if (system_error == EINTR) {
        return ReceiveResult::empty;
    }
    lose_interface(system_error);
    return ReceiveResult::failed;
}

void SocketCanBus::take_error_frame(const canfd_frame& error_frame) noexcept {
    count_up(statistics_.error_frames);
    if (tells_of_lost_frame(error_frame)) {
        count_up(statistics_.frames_lost);
    }
    const BusState before = state_;
    state_ = state_after_error(error_frame, before);
    if (state_ == BusState::bus_off && before != BusState::bus_off) {
        count_up(bus_off_.times);
        restart_at_ = now_on(CLOCK_MONOTONIC) + bus_off_schedule_.next();
    }
}

// A bus-off node receives nothing, so another process has restarted it; but if this bus does that, the frame
// may be a late one, and accepting it would mean to stay bus-off.
void SocketCanBus::take_sign_of_life() noexcept {
    if (state_ != BusState::bus_off) {
        bus_off_schedule_.reset();
    } else if (!restart_when_bus_off_ || left_to_kernel_) {
        state_ = BusState::error_active;
    }
}

void SocketCanBus::follow_bus_off() noexcept {
    if (!restart_when_bus_off_ || state_ != BusState::bus_off) {
        return;
    }
    const Time now = now_on(CLOCK_MONOTONIC);
    if (now < restart_at_) {
        return;
    }
    const ControllerRestartResult restart = restart_controller(settings_.interface_name);
    bus_off_.refusal = restart.system_error;
    left_to_kernel_ = restart.outcome == ControllerRestart::left_to_kernel;
    if (restart.outcome == ControllerRestart::done) {
        count_up(bus_off_.restarts);
    }
    if (restart.outcome == ControllerRestart::done || restart.outcome == ControllerRestart::not_bus_off) {
        state_ = BusState::error_active;
    } else {
        restart_at_ = now + bus_off_schedule_.next();
    }
}

void SocketCanBus::take_drop_count(std::uint32_t drop_count) noexcept {
    count_up(statistics_.frames_lost,
             drop_count - drop_count_);  // the kernel's counter wraps, and so does this
    drop_count_ = drop_count;
}

Time SocketCanBus::receive_time_of(const ReadResult& read) const noexcept {
    const Time wall_now = now_on(CLOCK_REALTIME);
    const Time monotonic_now = now_on(CLOCK_MONOTONIC);
    return read.has_wall_stamp ? monotonic_receive_time(read.wall_stamp, wall_now, monotonic_now, last_empty_)
                               : monotonic_now;
}

SendResult SocketCanBus::send_failed(SendResult result) noexcept {
    count_up(statistics_.send_failures);
    return result;
}

void SocketCanBus::lose_interface(int system_error) noexcept {
    // A vanished interface takes the socket's binding and filters with it; one that is down keeps both.
    vanished_ = vanished_ || system_error == ENODEV || system_error == ENXIO;
    state_ = BusState::closed;
    next_recovery_ = now_on(CLOCK_MONOTONIC);
}

bool SocketCanBus::is_usable() noexcept {
    return is_open_ && (state_ != BusState::closed || try_recovery());
}

bool SocketCanBus::try_recovery() noexcept {
    const Time now = now_on(CLOCK_MONOTONIC);
    if (now < next_recovery_) {
        return false;
    }
    next_recovery_ = now + recovery_interval;
    if (vanished_) {
        const CanSocketResult again = open_can_socket(settings_);
        if (again.failure != OpenFailure::none) {
            return false;
        }
        ::close(descriptor_);
        descriptor_ = again.descriptor;
        drop_count_ = 0U;
        vanished_ = false;
    } else if (!look_up_interface(settings_.interface_name).is_up) {
        return false;
    }
    state_ = BusState::error_active;
    return true;
}

bool SocketCanBus::wait_for_frame(Time longest) const noexcept {
    constexpr std::int64_t nanoseconds_per_millisecond{1'000'000};
    pollfd item{descriptor_, POLLIN, 0};
    const std::int64_t milliseconds =
        (longest.nanoseconds + nanoseconds_per_millisecond - 1) / nanoseconds_per_millisecond;
    return poll(&item, 1, static_cast<int>(milliseconds)) > 0;
}

int SocketCanBus::receive_buffer_bytes() const noexcept {
    int bytes = 0;
    socklen_t size = sizeof(bytes);
    return getsockopt(descriptor_, SOL_SOCKET, SO_RCVBUF, &bytes, &size) == 0 ? bytes : 0;
}

}  // namespace rsi::hal
