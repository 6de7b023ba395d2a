// The table of outputs: its rows against the structure, the names and what is made of them.
#include "rsi/output_table.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>
#include <set>
#include <string>

#include "rsi/parameters.hpp"
#include "tests/rsi/enum_layout.h"

namespace output_table_test {
namespace {

TEST(OutputTable, AnIndexStandsInThePlaceOfItsNumber) {
    EXPECT_TRUE(rsi::index_numbers_count_from_zero());
}

TEST(OutputTable, ListsEveryFieldOfTheStructureOnce) {
    std::set<std::size_t> places;
    const rsi::Outputs outputs{};
    const auto place = [&outputs](const void* field) {
        return static_cast<std::size_t>(static_cast<const char*>(field) -
                                        reinterpret_cast<const char*>(&outputs));
    };
    for (const rsi::CodeOutput& code : rsi::code_outputs) {
        places.insert(place(&(outputs.*code.member)));
    }
    for (const rsi::NumberOutput& number : rsi::number_outputs) {
        places.insert(place(&(outputs.*number.member)));
    }
    EXPECT_EQ(places.size() * 4U, sizeof(rsi::Outputs));
    EXPECT_EQ(*places.begin(), 0U);
    EXPECT_EQ(*places.rbegin() + 4U, sizeof(rsi::Outputs));
}

TEST(OutputTable, NamesEndInTheirUnits) {
    const std::set<std::pair<std::string, std::string>> endings{
        {"m/s^2", "mps2"}, {"rad", "rad"},        {"N m", "nm"},           {"m", "m"},
        {"s", "s"},        {"N m/rad", "nmprad"}, {"N m s/rad", "nmsprad"}};
    std::set<std::string> names;
    for (const rsi::NumberOutput& number : rsi::number_outputs) {
        const std::string name{number.name};
        const std::string ending = name.substr(name.rfind('_') + 1U);
        const std::string unit{number.unit};
        EXPECT_TRUE(names.insert(name).second) << name;
        bool is_listed = false;
        for (const auto& [of_unit, of_name] : endings) {
            is_listed = is_listed || of_unit == unit;
            EXPECT_EQ(of_unit == unit, of_name == ending) << name;
        }
        EXPECT_TRUE(is_listed || unit == "-" || unit == "g") << name;
    }
}

// These stand in calibrations that are flashed: a number that was once given stays.
TEST(OutputTable, TheNumbersOfTheFirstIndicesStay) {
    const std::array first{"published",
                           "bank_free",
                           "extended",
                           "load_transfer",
                           "predicted_load_transfer",
                           "predicted_rsi",
                           "static_stability_factor",
                           "dynamic_stability",
                           "dynamic_stability_late",
                           "energy",
                           "rollover_index",
                           "time_to_rollover"};
    ASSERT_GE(rsi::indicator_choices.size(), first.size());
    for (std::size_t index = 0U; index < first.size(); ++index) {
        EXPECT_STREQ(rsi::indicator_choices[index], first[index]);
    }
    EXPECT_EQ(RSI_INDICATOR_PUBLISHED, 0);
    EXPECT_EQ(RSI_INDICATOR_PREDICTED_LOAD_TRANSFER, 4);
    EXPECT_EQ(RSI_INDICATOR_TIME_TO_ROLLOVER, 11);
}

TEST(OutputTable, AComponentThatHasComputedNothingSaysSo) {
    const rsi::Outputs outputs = rsi::no_outputs();
    EXPECT_EQ(outputs.state, RSI_STATE_UNAVAILABLE);
    EXPECT_EQ(outputs.side, RSI_SIDE_NONE);
    EXPECT_EQ(outputs.roll_source, RSI_ROLL_NONE);
    EXPECT_EQ(outputs.roll_sensor_disagrees, 0);
    EXPECT_EQ(outputs.estimate_frozen, 0);
    for (const rsi::NumberOutput& number : rsi::number_outputs) {
        EXPECT_TRUE(std::isnan(outputs.*number.member)) << number.name;
    }
}

rsi::Outputs all_ones() {
    rsi::Outputs outputs{};
    for (const rsi::CodeOutput& code : rsi::code_outputs) {
        outputs.*code.member = 1;
    }
    for (const rsi::NumberOutput& number : rsi::number_outputs) {
        outputs.*number.member = 1.0F;
    }
    return outputs;
}

TEST(OutputTable, TakingTheStatementBackLeavesTheDetails) {
    rsi::Outputs outputs = all_ones();
    rsi::reset_statement(outputs);
    for (const rsi::CodeOutput& code : rsi::code_outputs) {
        EXPECT_EQ(outputs.*code.member, (code.risk == rsi::Risk::statement) ? code.reset : 1) << code.name;
    }
    for (const rsi::NumberOutput& number : rsi::number_outputs) {
        EXPECT_EQ(std::isnan(outputs.*number.member), number.risk == rsi::Risk::statement) << number.name;
    }
}

TEST(OutputTable, SoundnessLooksAtEveryCodeAndEveryNumberThatIsAlwaysThere) {
    const rsi::Outputs good = all_ones();
    ASSERT_TRUE(rsi::are_codes_known_and_numbers_finite(good));
    for (const rsi::CodeOutput& code : rsi::code_outputs) {
        for (const std::int32_t value : {-1, code.largest + 1, std::numeric_limits<std::int32_t>::min()}) {
            rsi::Outputs outputs = good;
            outputs.*code.member = value;
            EXPECT_FALSE(rsi::are_codes_known_and_numbers_finite(outputs)) << code.name;
        }
        for (const std::int32_t value : {0, code.largest}) {
            rsi::Outputs outputs = good;
            outputs.*code.member = value;
            EXPECT_TRUE(rsi::are_codes_known_and_numbers_finite(outputs)) << code.name;
        }
    }
    for (const rsi::NumberOutput& number : rsi::number_outputs) {
        for (const float value :
             {std::numeric_limits<float>::quiet_NaN(), -std::numeric_limits<float>::infinity()}) {
            rsi::Outputs outputs = good;
            outputs.*number.member = value;
            EXPECT_EQ(rsi::are_codes_known_and_numbers_finite(outputs),
                      number.presence != rsi::Presence::always)
                << number.name;
        }
    }
}

// A caller with other enumerations than the library's must not have other structures.
TEST(Structures, AreLaidOutTheSameWhateverTheSizeOfAnEnumeration) {
    std::array<unsigned, 100> with{};
    std::array<unsigned, 100> without{};
    const unsigned count = layout_with_short_enums(with.data());
    ASSERT_EQ(layout_without_short_enums(without.data()), count);
    EXPECT_LT(with[count], without[count]);  // the flags do what they say
    for (unsigned index = 0U; index < count; ++index) {
        EXPECT_EQ(with[index], without[index]) << index;
    }
    for (unsigned index = 0U; index + 4U < count; ++index) {
        EXPECT_EQ(with[index], 4U * index);
    }
    EXPECT_EQ(with[count - 4U], sizeof(rsi_outputs));
    EXPECT_EQ(with[count - 3U], sizeof(rsi_parameters));
    EXPECT_EQ(with[count - 2U], sizeof(rsi_inputs));
    EXPECT_EQ(with[count - 1U], sizeof(rsi_validation));
}

}  // namespace
}  // namespace output_table_test
