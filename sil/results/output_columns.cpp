#include "sil/results/output_columns.hpp"

#include "rsi/output_table.hpp"
#include "sil/units.hpp"

namespace sil {
namespace {

OutputColumn column_of(const rsi::NumberOutput& output) {
    const std::string name{output.name};
    if (std::string{output.unit} != "rad") {
        return {name, output.member, 1.0};
    }
    return {name.substr(0U, name.rfind('_')) + "_deg", output.member, degrees_per_radian};
}

}  // namespace

const std::vector<OutputColumn>& output_columns() {
    static const std::vector<OutputColumn> columns = [] {
        std::vector<OutputColumn> all;
        for (const rsi::NumberOutput& output : rsi::number_outputs) {
            all.push_back(column_of(output));
        }
        return all;
    }();
    return columns;
}

}  // namespace sil
