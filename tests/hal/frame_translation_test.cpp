// Translation of frames, error reports and time stamps between the kernel and hal, which needs no CAN in the
// kernel.
#include <gtest/gtest.h>
#include <linux/can/error.h>

#include <cstring>

#include "hal/socketcan/frame_translation.hpp"
#include "rsi/hal/well_formed.hpp"
#include "tests/hal/make_frame.hpp"

namespace rsi::hal {
namespace {

using testing::make_frame;

constexpr std::size_t classic_bytes{16U};  // the kernel's struct can_frame
constexpr std::size_t fd_bytes{72U};       // the kernel's struct canfd_frame

TEST(FrameTranslation, AClassicFrameHasTheKernelsClassicLayout) {
    canfd_frame kernel_frame{};
    ASSERT_EQ(to_kernel(make_frame(0x123U, {0xAAU, 0xBBU}), true, kernel_frame), classic_bytes);
    can_frame classic{};
    std::memcpy(&classic, &kernel_frame, classic_bytes);
    EXPECT_EQ(classic.can_id, 0x123U);
    EXPECT_EQ(classic.can_dlc, 2U);
    EXPECT_EQ(classic.data[0], 0xAAU);
    EXPECT_EQ(classic.data[1], 0xBBU);
    EXPECT_EQ(classic.data[2], 0U);
    EXPECT_EQ(kernel_frame.flags, 0U);
}

TEST(FrameTranslation, AnExtendedIdentifierIsMarkedForTheKernel) {
    CanFrame frame = make_frame(0x1ABC'DEF0U);
    frame.extended = true;
    canfd_frame kernel_frame{};
    to_kernel(frame, true, kernel_frame);
    EXPECT_EQ(kernel_frame.can_id, 0x9ABC'DEF0U);
}

TEST(FrameTranslation, AFlexibleDataRateFrameIsMarkedAndCarries64Bytes) {
    CanFrame frame = make_frame(0x10U);
    frame.flexible_data_rate = true;
    frame.length = 64U;
    frame.data[63] = 0x5AU;
    canfd_frame kernel_frame{};
    ASSERT_EQ(to_kernel(frame, true, kernel_frame), fd_bytes);
    EXPECT_EQ(kernel_frame.flags, 0x05U);  // CANFD_FDF and CANFD_BRS
    EXPECT_EQ(kernel_frame.len, 64U);
    EXPECT_EQ(kernel_frame.data[63], 0x5AU);
    to_kernel(frame, false, kernel_frame);
    EXPECT_EQ(kernel_frame.flags, 0x04U);
}

TEST(FrameTranslation, NothingOfAnEarlierFrameIsLeft) {
    canfd_frame kernel_frame{};
    std::memset(&kernel_frame, 0xFF, sizeof(kernel_frame));
    ASSERT_EQ(to_kernel(make_frame(0x122U, {0xAAU}), true, kernel_frame), classic_bytes);
    EXPECT_EQ(kernel_frame.can_id, 0x122U);
    EXPECT_EQ(kernel_frame.flags, 0U);
    EXPECT_EQ(kernel_frame.data[1], 0U);
}

TEST(FrameTranslation, AnExtendedIdentifierComesBackWhole) {
    CanFrame frame = make_frame(0x1ABC'DEF0U);
    frame.extended = true;
    canfd_frame kernel_frame{};
    const std::size_t bytes = to_kernel(frame, true, kernel_frame);
    EXPECT_EQ(from_kernel(kernel_frame, bytes, Time{}).identifier, 0x1ABC'DEF0U);
    kernel_frame.can_id = 0xFFFU;  // more than eleven bits
    EXPECT_EQ(from_kernel(kernel_frame, bytes, Time{}).identifier, 0x7FFU);
}

TEST(FrameTranslation, ThereAndBackIsTheSameFrame) {
    for (const bool extended : {false, true}) {
        for (const bool flexible : {false, true}) {
            CanFrame frame = make_frame(0x2F5U, {1U, 2U, 3U, 4U, 5U, 6U, 7U, 8U});
            frame.extended = extended;
            frame.flexible_data_rate = flexible;
            frame.receive_time = Time{77};
            canfd_frame kernel_frame{};
            const std::size_t bytes = to_kernel(frame, true, kernel_frame);
            ASSERT_EQ(kind_of(kernel_frame, bytes), KernelFrameKind::data);
            const CanFrame back = from_kernel(kernel_frame, bytes, Time{77});
            EXPECT_EQ(back.identifier, frame.identifier);
            EXPECT_EQ(back.extended, extended);
            EXPECT_EQ(back.flexible_data_rate, flexible);
            EXPECT_EQ(back.length, frame.length);
            EXPECT_EQ(back.data, frame.data);
            EXPECT_EQ(back.receive_time, Time{77});
        }
    }
}

TEST(FrameTranslation, RemoteFramesAndUnknownSizesAreNoDataFrames) {
    canfd_frame kernel_frame{};
    kernel_frame.can_id = 0x123U | CAN_RTR_FLAG;
    EXPECT_EQ(kind_of(kernel_frame, classic_bytes), KernelFrameKind::other);
    EXPECT_EQ(kind_of(canfd_frame{}, 15U), KernelFrameKind::other);
    EXPECT_EQ(kind_of(canfd_frame{}, classic_bytes), KernelFrameKind::data);
}

TEST(FrameTranslation, AnImpossibleLengthIsCutToTheLargest) {
    canfd_frame kernel_frame{};
    kernel_frame.len = 200U;
    EXPECT_EQ(from_kernel(kernel_frame, classic_bytes, Time{}).length, 8U);
    EXPECT_EQ(from_kernel(kernel_frame, fd_bytes, Time{}).length, 64U);
}

canfd_frame error_frame(canid_t classes, std::uint8_t controller = 0U) {
    canfd_frame frame{};
    frame.can_id = CAN_ERR_FLAG | classes;
    frame.len = 8U;
    frame.data[1] = controller;
    return frame;
}

TEST(ErrorFrames, AreToldFromDataFrames) {
    EXPECT_EQ(kind_of(error_frame(CAN_ERR_BUSOFF), classic_bytes), KernelFrameKind::error);
}

TEST(ErrorFrames, MapToTheStatesOfFaultConfinement) {
    const BusState active = BusState::error_active;
    const BusState passive = BusState::error_passive;
    EXPECT_EQ(state_after_error(error_frame(CAN_ERR_BUSOFF), passive), BusState::bus_off);
    EXPECT_EQ(state_after_error(error_frame(CAN_ERR_RESTARTED), BusState::bus_off), active);
    EXPECT_EQ(state_after_error(error_frame(CAN_ERR_CRTL, CAN_ERR_CRTL_RX_PASSIVE), active), passive);
    EXPECT_EQ(state_after_error(error_frame(CAN_ERR_CRTL, CAN_ERR_CRTL_TX_PASSIVE), active), passive);
    EXPECT_EQ(state_after_error(error_frame(CAN_ERR_CRTL, CAN_ERR_CRTL_TX_WARNING), passive), active);
    EXPECT_EQ(state_after_error(error_frame(CAN_ERR_CRTL, CAN_ERR_CRTL_ACTIVE), passive), active);
}

TEST(ErrorFrames, ThePassiveOneOfTwoReportedSidesCounts) {
    const std::uint8_t both = CAN_ERR_CRTL_RX_WARNING | CAN_ERR_CRTL_TX_PASSIVE;
    EXPECT_EQ(state_after_error(error_frame(CAN_ERR_CRTL, both), BusState::error_active),
              BusState::error_passive);
}

TEST(ErrorFrames, ReportsOfSingleErrorsLeaveTheState) {
    for (const BusState before : {BusState::error_active, BusState::error_passive, BusState::bus_off}) {
        EXPECT_EQ(state_after_error(error_frame(CAN_ERR_PROT | CAN_ERR_BUSERROR), before), before);
        EXPECT_EQ(state_after_error(error_frame(CAN_ERR_CRTL, CAN_ERR_CRTL_RX_OVERFLOW), before), before);
        // Byte 1 means something only when the class says so.
        EXPECT_EQ(state_after_error(error_frame(CAN_ERR_LOSTARB, CAN_ERR_CRTL_TX_PASSIVE), before), before);
        EXPECT_EQ(state_after_error(error_frame(CAN_ERR_LOSTARB, CAN_ERR_CRTL_ACTIVE), before), before);
    }
}

TEST(ErrorFrames, TellOfFramesThatTheControllerLost) {
    EXPECT_TRUE(tells_of_lost_frame(error_frame(CAN_ERR_CRTL, CAN_ERR_CRTL_RX_OVERFLOW)));
    EXPECT_FALSE(tells_of_lost_frame(error_frame(CAN_ERR_CRTL, CAN_ERR_CRTL_TX_OVERFLOW)));
    EXPECT_FALSE(tells_of_lost_frame(error_frame(CAN_ERR_PROT, CAN_ERR_CRTL_RX_OVERFLOW)));
}

TEST(ReceiveTime, IsTheMonotonicTimeAsLongAgoAsTheWallClocksStamp) {
    // Stamped at 1000000, read at 1000300 on the wall clock, when the monotonic clock shows 5000: 300 ago.
    EXPECT_EQ(monotonic_receive_time(Time{1'000'000}, Time{1'000'300}, Time{5'000}, Time{0}), Time{4'700});
}

TEST(ReceiveTime, StaysInBoundsWhenSomeoneSetsTheWallClock) {
    const Time stamp{1'000'000};
    EXPECT_EQ(monotonic_receive_time(stamp, Time{900'000}, Time{5'000}, Time{4'000}), Time{5'000});
    EXPECT_EQ(monotonic_receive_time(stamp, Time{9'000'000}, Time{5'000}, Time{4'000}), Time{4'000});
}

TEST(WellFormedFrames, HaveTheLengthsThatALengthCodeCanName) {
    const bool possible_fd[]{true,  true,  true,  true,  true,  true,  true,  true,  true,  false, false,
                             false, true,  false, false, false, true,  false, false, false, true,  false,
                             false, false, true,  false, false, false, false, false, false, false, true};
    for (std::uint8_t length = 0U; length <= 32U; ++length) {
        EXPECT_EQ(is_length_possible(length, true), possible_fd[length]) << int{length};
        EXPECT_EQ(is_length_possible(length, false), length <= 8U) << int{length};
    }
    EXPECT_TRUE(is_length_possible(48U, true));
    EXPECT_TRUE(is_length_possible(64U, true));
    EXPECT_FALSE(is_length_possible(63U, true));
    EXPECT_FALSE(is_length_possible(255U, true));
}

TEST(WellFormedFrames, HaveIdentifiersOfElevenOrTwentyNineBits) {
    EXPECT_TRUE(is_identifier_possible(0x7FFU, false));
    EXPECT_FALSE(is_identifier_possible(0x800U, false));
    EXPECT_TRUE(is_identifier_possible(0x1FFF'FFFFU, true));
    EXPECT_FALSE(is_identifier_possible(0x2000'0000U, true));
}

}  // namespace
}  // namespace rsi::hal
