// Page text: the page that shows a run, as join.cmake makes it of its sources.
#pragma once

#include <string>
#include <string_view>

namespace sil {

// What a browser may load and run of the page: what is in it, and a connection to where it came from. For the
// header of an answer, too.
extern const std::string_view page_policy;

// The page without a recording: it asks its server for a live drive.
extern const std::string_view live_page;

// The page with a recording in it (JSON), which needs nothing else.
std::string page_with(const std::string& recording);

// What page_with() put into a page, of this program or an older one; empty where there is none.
std::string recording_in(const std::string& page);

}  // namespace sil
