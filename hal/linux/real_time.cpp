// Real time on sched_setscheduler and mlockall.
#include "hal/linux/real_time.hpp"

#include <sched.h>
#include <sys/mman.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace rsi::hal {
namespace {

constexpr int lowest_priority{1};
constexpr int highest_priority{99};

RealTimeResult refuse_priority(int priority) noexcept {
    RealTimeResult result;
    result.failure = RealTimeFailure::priority_out_of_range;
    std::snprintf(result.text.data(), result.text.size(),
                  "Real-time priority %d does not exist. Next: choose one from %d to %d, or 0 for none.",
                  priority, lowest_priority, highest_priority);
    return result;
}

RealTimeResult refused_scheduling(int system_error, int priority) noexcept {
    RealTimeResult result;
    result.failure = RealTimeFailure::scheduling;
    result.system_error = system_error;
    std::snprintf(result.text.data(), result.text.size(),
                  "Real-time priority %d (SCHED_FIFO) was refused: %s. Next: run as root, or grant it with "
                  "`setcap cap_sys_nice=ep PROGRAM` or an `rtprio` line in /etc/security/limits.conf.",
                  priority, std::strerror(system_error));
    return result;
}

RealTimeResult refused_memory(int system_error) noexcept {
    RealTimeResult result;
    result.failure = RealTimeFailure::memory;
    result.system_error = system_error;
    std::snprintf(result.text.data(), result.text.size(),
                  "Locking the memory (mlockall) was refused: %s. Next: run as root, or grant it with "
                  "`setcap cap_ipc_lock=ep PROGRAM` or a `memlock` line in /etc/security/limits.conf.",
                  std::strerror(system_error));
    return result;
}

}  // namespace

RealTimeResult enter_real_time(const RealTimeSettings& settings) noexcept {
    if (settings.fifo_priority < 0 || settings.fifo_priority > highest_priority) {
        return refuse_priority(settings.fifo_priority);
    }
    if (settings.lock_memory && mlockall(MCL_CURRENT | MCL_FUTURE) != 0) {
        return refused_memory(errno);
    }
    if (settings.fifo_priority >= lowest_priority) {
        sched_param parameters{};
        parameters.sched_priority = settings.fifo_priority;
        if (sched_setscheduler(0, SCHED_FIFO, &parameters) != 0) {
            return refused_scheduling(errno, settings.fifo_priority);
        }
    }
    return RealTimeResult{};
}

}  // namespace rsi::hal
