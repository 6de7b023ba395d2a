// Message when Linux does not grant real-time settings.
#include "hal/linux/real_time.hpp"

#include <gtest/gtest.h>
#include <linux/capability.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace rsi::hal {
namespace {

void give_up_every_privilege() {
    const rlimit none{0, 0};
    setrlimit(RLIMIT_RTPRIO, &none);
    setrlimit(RLIMIT_MEMLOCK, &none);
    __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
    const __user_cap_data_struct no_capabilities[2]{};
    syscall(SYS_capset, &header, no_capabilities);
}

// Runs in a process of its own (a GoogleTest death test), so that this one keeps its privileges.
[[noreturn]] void request_and_leave(const RealTimeSettings& settings) {
    give_up_every_privilege();
    const RealTimeResult result = enter_real_time(settings);
    std::fprintf(stderr, "%d: %s", result.system_error, result.message());
    std::exit(static_cast<int>(result.failure));
}

TEST(RealTimeDeathTest, ARefusedPriorityNamesItAndTheWayToGetIt) {
    EXPECT_EXIT(request_and_leave({50, false}),
                ::testing::ExitedWithCode(static_cast<int>(RealTimeFailure::scheduling)),
                "^1: .*priority 50 .*refused: Operation not permitted.*Next: .*root.*cap_sys_nice");
}

TEST(RealTimeDeathTest, TheLowestAndTheHighestPriorityAreAskedFor) {
    for (const int priority : {1, 99}) {
        EXPECT_EXIT(request_and_leave({priority, false}),
                    ::testing::ExitedWithCode(static_cast<int>(RealTimeFailure::scheduling)), "refused");
    }
}

TEST(RealTimeDeathTest, ByDefaultNothingIsAskedFor) {
    EXPECT_EXIT(request_and_leave({}), ::testing::ExitedWithCode(0), "^0: $");
}

#if !defined(RSI_ADDRESS_SANITIZER)  // AddressSanitizer turns mlockall into a call without effect
TEST(RealTimeDeathTest, RefusedMemoryLockingNamesTheWayToGetIt) {
    EXPECT_EXIT(request_and_leave({0, true}),
                ::testing::ExitedWithCode(static_cast<int>(RealTimeFailure::memory)),
                "^[1-9][0-9]*: .*mlockall.*refused: .*Next: .*root.*cap_ipc_lock");
}
#endif

TEST(RealTime, ImpossiblePrioritiesAreRefusedWithTheRange) {
    for (const int priority : {-1, 100}) {
        const RealTimeResult result = enter_real_time({priority, false});
        EXPECT_EQ(result.failure, RealTimeFailure::priority_out_of_range);
        EXPECT_NE(std::string(result.message()).find("priority " + std::to_string(priority)),
                  std::string::npos);
        EXPECT_NE(std::string(result.message()).find("from 1 to 99"), std::string::npos);
    }
}

TEST(RealTime, AskingForNothingIsGranted) {
    const RealTimeResult result = enter_real_time({});
    EXPECT_TRUE(static_cast<bool>(result));
    EXPECT_STREQ(result.message(), "");
}

}  // namespace
}  // namespace rsi::hal
