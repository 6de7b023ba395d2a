// The table of trouble codes: what a workshop's documents hold stays.
#include "rsi/ecu/diagnosis/trouble_codes.hpp"

#include <gtest/gtest.h>

#include <set>

namespace testing_diagnosis {
namespace {

using rsi::diagnosis::trouble_code_count;
using rsi::diagnosis::trouble_codes;

TEST(TroubleCodes, AreOfTheManufacturersRanges) {
    for (const rsi::diagnosis::TroubleCode& each : trouble_codes) {
        const std::uint32_t range = each.number >> 20U;
        EXPECT_TRUE(range == 0x5U || range == 0xDU) << std::hex << each.number;
        EXPECT_NE(each.number & 0xFFU, 0U) << "no type of failure: " << std::hex << each.number;
        EXPECT_EQ(each.number >> 24U, 0U);
    }
}

// The compiler's evaluation of the table, repeated at run time for the tests' coverage.
TEST(TroubleCodes, AreOneRowACode) {
    auto table = trouble_codes;
    EXPECT_TRUE(rsi::diagnosis::is_table_of_all(table));
    std::swap(table[3], table[7]);
    EXPECT_FALSE(rsi::diagnosis::is_table_of_all(table)) << "another order";
    table = trouble_codes;
    table[7].number = table[3].number;
    EXPECT_FALSE(rsi::diagnosis::is_table_of_all(table)) << "a number twice";
    table = trouble_codes;
    table[0].code = table[1].code;
    EXPECT_FALSE(rsi::diagnosis::is_table_of_all(table)) << "another code in the first row";
    table = trouble_codes;
    table[7].number = table[0].number;
    EXPECT_FALSE(rsi::diagnosis::is_table_of_all(table)) << "the number of the first row twice";
    EXPECT_EQ(rsi::diagnosis::numbers_of_all(), rsi::diagnosis::trouble_code_numbers);
    EXPECT_EQ(rsi::diagnosis::row(rsi::monitoring::DiagnosticCode::imu_lost, 0xD120U, 0x87U).number,
              0xD12087U);
}

TEST(TroubleCodes, AreFoundByTheirNumbers) {
    EXPECT_EQ(trouble_codes[rsi::diagnosis::row_of_number(0xD12087U)].code,
              rsi::monitoring::DiagnosticCode::imu_lost);
    EXPECT_EQ(trouble_codes[rsi::diagnosis::row_of_number(0x521044U + 2U)].code,
              rsi::monitoring::DiagnosticCode::parameters_damaged);
    EXPECT_EQ(rsi::diagnosis::row_of_number(0x123456U), trouble_code_count);
    EXPECT_EQ(rsi::diagnosis::row_of_number(0U), trouble_code_count);
}

}  // namespace
}  // namespace testing_diagnosis
