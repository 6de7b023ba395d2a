// Page text: the pages that show a run and a study, as join.cmake makes them of their sources.
#pragma once

#include <string>
#include <string_view>

namespace sil {

// Content that a browser may load and run: the page's own, and a connection to where it came from. For the
// header of an answer, too.
extern const std::string_view page_policy;

// The page without a recording: it asks its server for a live drive.
extern const std::string_view live_page;

// The page with a recording in it (JSON), which needs nothing else.
std::string page_with(const std::string& recording);

// The page of a study with what StudyPage says of it.
std::string study_with(const std::string& json);

// Text that page_with() put into a page, of this program or an older one; empty where there is none.
std::string recording_in(const std::string& page);

// Colour and dash of each index, by its name: index_styles.csv.
extern const std::string_view index_styles;

}  // namespace sil
