// Report tables: what a campaign's report shows, on its page and in Markdown.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "sil/page/table.hpp"
#include "sil/studies/campaign/report.hpp"

namespace sil {

// A number of a table or chart that is not known.
inline constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

// not_known of none.
inline double percent(const Share& share) {
    return 100.0 * share.value();
}

// The warning, and every index with its threshold at 1.
Table table_of_judgements(const RunGroup& group);

// Every index with its best threshold at one of false_alarm_limits, or at each of them.
Table table_of_best(const RunGroup& group, std::size_t first_limit, std::size_t last_limit);

// The warning in each group; `key`: what the groups are.
Table table_of_groups(const std::string& name, const std::string& key, const std::vector<RunGroup>& groups);

Table table_of_ordinary_driving(const TimeAccount& time);

// The sentence on ordinary driving.
std::string text_of_ordinary_driving(const CampaignReport& report);

// From what the intervals are made.
std::string words_of_confidence(const RunGroup& group);

}  // namespace sil
