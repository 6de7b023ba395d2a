// TOML tables: what is read, and the place and the remedy in every error.
#include "sil/files/toml_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <functional>
#include <string>

#include "sil/input_error.hpp"
#include "tests/support/scratch_folder.hpp"

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
    sil::TomlTable nothing = parsed("a = nan\n");
    EXPECT_EQ(error_of([&] { nothing.number("a", {0.0, 1.0}); }),
              "a.toml:1: \"a\" is not a finite number; give a number from 0 to 1, in SI units");
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

TEST(TomlTable, RefusesWhatIsOfAnotherKind) {
    sil::TomlTable top = parsed(
        "word = \"b\"\nless = -1\nhalf = 0.5\nmixed = [1, \"2\"]\nwords = [\"x\", \"y\"]\nflag = 1\nlist = "
        "[1]\n");
    EXPECT_EQ(error_of([&] { top.number("word"); }),
              "a.toml:1: \"word\" must be a number; write a plain number in SI units");
    EXPECT_EQ(error_of([&] { top.any_number("word"); }),
              "a.toml:1: \"word\" must be a number; write a plain number in SI units");
    EXPECT_EQ(error_of([&] { top.whole_number("less"); }),
              "a.toml:2: \"less\" must be a whole number, 0 or above");
    EXPECT_EQ(error_of([&] { top.whole_number("half"); }),
              "a.toml:3: \"half\" must be a whole number, 0 or above");
    EXPECT_EQ(error_of([&] { top.boolean("flag"); }), "a.toml:6: \"flag\" must be true or false");
    EXPECT_EQ(error_of([&] { top.text("less"); }), "a.toml:2: \"less\" must be a text in quotation marks");
    EXPECT_EQ(error_of([&] { top.choice("word", {"a", "c"}); }),
              "a.toml:1: \"word\" must be one of \"a\", \"c\"");
    EXPECT_EQ(error_of([&] { top.choice("less", {"a", "c"}); }),
              "a.toml:2: \"less\" must be one of \"a\", \"c\"");
    EXPECT_EQ(error_of([&] { top.numbers("less"); }),
              "a.toml:2: \"less\" must be numbers in brackets, such as [0.5, 1.0]");
    EXPECT_THAT(error_of([&] { top.numbers("mixed"); }), HasSubstr("a.toml:4: \"mixed\" must be a number; "));
    EXPECT_THAT(top.texts("words"), ElementsAre("x", "y"));
    for (const char* key : {"mixed", "list", "word"}) {
        EXPECT_THAT(error_of([&] { top.texts(key); }),
                    HasSubstr("must be texts in brackets, such as [\"a\", \"b\"]"));
    }
    EXPECT_EQ(error_of([&] { top.tables("list"); }), "a.toml:7: \"list\" must be written as [[list]]");
}

TEST(TomlTable, TakesTheEndsOfARangeAndAWholeNumberOfNought) {
    sil::TomlTable top = parsed("low = 2\nhigh = 3\nbelow = 1.999\nabove = 3.001\nnought = 0\n");
    EXPECT_EQ(top.number("low", {2.0, 3.0}), 2.0);
    EXPECT_EQ(top.number("high", {2.0, 3.0}), 3.0);
    EXPECT_EQ(top.whole_number("nought"), 0U);
    EXPECT_EQ(error_of([&] { top.number("below", {2.0, 3.0}); }),
              "a.toml:3: \"below\" is 1.999, which is out of range; give a number from 2 to 3, in SI units");
    EXPECT_THAT(error_of([&] { top.number("above", {2.0, 3.0}); }),
                HasSubstr("is 3.001, which is out of range"));
}

TEST(TomlTable, TellsWhetherItIsEmptyAndWhatItHas) {
    sil::TomlTable top = parsed("a = 1\n[inner]\n");
    EXPECT_FALSE(top.is_empty());
    EXPECT_TRUE(top.table("inner").is_empty());
    EXPECT_TRUE(top.has("a"));
    EXPECT_FALSE(top.has("b"));
    EXPECT_EQ(top.place("a"), "a.toml:1: \"a\"");
    EXPECT_EQ(top.table("inner").place("none"), "a.toml:2: \"inner.none\"");
    EXPECT_EQ(top.file(), "a.toml");
}

TEST(TomlTable, ListsEachKnownKeyOnce) {
    sil::TomlTable top = parsed("a = 1\nz = 2\n");
    top.number("a");
    top.allow("a");
    top.allow("b");
    EXPECT_EQ(error_of([&] { top.refuse_unknown_keys(); }),
              "a.toml:2: \"z\" is not known here; remove it or correct its spelling; known here: a, b");
}

TEST(TomlTable, TakesAChangeOfOneValueOnly) {
    sil::TomlTable top = parsed("a = 1\n");
    top.allow("a");
    EXPECT_THAT(error_of([&] { top.change("a=1\nb=2", "a=3"); }), HasSubstr("is not one value"));
    EXPECT_EQ(error_of([&] { top.change("a", "a=3"); }),
              "\"a\" must be KEY=VALUE with a key of a.toml, such as a=3");
    EXPECT_EQ(top.number("a"), 1.0);
    top.change("a=4", "a=3");
    EXPECT_EQ(top.number("a"), 4.0);
}

TEST(TomlTable, OfAFileThatCannotBeReadSaysWhatElseCanBe) {
    EXPECT_THAT(error_of([] { sil::TomlTable::load("/no/such/file", "say --example"); }),
                testing::AllOf(HasSubstr("/no/such/file: cannot be read: "),
                               testing::EndsWith(", or say --example")));
    EXPECT_THAT(error_of([] { sil::TomlTable::load("/no/such/file", ""); }),
                testing::Not(HasSubstr(", or ")));
}

// Sixteen MiB are read, and found to be no TOML.
TEST(TomlTable, OfAFileThatIsTooLongIsNotParsed) {
    const test_support::ScratchFolder folder;
    const std::filesystem::path file = folder.path() / "long.toml";
    test_support::write_text(file, "=");
    std::filesystem::resize_file(file, 16U * 1024U * 1024U);
    EXPECT_THAT(error_of([&] { sil::TomlTable::load(file, ""); }), HasSubstr(":1: not valid TOML: "));
    std::filesystem::resize_file(file, 16U * 1024U * 1024U + 1U);
    EXPECT_THAT(error_of([&] { sil::TomlTable::load(file, ""); }),
                HasSubstr("long.toml: cannot be read: it is longer than 16 MiB; give a shorter file"));
}

TEST(TomlTable, RefusesKeysThatAreNotAskedFor) {
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
