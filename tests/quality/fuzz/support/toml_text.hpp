// Text in place of a file for the readers of TOML: the linker takes this program's parse_file() before the
// library's, and it parses the text. Writing, opening and reading a file took a third of an execution.
#pragma once

#include <string>
#include <string_view>

namespace fuzz {

// A path of a file that exists, for readers that look before they ask the library; it is empty.
const std::string& toml_path();

// What the library finds in that file from now on; `text` must stay.
void set_toml_text(std::string_view text);

}  // namespace fuzz
