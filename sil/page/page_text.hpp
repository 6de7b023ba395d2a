// Page text: the page that shows a run, as join.cmake makes it of its sources.
#pragma once

#include <string>

namespace sil {

// The page with a recording in it (JSON), which needs nothing else.
std::string page_with(const std::string& recording);

}  // namespace sil
