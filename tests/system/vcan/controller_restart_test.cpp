// Controller restart: what the kernel answers. can0 is a controller whose driver can restart it (the small
// virtual machine has an emulated one), which nothing here can make bus-off; vcan0 has no controller at all.
#include "hal/socketcan/controller_restart.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>

namespace rsi::hal {
namespace {

void configure(const char* command) {
    ASSERT_EQ(std::system(command), 0) << command;
}

TEST(ControllerRestart, AControllerThatIsNotBusOffIsLeftAlone) {
    configure("ip link set can0 down && ip link set can0 up type can bitrate 500000 restart-ms 0");
    EXPECT_EQ(restart_controller({"can0"}).outcome, ControllerRestart::not_bus_off);
}

TEST(ControllerRestart, AnInterfaceThatRestartsByItselfIsLeftToTheKernel) {
    configure("ip link set can0 down && ip link set can0 up type can bitrate 500000 restart-ms 100");
    EXPECT_EQ(restart_controller({"can0"}).outcome, ControllerRestart::left_to_kernel);
}

TEST(ControllerRestart, ADriverThatCannotRestartGetsItsInterfaceTakenDownAndUp) {
    configure("ip link set vcan0 up");
    EXPECT_EQ(restart_controller({"vcan0"}).outcome, ControllerRestart::done);
    EXPECT_TRUE(look_up_interface({"vcan0"}).is_up);
}

TEST(ControllerRestart, WithoutTheRightToConfigureInterfacesItIsRefused) {
    configure("ip link set can0 down && ip link set can0 up type can bitrate 500000 restart-ms 0");
    constexpr uid_t unprivileged{65534};
    ASSERT_EQ(seteuid(unprivileged), 0);
    const ControllerRestartResult result = restart_controller({"can0"});
    ASSERT_EQ(seteuid(0), 0);
    EXPECT_EQ(result.outcome, ControllerRestart::refused);
    EXPECT_EQ(result.system_error, EPERM);
}

TEST(ControllerRestart, AnInterfaceThatIsNotThereIsRefused) {
    const ControllerRestartResult result = restart_controller({"nosuchcan"});
    EXPECT_EQ(result.outcome, ControllerRestart::refused);
    EXPECT_EQ(result.system_error, ENODEV);
}

}  // namespace
}  // namespace rsi::hal
