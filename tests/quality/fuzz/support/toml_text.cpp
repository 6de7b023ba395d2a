#include "tests/quality/fuzz/support/toml_text.hpp"

#include "sil/files/file_io.hpp"
#include "tests/quality/fuzz/support/require.hpp"

namespace {

std::string_view current_text;

}  // namespace

namespace fuzz {

const std::string& toml_path() {
    static const std::string path{"fuzz.toml"};
    return path;
}

void set_toml_text(std::string_view text) {
    current_text = text;
}

}  // namespace fuzz

// In place of that of sil/files/file_io.cpp, which is not linked.
std::string sil::read_whole_file(const std::filesystem::path& path, std::uint64_t) {
    fuzz::require(path == fuzz::toml_path(), "the file that was given is the one that is read");
    return std::string{current_text};
}
