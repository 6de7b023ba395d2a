// Reactions of many runs: the rows of a data file, and a summary.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sil/files/csv_writer.hpp"
#include "sil/page/table.hpp"
#include "sil/studies/faults/judgement.hpp"

namespace sil {

// Columns of one reaction in a data file, and their cells. Times are in milliseconds; an empty cell: it did
// not happen.
const std::vector<std::string>& reaction_columns();
void add_reaction(CsvRow& row, const Reaction& reaction);

// Reactions by the name of their group, in the order of the first of each.
class GroupedReactions {
 public:
    void add(std::string_view group, const Reaction& reaction);
    // `heading` names the first column.
    Table table(std::string heading) const;

 private:
    std::vector<std::pair<std::string, std::vector<Reaction>>> groups_{};
};

}  // namespace sil
