// Text in place of a file for the readers of TOML: this program's read_whole_file() gives the text. Writing,
// opening and reading a file took a third of an execution.
#pragma once

#include <string>
#include <string_view>

namespace fuzz {

// The path of the file that this stands for; there is none.
const std::string& toml_path();

// Content of that file from now on; `text` must stay.
void set_toml_text(std::string_view text);

}  // namespace fuzz
