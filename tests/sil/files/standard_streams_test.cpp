// Standard streams: a program that was started without some of them, and output that is lost.
#include "sil/files/standard_streams.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <functional>
#include <string>

#include "tests/support/scratch_folder.hpp"

namespace standard_streams_test {
namespace {

// Exit status of `act` in a process of its own.
int status_of(const std::function<int()>& act) {
    std::fflush(nullptr);
    const pid_t child = ::fork();
    if (child == 0) {
        ::_exit(act());
    }
    int status = 0;
    EXPECT_EQ(::waitpid(child, &status, 0), child);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

// How a stream is open: O_RDONLY, O_WRONLY, O_RDWR; negative when it is closed.
int mode_of(int stream) {
    const int flags = ::fcntl(stream, F_GETFL);
    return flags < 0 ? flags : flags & O_ACCMODE;
}

// A file that the program opens later must not get the number of a stream, or its messages would go there.
// The substitute of a closed stream can neither be read nor take what is written.
TEST(StandardStreams, ThatAreClosedAreOccupied) {
    for (int closed = 0; closed < 8; ++closed) {
        const int failed = status_of([closed] {
            const int open = ::open("/dev/null", O_RDWR);
            int before[3];
            for (int stream = 0; stream < 3; ++stream) {
                ::dup2(open, stream);
                if ((closed >> stream) % 2 != 0) {
                    ::close(stream);
                }
                before[stream] = mode_of(stream);
            }
            const int next = ::dup(open);
            ::close(next);
            sil::occupy_closed_streams();
            for (int stream = 0; stream < 3; ++stream) {
                const int useless = stream == STDIN_FILENO ? O_WRONLY : O_RDONLY;
                if (mode_of(stream) != (before[stream] < 0 ? useless : before[stream])) {
                    return 1 + stream;
                }
            }
            const int now = ::dup(open);
            return now < 3 || (closed == 0 && now != next) ? 4 : 0;
        });
        EXPECT_EQ(failed, 0) << "closed: " << closed;
    }
}

class FinishedOutput : public testing::Test {
 protected:
    // Status of a program that prints something to `out`.
    int finish(const std::string& out) {
        return status_of([this, &out] {
            static_cast<void>(std::freopen(error_file().c_str(), "w", stderr));
            static_cast<void>(std::freopen(out.c_str(), "w", stdout));
            std::fputs("result\n", stdout);
            const int status = sil::finish_output("program");
            std::fflush(stderr);
            return status;
        });
    }
    std::string error_file() const { return (folder_.path() / "error").string(); }

    test_support::ScratchFolder folder_;
};

TEST_F(FinishedOutput, ThatIsWholeIsASuccess) {
    const std::string out = (folder_.path() / "out").string();
    EXPECT_EQ(finish(out), 0);
    EXPECT_EQ(test_support::text_of(out), "result\n");
    EXPECT_EQ(test_support::text_of(error_file()), "");
}

TEST_F(FinishedOutput, ThatIsLostIsToldAndAFailure) {
    EXPECT_EQ(finish("/dev/full"), 1);
    EXPECT_EQ(
        test_support::text_of(error_file()),
        "program: not all of the output could be written; check where it goes to: is it closed, or is the "
        "disk full?\n");
}

// The system refused an earlier piece, and took the last one.
TEST_F(FinishedOutput, ThatWasLostBeforeIsAFailureToo) {
    EXPECT_EQ(status_of([this] {
                  static_cast<void>(std::freopen(error_file().c_str(), "w", stderr));
                  static_cast<void>(std::freopen("/dev/full", "w", stdout));
                  std::fputs("result\n", stdout);
                  std::fflush(stdout);
                  const int sink = ::open("/dev/null", O_WRONLY);
                  ::dup2(sink, STDOUT_FILENO);
                  return sil::finish_output("program");
              }),
              1);
}

}  // namespace
}  // namespace standard_streams_test
