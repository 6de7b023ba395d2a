// Values as TOML writes them.
#include "sil/files/toml_text.hpp"

#include <gtest/gtest.h>

namespace toml_text_test {
namespace {

TEST(TomlNumber, IsNeverReadAsAWholeNumber) {
    EXPECT_EQ(sil::toml_number(2.0), "2.0");
    EXPECT_EQ(sil::toml_number(-0.0), "-0.0");
    EXPECT_EQ(sil::toml_number(0.5), "0.5");
    EXPECT_EQ(sil::toml_number(1e30), "1e+30");
}

TEST(TomlString, EscapesQuotesAndControlCharacters) {
    EXPECT_EQ(sil::toml_string("plain text~"), "\"plain text~\"");
    EXPECT_EQ(sil::toml_string("a\"b\\c"), "\"a\\\"b\\\\c\"");
    EXPECT_EQ(sil::toml_string("\n\x1F\x7F"), "\"\\u000A\\u001F\\u007F\"");
    EXPECT_EQ(sil::toml_string("gr\xC3\xBCn"), "\"gr\xC3\xBCn\"");
}

}  // namespace
}  // namespace toml_text_test
