// Whole folder: results appear complete or not at all, and no other files disappear.
#include "sil/studies/drives/whole_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/support/scratch_folder.hpp"

namespace {

namespace fs = std::filesystem;
using test_support::ScratchFolder;
using test_support::text_of;
using test_support::write_text;

const std::vector<std::string> contents{"summary.json", "indices.csv"};

TEST(WholeFolder, AppearsWhenItIsCommitted) {
    const ScratchFolder scratch;
    {
        sil::WholeFolder folder{scratch.path() / "a" / "drive", contents};
        write_text(folder.path() / "summary.json", "{}");
        EXPECT_FALSE(fs::exists(scratch.path() / "a" / "drive"));
        folder.commit();
    }
    EXPECT_EQ(text_of(scratch.path() / "a" / "drive" / "summary.json"), "{}");
    EXPECT_FALSE(fs::exists(scratch.path() / "a" / "drive.partial"));
}

TEST(WholeFolder, LeavesNothingWhenItIsNot) {
    const ScratchFolder scratch;
    {
        const sil::WholeFolder folder{scratch.path() / "drive", contents};
        write_text(folder.path() / "summary.json", "{}");
    }
    EXPECT_TRUE(fs::is_empty(scratch.path()));
}

TEST(WholeFolder, AnEarlierResultIsGoneEvenWhenThisOneFails) {
    const ScratchFolder scratch;
    fs::create_directory(scratch.path() / "drive");
    write_text(scratch.path() / "drive" / "indices.csv", "old");
    {
        const sil::WholeFolder folder{scratch.path() / "drive", contents};
    }
    EXPECT_FALSE(fs::exists(scratch.path() / "drive"));
}

TEST(WholeFolder, FilesOfAKilledReplayAreNotMixedIn) {
    const ScratchFolder scratch;
    fs::create_directory(scratch.path() / "drive.partial");
    write_text(scratch.path() / "drive.partial" / "indices.csv", "half");
    sil::WholeFolder folder{scratch.path() / "drive", contents};
    folder.commit();
    EXPECT_TRUE(fs::is_empty(scratch.path() / "drive"));
}

TEST(WholeFolder, AFolderWithOtherFilesIsLeftAlone) {
    const ScratchFolder scratch;
    fs::create_directory(scratch.path() / "drive");
    write_text(scratch.path() / "drive" / "summary.json", "of a run");
    write_text(scratch.path() / "drive" / "signals.csv", "precious");
    try {
        const sil::WholeFolder folder{scratch.path() / "drive", contents};
        ADD_FAILURE();
    } catch (const std::runtime_error& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("signals.csv"));
        EXPECT_THAT(error.what(), testing::HasSubstr("--output"));
    }
    EXPECT_EQ(text_of(scratch.path() / "drive" / "signals.csv"), "precious");
    EXPECT_EQ(text_of(scratch.path() / "drive" / "summary.json"), "of a run");
}

}  // namespace
