// Whole files: what is no ordinary file is refused, and nothing is cut off under its name.
#include "sil/files/file_io.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <stdexcept>
#include <string>

#include "sil/input_error.hpp"
#include "tests/support/full_disk.hpp"
#include "tests/support/scratch_folder.hpp"

namespace {

namespace fs = std::filesystem;
using test_support::FullDisk;
using test_support::text_of;
using test_support::write_text;
using testing::HasSubstr;

class WholeFile : public testing::Test {
 protected:
    fs::path path(const std::string& name) const { return scratch_.path() / name; }

    std::size_t entries() const {
        const fs::directory_iterator all{scratch_.path()};
        return static_cast<std::size_t>(std::distance(fs::begin(all), fs::end(all)));
    }

    template <typename Act>
    std::string error_of(Act act) {
        try {
            act();
        } catch (const std::runtime_error& error) {
            return error.what();
        }
        return "no error";
    }

 private:
    test_support::ScratchFolder scratch_;
};

constexpr const char* device_or_pipe = "it is a device or a pipe and no ordinary file";

TEST_F(WholeFile, AFileWithoutEndOrWriterIsNotRead) {
    const fs::path pipe = path("pipe");
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    for (const fs::path& endless : {fs::path{"/dev/zero"}, fs::path{"/dev/urandom"}, pipe}) {
        EXPECT_EQ(error_of([&] { sil::read_whole_file(endless); }),
                  endless.string() + ": cannot be read: " + device_or_pipe +
                      "; write what comes from there into a file, and give that");
    }
}

TEST_F(WholeFile, ALongFileIsReadUpToTheLimitAndRefusedBeyond) {
    write_text(path("long"), std::string(200'000U, 'x'));
    EXPECT_EQ(sil::read_whole_file(path("long"), 200'000U).size(), 200'000U);
    EXPECT_EQ(sil::read_beginning(path("long"), 10U), sil::read_whole_file(path("long")).substr(0U, 10U));
    EXPECT_EQ(sil::read_beginning(path("long"), 300'000U).size(), 200'000U);
    EXPECT_THAT(error_of([&] { sil::read_beginning(path("none"), 10U); }),
                HasSubstr("none: cannot be read: "));
    EXPECT_THAT(error_of([&] { sil::read_whole_file(path("long"), 199'999U); }),
                HasSubstr("long: cannot be read: it is longer than 0 MiB; give a shorter file"));
    // Says of itself that it is empty.
    EXPECT_THAT(error_of([] { sil::read_whole_file("/proc/self/maps", 10U); }),
                HasSubstr("it is longer than"));
}

// Nothing of it is read, or memory would not suffice.
TEST_F(WholeFile, AHugeFileIsRefusedAtOnce) {
    write_text(path("huge"), "");
    for (const std::uintmax_t length : {std::uintmax_t{1} << 42U, (std::uintmax_t{1} << 30U) + 1U}) {
        fs::resize_file(path("huge"), length);
        EXPECT_THAT(error_of([&] { sil::read_whole_file(path("huge")); }),
                    HasSubstr("it is longer than 1024 MiB; give a shorter file"));
    }
}

// Rest of a call that was interrupted before.
TEST_F(WholeFile, AnOldInterruptionIsNoneOfTheReading) {
    write_text(path("a"), std::string(100'000U, 'x'));
    errno = EINTR;
    EXPECT_EQ(sil::read_whole_file(path("a")).size(), 100'000U);
}

// The number that the system gives the next file.
int next_descriptor() {
    const int number = ::open("/dev/null", O_RDONLY);
    ::close(number);
    return number;
}

TEST_F(WholeFile, NothingStaysOpenAndNothingElseIsClosed) {
    const int next = next_descriptor();
    sil::write_file_atomically(path("a"), "x");
    sil::read_whole_file(path("a"));
    {
        const sil::GrowingFile unfinished{path("a")};
    }
    EXPECT_EQ(next_descriptor(), next);
    for (const int standard : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        EXPECT_GE(::fcntl(standard, F_GETFD), 0) << standard;
    }
}

// As of a service without a standard input: the first file has its number, 0.
TEST_F(WholeFile, TheLowestDescriptorIsAsGoodAsAnyOther) {
    const pid_t child = ::fork();
    if (child == 0) {
        ::close(STDIN_FILENO);
        sil::write_file_atomically(path("a"), "x");
        const bool is_free = next_descriptor() == STDIN_FILENO;
        const bool is_read = sil::read_whole_file(path("a")) == "x";
        ::_exit(is_free && is_read && next_descriptor() == STDIN_FILENO ? 0 : 1);
    }
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    EXPECT_EQ(status, 0);
}

TEST_F(WholeFile, MayBeReadByAllWhomTheSystemAllows) {
    const mode_t before = ::umask(022);
    sil::write_file_atomically(path("a"), "x");
    ::umask(before);
    EXPECT_EQ(fs::status(path("a")).permissions(), fs::perms{0644});
}

TEST_F(WholeFile, TheSystemGetsEightKibibytesAtATime) {
    sil::GrowingFile file{path("a")};
    file.write(std::string(8191U, 'x'));
    EXPECT_EQ(text_of(path("a.partial")).size(), 0U);
    file.write("x");
    EXPECT_EQ(text_of(path("a.partial")).size(), 8192U);
    file.write("y");
    EXPECT_EQ(text_of(path("a.partial")).size(), 8192U);
    file.finish();
    EXPECT_EQ(text_of(path("a")), std::string(8192U, 'x') + "y");
}

TEST_F(WholeFile, AFolderThatTookTheNameIsTold) {
    sil::GrowingFile file{path("a")};
    file.write("x");
    fs::create_directory(path("a"));
    EXPECT_EQ(error_of([&] { file.finish(); }),
              "cannot write " + path("a").string() +
                  ": Is a directory; check that the folder exists and may be "
                  "written");
    EXPECT_EQ(text_of(path("a.partial")), "x");
}

TEST_F(WholeFile, LinesWithoutRoomAreWrittenOnceThereIsSome) {
    sil::GrowingFile file{path("a")};
    const std::string start(9'000U, 'x');
    {
        const FullDisk full{10'000U};
        file.write(start);
        EXPECT_THAT(error_of([&] { file.write(std::string(9'000U, 'y')); }), HasSubstr("File too large"));
    }
    file.write("z");
    file.finish();
    EXPECT_EQ(text_of(path("a")), start + std::string(9'000U, 'y') + "z");
}

TEST_F(WholeFile, GrowsBesideItsName) {
    write_text(path("a"), "of an earlier run");
    {
        sil::GrowingFile file{path("a")};
        file.write("one\n");
        EXPECT_EQ(text_of(path("a")), "of an earlier run");
        file.write("two\n");
        file.finish();
    }
    EXPECT_EQ(text_of(path("a")), "one\ntwo\n");
    EXPECT_EQ(entries(), 1U);
}

TEST_F(WholeFile, AnUnfinishedFileStaysUnderItsOtherName) {
    {
        sil::GrowingFile file{path("a")};
        file.write("one\n");
    }
    EXPECT_FALSE(fs::exists(path("a")));
    EXPECT_EQ(text_of(path("a.partial")), "one\n");
    sil::remove_file(path("a"));
    EXPECT_EQ(entries(), 0U);
}

TEST_F(WholeFile, AfterAKillThereAreWholePieces) {
    const std::string piece(99U, 'x');
    const pid_t writer = ::fork();
    if (writer == 0) {
        sil::GrowingFile file{path("a")};
        for (int count = 0; count < 1000; ++count) {
            file.write(piece + "\n");
        }
        ::kill(::getpid(), SIGKILL);
    }
    int status = 0;
    ASSERT_EQ(::waitpid(writer, &status, 0), writer);
    ASSERT_TRUE(WIFSIGNALED(status));
    const std::string left = text_of(path("a.partial"));
    EXPECT_FALSE(fs::exists(path("a")));
    EXPECT_GT(left.size(), 100'000U - 8'300U);
    EXPECT_EQ(left.size() % 100U, 0U);
}

TEST_F(WholeFile, AFullDiskIsToldAndLeavesNothingCutOffUnderTheName) {
    write_text(path("a"), "of an earlier run");
    const FullDisk full{10'000U};
    sil::GrowingFile file{path("a")};
    EXPECT_THAT(error_of([&] {
                    for (int count = 0; count < 1000; ++count) {
                        file.write(std::string(100U, 'x'));
                    }
                }),
                HasSubstr("cannot write " + path("a").string() + ": File too large; "));
    EXPECT_THAT(error_of([&] { file.finish(); }), HasSubstr("cannot write "));
    EXPECT_EQ(text_of(path("a")), "of an earlier run");
    EXPECT_EQ(text_of(path("a.partial")), std::string(10'000U, 'x'));
}

TEST_F(WholeFile, WrittenAtOnceItLeavesNothingButItselfOrNothing) {
    sil::write_file_atomically(path("a"), "first");
    {
        const FullDisk full{3U};
        EXPECT_THAT(error_of([&] { sil::write_file_atomically(path("a"), "second"); }),
                    HasSubstr("cannot write "));
        EXPECT_THAT(error_of([&] { sil::write_file_atomically(path("b"), "second"); }),
                    HasSubstr("cannot write "));
    }
    EXPECT_EQ(text_of(path("a")), "first");
    sil::write_file_atomically(path("a"), "second");
    EXPECT_EQ(text_of(path("a")), "second");
    EXPECT_EQ(entries(), 1U);
}

TEST_F(WholeFile, ALinkStaysALink) {
    write_text(path("target"), "first");
    fs::create_symlink("target", path("link"));
    sil::write_file_atomically(path("link"), "second");
    EXPECT_TRUE(fs::is_symlink(path("link")));
    EXPECT_EQ(text_of(path("target")), "second");
}

// As root, a file would otherwise take the place of /dev/null.
TEST_F(WholeFile, OtherThanOrdinaryFilesAreNotReplaced) {
    ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0600), 0);
    fs::create_directory(path("folder"));
    fs::create_symlink("/dev/null", path("link"));
    for (const char* name : {"pipe", "link"}) {
        EXPECT_EQ(error_of([&] { sil::write_file_atomically(path(name), "x"); }),
                  "cannot write " + path(name).string() + ": " + device_or_pipe + "; choose another name");
        EXPECT_THAT(error_of([&] { const sil::GrowingFile file{path(name)}; }), HasSubstr(device_or_pipe));
    }
    EXPECT_THAT(error_of([&] { sil::write_file_atomically(path("folder"), "x"); }),
                HasSubstr("it is a folder"));
    EXPECT_THAT(error_of([] { sil::write_file_atomically("", "x"); }), HasSubstr("the name is empty"));
    EXPECT_TRUE(fs::is_fifo(path("pipe")));
    EXPECT_EQ(entries(), 3U);
}

TEST_F(WholeFile, AFolderThatCannotBeMadeIsNamed) {
    sil::make_folder(path("one") / "two");
    sil::make_folder(path("one") / "two");
    EXPECT_TRUE(fs::is_directory(path("one") / "two"));
    write_text(path("file"), "");
    for (const fs::path& bad : {path("file"), path("file") / "folder"}) {
        EXPECT_THAT(error_of([&] { sil::make_folder(bad); }),
                    HasSubstr("cannot make the folder " + bad.string() + ": Not a directory; "));
    }
    EXPECT_THAT(error_of([] { sil::make_folder(""); }), HasSubstr("is empty; give one"));
}

TEST_F(WholeFile, AFolderInAFilesPlaceIsNotRemoved) {
    sil::remove_file(path("none"));
    fs::create_directories(path("a") / "precious");
    EXPECT_THAT(error_of([&] { sil::remove_file(path("a")); }),
                HasSubstr("cannot remove " + path("a").string() + ": Directory not empty; "));
    EXPECT_TRUE(fs::exists(path("a") / "precious"));
}

}  // namespace
