#include "tests/quality/fuzz/support/toml_text.hpp"

#include <toml++/toml.h>

#include "tests/quality/fuzz/support/memory_file.hpp"
#include "tests/quality/fuzz/support/require.hpp"

namespace {

std::string_view current_text;

}  // namespace

namespace fuzz {

const std::string& toml_path() {
    static const MemoryFile file;
    return file.path();
}

void set_toml_text(std::string_view text) {
    current_text = text;
}

}  // namespace fuzz

// In place of the library's.
toml::parse_result toml::parse_file(std::string_view path) {
    fuzz::require(path == fuzz::toml_path(), "the file that was given is the one that is read");
    return toml::parse(current_text, path);
}
