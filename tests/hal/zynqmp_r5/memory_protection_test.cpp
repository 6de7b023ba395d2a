// Which access the memory protection unit allows where.
#include "hal/zynqmp_r5/memory_protection.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace rsi::hal::zynqmp_r5 {
namespace {

constexpr std::uint32_t nothing = 0U;

// Rule of the unit: the highest region that holds the address decides; none means no access.
std::uint32_t access_at(std::uint32_t address) {
    std::uint32_t access = nothing;
    for (const Region& region : regions) {
        const std::uint32_t offset = address - region.start;
        const bool holds =
            offset < region.size && ((region.left_out >> (offset / (region.size / 8U))) & 1U) == 0U;
        access = holds ? static_cast<std::uint32_t>(region.access) : access;
    }
    return access;
}

constexpr auto value(Access access) {
    return static_cast<std::uint32_t>(access);
}
// Access permission field and execute-never bit of the region access control register.
constexpr bool may_write(std::uint32_t access) {
    return ((access >> 8U) & 7U) == 1U;
}
constexpr bool may_execute(std::uint32_t access) {
    return access != nothing && ((access >> 12U) & 1U) == 0U;
}

TEST(MemoryProtection, EveryPartOfTheImageHasItsAccess) {
    EXPECT_EQ(access_at(RSI_VECTORS_START), value(Access::execute));
    EXPECT_EQ(access_at(RSI_CODE_START), value(Access::execute));
    EXPECT_EQ(access_at(RSI_CODE_START + RSI_CODE_SIZE - 1U), value(Access::execute));
    EXPECT_EQ(access_at(RSI_PARAMETERS_START), value(Access::constants));
    EXPECT_EQ(access_at(RSI_DATA_START), value(Access::data));
    EXPECT_EQ(access_at(RSI_RETAINED_START), value(Access::uncached));
    for (const std::uint32_t peripheral : {0xFF06'0000U, 0xFF11'0000U, 0xFF15'0000U, 0xFF5E'0218U}) {
        EXPECT_EQ(access_at(peripheral), value(Access::device)) << peripheral;
    }
}

TEST(MemoryProtection, NothingCanBeBothWrittenAndExecuted) {
    for (const Region& region : regions) {
        const std::uint32_t access = value(region.access);
        EXPECT_FALSE(may_write(access) && may_execute(access)) << region.start;
    }
    EXPECT_FALSE(may_write(access_at(RSI_CODE_START)));
    EXPECT_FALSE(may_write(access_at(RSI_PARAMETERS_START)));
    EXPECT_FALSE(may_execute(access_at(RSI_MAIN_STACK_BOTTOM)));
}

TEST(MemoryProtection, BelowEachStackIsAGuardOfTwoKilobytesAndAboveTheMainStackAsWell) {
    EXPECT_TRUE(may_write(access_at(RSI_MAIN_STACK_BOTTOM)));
    EXPECT_TRUE(may_write(access_at(RSI_MAIN_STACK_TOP - 1U)));
    EXPECT_TRUE(may_write(access_at(RSI_FAULT_STACK_BOTTOM)));
    EXPECT_TRUE(may_write(access_at(RSI_FAULT_STACK_TOP - 1U)));
    for (std::uint32_t below = 1U; below <= 2048U; ++below) {
        ASSERT_EQ(access_at(RSI_MAIN_STACK_BOTTOM - below), nothing) << below;
        ASSERT_EQ(access_at(RSI_FAULT_STACK_BOTTOM - below), nothing) << below;
    }
    EXPECT_EQ(access_at(RSI_MAIN_STACK_TOP), nothing);
}

TEST(MemoryProtection, NothingElseIsAccessible) {
    const std::vector<std::uint32_t> outside{RSI_VECTORS_SIZE,
                                             0x8'0000U,
                                             RSI_CODE_START - 1U,
                                             RSI_PARAMETERS_START + RSI_PARAMETERS_SIZE,
                                             RSI_RETAINED_START + RSI_RETAINED_SIZE,
                                             0x4000'0000U,
                                             0xFF06'1000U,
                                             0xFF0A'0000U,
                                             0xFFFF'0000U};
    for (const std::uint32_t address : outside) {
        EXPECT_EQ(access_at(address), nothing) << address;
    }
}

TEST(MemoryProtection, RegistersHoldTheExponentOfTheSizeAndThePartsLeftOut) {
    EXPECT_EQ(size_and_enable({0U, 32U, Access::data}), 0x09U);
    EXPECT_EQ(size_and_enable({0U, 0x40U, Access::data}), 0x0BU);
    EXPECT_EQ(size_and_enable({0U, 0x1'0000U, Access::data}), 0x1FU);
    EXPECT_EQ(size_and_enable({0U, 0x4000U, Access::data, 0xE5U}), 0xE51BU);
    EXPECT_EQ(size_and_enable({0U, 0x8000'0000U, Access::data}), 0x3DU);
}

TEST(MemoryProtection, ImpossibleRegionsAreNoticed) {
    EXPECT_FALSE(is_possible({0x1000U, 0x2000U, Access::data}));       // start
    EXPECT_FALSE(is_possible({0x1000U, 0x0C00U, Access::data}));       // no power of two
    EXPECT_FALSE(is_possible({0x1000U, 0x10U, Access::data}));         // too small
    EXPECT_FALSE(is_possible({0x1000U, 0x80U, Access::data, 0x01U}));  // too small for parts
    EXPECT_TRUE(is_possible({0x1000U, 0x1000U, Access::data, 0x01U}));
    EXPECT_FALSE(is_possible({0x1001U, 0x1000U, Access::data}));  // not even one byte off
    EXPECT_TRUE(is_possible({0x1000U, 0x20U, Access::data}));     // the smallest
    EXPECT_TRUE(is_possible({0x1000U, 0x100U, Access::data, 0xFFU}));
    EXPECT_FALSE(is_possible({0x1000U, 0x100U, Access::data, 0x100U}));  // there are eight parts
}

TEST(MemoryProtection, OneImpossibleRegionIsEnough) {
    EXPECT_TRUE(are_possible(regions));
    for (std::size_t place = 0U; place < regions.size(); ++place) {
        std::array<Region, 10> with_one = regions;
        with_one[place] = {0x1000U, 0x10U, Access::data};
        EXPECT_FALSE(are_possible(with_one)) << place;
    }
}

}  // namespace
}  // namespace rsi::hal::zynqmp_r5
