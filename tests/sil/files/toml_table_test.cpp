// TOML tables: what is read, and the place and the remedy in every error.
#include "sil/files/toml_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

#include "sil/input_error.hpp"

namespace toml_table_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

sil::TomlTable parsed(const std::string& text) {
    return sil::TomlTable::parse(text, "a.toml");
}

std::string error_of(const std::function<void()>& act) {
    try {
        act();
    } catch (const sil::InputError& error) {
        return error.what();
    }
    return "no error";
}

TEST(TomlTable, GivesValuesOfEveryKind) {
    sil::TomlTable top = parsed(
        "number = 2\nwhole = 7\nyes = true\nword = \"b\"\nends = [1, 2.5]\n[inner]\nx = -0.0\n"
        "[[each]]\nx = 1\n[[each]]\nx = 2\n");
    EXPECT_EQ(top.number("number"), 2.0);
    EXPECT_EQ(top.number("number", {2.0, 3.0}), 2.0);
    EXPECT_EQ(top.whole_number("whole"), 7U);
    EXPECT_TRUE(top.boolean("yes"));
    EXPECT_EQ(top.text("word"), "b");
    EXPECT_EQ(top.choice("word", {"a", "b"}), 1U);
    EXPECT_THAT(top.numbers("ends"), ElementsAre(1.0, 2.5));
    EXPECT_TRUE(std::signbit(top.table("inner").number("x")));
    EXPECT_EQ(top.tables("each").back().number("x"), 2.0);
    EXPECT_TRUE(top.tables("none").empty());
    EXPECT_FALSE(top.has("none"));
    EXPECT_EQ(error_of([&] { top.refuse_unknown_keys(); }), "no error");
}

TEST(TomlTable, NamesPlaceKeyAndRemedy) {
    sil::TomlTable top = parsed("a = \"1\"\n\n[inner]\nb = inf\nc = 9\n");
    sil::TomlTable inner = top.table("inner");
    EXPECT_THAT(error_of([&] { top.number("a"); }), HasSubstr("a.toml:1: \"a\" must be a number; "));
    EXPECT_EQ(error_of([&] { inner.number("b", {0.0, 1.0}); }),
              "a.toml:4: \"inner.b\" is not a finite number; give a number from 0 to 1, in SI units");
    EXPECT_THAT(error_of([&] { inner.number("b"); }), HasSubstr("a.toml:4: \"inner.b\" is not a finite"));
    EXPECT_TRUE(std::isinf(inner.any_number("b")));
    EXPECT_EQ(
        error_of([&] { inner.number("c", {0.0, 1.0}, "share"); }),
        "a.toml:5: \"inner.c\" is 9, which is out of range (share); give a number from 0 to 1, in SI units");
    EXPECT_EQ(error_of([&] { inner.number("d"); }),
              "a.toml:3: \"inner.d\" is missing; add a number of this name to the table [inner]");
    EXPECT_EQ(error_of([&] { top.text("d"); }),
              "a.toml:1: \"d\" is missing; add a text of this name at the top of the file");
    EXPECT_EQ(error_of([&] { inner.fail("c", "is odd"); }), "a.toml:5: \"inner.c\" is odd");
    EXPECT_EQ(error_of([&] { top.table("a"); }),
              "a.toml:1: \"a\" must be a table; write [a] and its keys below");
    EXPECT_EQ(error_of([&] { top.tables("a"); }), "a.toml:1: \"a\" must be written as [[a]]");
    EXPECT_THAT(error_of([] { parsed("a = 1\nb = = 2\n"); }), HasSubstr("a.toml:2: not valid TOML: "));
}

TEST(TomlTable, RefusesKeysThatNobodyAskedFor) {
    sil::TomlTable top = parsed("a = 1\nb = 2\n");
    top.allow("a");
    EXPECT_EQ(error_of([&] { top.refuse_unknown_keys(); }),
              "a.toml:2: \"b\" is not known here; remove it or correct its spelling; known here: a");
    top.allow("b");
    EXPECT_EQ(error_of([&] { top.refuse_unknown_keys(); }), "no error");
}

TEST(TomlTable, TakesAChangeOfAKnownKeyAndNamesItByItsText) {
    sil::TomlTable top = parsed("a = 1\nb = \"x\"\n");
    EXPECT_EQ(error_of([&] { top.change("a=2", "a=3"); }),
              "\"a=2\" must be KEY=VALUE with a key of a.toml, such as a=3");
    top.allow("a");
    top.allow("b");
    top.change("a = 2", "a=3");
    top.change("b=word", "a=3");
    EXPECT_EQ(top.number("a"), 2.0);
    EXPECT_EQ(top.text("b"), "word");
    top.change("a=high", "a=3");
    EXPECT_THAT(error_of([&] { top.number("a"); }), HasSubstr("a=high: \"a\" must be a number"));
}

}  // namespace
}  // namespace toml_table_test
