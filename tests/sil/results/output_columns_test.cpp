// The outputs of the firmware as columns: names, units and values.
#include "sil/results/output_columns.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <string>

#include "rsi/output_table.hpp"

namespace output_columns_test {
namespace {

const sil::OutputColumn& column(const std::string& name) {
    const auto& all = sil::output_columns();
    return *std::find_if(all.begin(), all.end(), [&name](const auto& each) { return each.name == name; });
}

TEST(OutputColumns, AreOneForEachNumberInItsOrder) {
    const auto& columns = sil::output_columns();
    ASSERT_EQ(columns.size(), std::size(rsi::number_outputs));
    for (std::size_t i = 0U; i < columns.size(); ++i) {
        EXPECT_EQ(columns[i].member, rsi::number_outputs[i].member) << columns[i].name;
    }
}

TEST(OutputColumns, GiveAnglesInDegreesAndEverythingElseAsItIs) {
    rsi::Outputs outputs{};
    outputs.observed_roll_angle_rad = 0.5F;
    outputs.load_transfer_ratio = 0.5F;
    EXPECT_NEAR(column("observed_roll_angle_deg").value(outputs), 28.64788976, 1.0e-6);
    EXPECT_EQ(column("load_transfer_ratio").value(outputs), 0.5);
    for (const sil::OutputColumn& each : sil::output_columns()) {
        EXPECT_FALSE(("_" + each.name).rfind("_rad") == each.name.size() - 3U) << each.name;
    }
}

}  // namespace
}  // namespace output_columns_test
