// Content of the record on a data abort: the address only where the processor gives it.
#include "hal/zynqmp_r5/data_abort.hpp"

#include <gtest/gtest.h>

namespace rsi::hal::zynqmp_r5 {
namespace {

constexpr std::uint32_t in_guard = RSI_MAIN_STACK_BOTTOM - 4U;
constexpr std::uint32_t write_bit = 1U << 11U;  // DFSR: the access was a write

constexpr std::uint32_t synchronous[]{0x000U, 0x001U, 0x008U, 0x00DU, 0x409U};
constexpr std::uint32_t without_address[]{0x406U, 0x408U,
                                          0x002U};  // external, parity (both late), debug event

TEST(DataAbort, ASynchronousOneHasItsAddress) {
    for (const std::uint32_t status : synchronous) {
        const Fault fault = describe_data_abort(status | write_bit, 0x4000'0000U);
        EXPECT_EQ(fault.reason, ResetReason::data_abort) << status;
        EXPECT_EQ(fault.data, 0x4000'0000U) << status;
        EXPECT_EQ(fault.status, status | write_bit);
    }
}

TEST(DataAbort, InAGuardItIsAStackOverflow) {
    for (const std::uint32_t address :
         {RSI_STACKS_START + 0U, RSI_FAULT_STACK_BOTTOM - 1U, RSI_FAULT_STACK_TOP + 0U, in_guard,
          RSI_MAIN_STACK_TOP + 0U, RSI_STACKS_START + RSI_STACKS_SIZE - 1U}) {
        EXPECT_EQ(describe_data_abort(write_bit, address).reason, ResetReason::stack_overflow) << address;
    }
    for (const std::uint32_t address :
         {RSI_STACKS_START - 1U, RSI_FAULT_STACK_BOTTOM + 0U, RSI_FAULT_STACK_TOP - 1U,
          RSI_MAIN_STACK_BOTTOM + 0U, RSI_MAIN_STACK_TOP - 1U, RSI_STACKS_START + RSI_STACKS_SIZE + 0U}) {
        EXPECT_EQ(describe_data_abort(write_bit, address).reason, ResetReason::data_abort) << address;
    }
}

// A write that the bus refused later: the address register still holds that of some earlier abort.
TEST(DataAbort, OneThatComesLateHasNoAddressAndIsNoStackOverflow) {
    for (const std::uint32_t status : without_address) {
        const Fault fault = describe_data_abort(status | write_bit, in_guard);
        EXPECT_EQ(fault.reason, ResetReason::data_abort) << status;
        EXPECT_EQ(fault.data, 0U) << status;
        EXPECT_EQ(fault.status, status | write_bit);
    }
}

}  // namespace
}  // namespace rsi::hal::zynqmp_r5
