// File storage: a record is there as a whole, or as it was.
#include "hal/linux/file_storage.hpp"

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <fstream>

#include "tests/support/scratch_folder.hpp"

namespace testing_hal {
namespace {

using Record = std::array<std::uint8_t, 4>;
using rsi::hal::Reading;

class FileStorage : public ::testing::Test {
 protected:
    bool reads(const Record& expected) {
        Record record{};
        return storage_.read(record.data(), record.size()) == Reading::stored && record == expected;
    }
    bool write(const Record& record) { return storage_.write(record.data(), record.size()); }

    test_support::ScratchFolder folder_;
    std::filesystem::path path_ = folder_.path() / "record.bin";
    rsi::hal::FileStorage storage_{path_.string()};
};

TEST_F(FileStorage, HasNothingBeforeTheFirstRecord) {
    Record record{};
    EXPECT_EQ(storage_.read(record.data(), record.size()), Reading::never_written);
}

TEST_F(FileStorage, GivesTheNewestRecordToAnotherProcessToo) {
    EXPECT_TRUE(write({1, 2, 3, 4}));
    EXPECT_TRUE(write({5, 6, 7, 8}));
    EXPECT_TRUE(reads({5, 6, 7, 8}));
    rsi::hal::FileStorage other{path_.string()};
    Record record{};
    EXPECT_EQ(other.read(record.data(), record.size()), Reading::stored);
    EXPECT_EQ(record, (Record{5, 6, 7, 8}));
}

TEST_F(FileStorage, TakesNoRecordOfAnotherLength) {
    EXPECT_TRUE(write({1, 2, 3, 4}));
    std::array<std::uint8_t, 5> longer{};
    std::array<std::uint8_t, 3> shorter{};
    EXPECT_EQ(storage_.read(longer.data(), longer.size()), Reading::unreadable);
    EXPECT_EQ(storage_.read(shorter.data(), shorter.size()), Reading::unreadable);
}

// A record that is there and cannot be read is not taken for none.
TEST_F(FileStorage, TellsAnEmptyFileOrNoneThatOpensFromOneThatNeverWas) {
    std::ofstream{path_};
    Record record{};
    EXPECT_EQ(storage_.read(record.data(), record.size()), Reading::unreadable);
    std::filesystem::remove(path_);
    std::filesystem::create_directory(path_);
    EXPECT_EQ(storage_.read(record.data(), record.size()), Reading::unreadable);
    const std::filesystem::path file = folder_.path() / "file";
    std::ofstream{file};
    rsi::hal::FileStorage below_a_file{(file / "record.bin").string()};
    EXPECT_EQ(below_a_file.read(record.data(), record.size()), Reading::unreadable);
}

TEST_F(FileStorage, LeavesNoOtherFile) {
    EXPECT_TRUE(write({1, 2, 3, 4}));
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator{folder_.path()}, {}), 1);
}

// A folder in the new file's place stands for whatever keeps it from being written.
TEST_F(FileStorage, ThatCannotBeWrittenKeepsTheOldRecord) {
    EXPECT_TRUE(write({1, 2, 3, 4}));
    std::filesystem::create_directory(path_.string() + ".new");
    EXPECT_FALSE(write({5, 6, 7, 8}));
    EXPECT_TRUE(reads({1, 2, 3, 4}));
    rsi::hal::FileStorage nowhere{(folder_.path() / "missing" / "record.bin").string()};
    const Record record{};
    EXPECT_FALSE(nowhere.write(record.data(), record.size()));
}

}  // namespace
}  // namespace testing_hal
