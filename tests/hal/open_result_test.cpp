// Message for a CAN interface that cannot be opened.
#include "hal/socketcan/open_result.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <string>

#include "hal/socketcan/socket_can_bus.hpp"

namespace rsi::hal {
namespace {

using ::testing::AllOf;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::StartsWith;

std::string text_of(OpenFailure failure, int system_error, const char* name = "vcan7") {
    return describe_open_failure(failure, system_error, name).message();
}

TEST(OpenFailureText, AMissingInterfaceComesWithTheCommandsThatMakeOne) {
    EXPECT_THAT(text_of(OpenFailure::interface_missing, ENODEV),
                AllOf(HasSubstr("'vcan7'"), HasSubstr("no such interface"), HasSubstr("No such device"),
                      HasSubstr("`ip link add dev vcan7 type vcan && ip link set vcan7 up`"),
                      HasSubstr("`ip link set vcan7 up type can bitrate 500000`")));
}

TEST(OpenFailureText, AKernelWithoutCanPointsToTheVirtualMachine) {
    EXPECT_THAT(text_of(OpenFailure::kernel_without_can, EAFNOSUPPORT),
                AllOf(HasSubstr("kernel has no CAN"), HasSubstr("Address family not supported"),
                      HasSubstr("modprobe can-raw"), HasSubstr("sil/run"), HasSubstr("virtual machine")));
}

TEST(OpenFailureText, AnInterfaceThatIsDownComesWithTheCommandThatSwitchesItOn) {
    EXPECT_THAT(text_of(OpenFailure::interface_down, 0),
                AllOf(HasSubstr("is down"), HasSubstr("ip link set vcan7 up")));
}

TEST(OpenFailureText, EveryFailureSaysWhatWhereAndWhatNext) {
    for (const OpenFailure failure :
         {OpenFailure::interface_name, OpenFailure::identifiers, OpenFailure::kernel_without_can,
          OpenFailure::not_permitted, OpenFailure::interface_missing, OpenFailure::interface_not_can,
          OpenFailure::interface_down, OpenFailure::system}) {
        const OpenResult result = describe_open_failure(failure, EPERM, "a15characters15");
        EXPECT_FALSE(static_cast<bool>(result));
        EXPECT_EQ(result.system_error, EPERM);
        EXPECT_THAT(result.message(),
                    AllOf(StartsWith("CAN interface 'a15characters15' cannot be opened: "),
                          HasSubstr("Operation not permitted"), HasSubstr("Next: "), EndsWith(".")));
    }
}

TEST(OpenFailureText, ANameWithFormattingCharactersOrOfGreatLengthDoesNoHarm) {
    EXPECT_THAT(text_of(OpenFailure::interface_missing, ENODEV, "%n%s"), HasSubstr("'%n%s'"));
    const std::string long_name(100'000, 'x');
    EXPECT_LT(text_of(OpenFailure::interface_name, 0, long_name.c_str()).size(), OpenResult{}.text.size());
}

TEST(OpenFailureText, TheSystemsReasonIsInBracketsWhereThereIsOne) {
    EXPECT_THAT(text_of(OpenFailure::system, EPERM), HasSubstr(" (Operation not permitted). Next: "));
    EXPECT_THAT(text_of(OpenFailure::system, 0), HasSubstr("the system refused. Next: "));
}

TEST(OpenFailureText, SuccessHasNone) {
    const OpenResult result = describe_open_failure(OpenFailure::none, 0, "vcan7");
    EXPECT_TRUE(static_cast<bool>(result));
    EXPECT_STREQ(result.message(), "");
}

bool kernel_has_can() {
    const int descriptor = socket(PF_CAN, SOCK_RAW, CAN_RAW);
    if (descriptor >= 0) {
        close(descriptor);
    }
    return descriptor >= 0;
}

TEST(OpeningSocketCan, FailsWithTheReasonThatHoldsOnThisKernel) {
    SocketCanBus bus;
    SocketCanSettings settings;
    settings.interface_name = "no-such-can0";
    const OpenResult result = bus.open(settings);
    EXPECT_EQ(result.failure,
              kernel_has_can() ? OpenFailure::interface_missing : OpenFailure::kernel_without_can);
    EXPECT_EQ(result.system_error, kernel_has_can() ? ENODEV : EAFNOSUPPORT);
    EXPECT_THAT(result.message(), AllOf(HasSubstr("'no-such-can0'"), HasSubstr("Next: ")));
}

TEST(OpeningSocketCan, RefusesImpossibleNames) {
    SocketCanBus bus;
    for (const char* name : {"", "sixteen-letters-", static_cast<const char*>(nullptr)}) {
        SocketCanSettings settings;
        settings.interface_name = name;
        EXPECT_EQ(bus.open(settings).failure, OpenFailure::interface_name);
    }
}

TEST(OpeningSocketCan, RefusesImpossibleIdentifiers) {
    SocketCanBus bus;
    for (const CanIdentifier identifier : {CanIdentifier{0x800U, false}, CanIdentifier{0x2000'0000U, true}}) {
        SocketCanSettings settings;
        settings.identifiers = &identifier;
        settings.identifier_count = 1U;
        EXPECT_EQ(bus.open(settings).failure, OpenFailure::identifiers);
    }
    const std::array<CanIdentifier, most_receive_filters + 1U> too_many{};
    SocketCanSettings settings;
    settings.identifiers = too_many.data();
    settings.identifier_count = too_many.size();
    EXPECT_EQ(bus.open(settings).failure, OpenFailure::identifiers);
}

TEST(ASocketCanBusThatIsNotOpen, FailsBothWaysAndSaysClosed) {
    SocketCanBus bus;
    CanFrame frame;
    EXPECT_EQ(bus.state(), BusState::closed);
    EXPECT_EQ(bus.receive(frame), ReceiveResult::failed);
    EXPECT_EQ(bus.send(frame), SendResult::failed);
    EXPECT_EQ(bus.statistics().send_failures, 1U);
    EXPECT_FALSE(bus.wait_for_frame(Time{}));
    EXPECT_EQ(bus.receive_buffer_bytes(), 0);
}

}  // namespace
}  // namespace rsi::hal
