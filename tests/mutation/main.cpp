// The main function of a test program in a mutated build. It reads requests, one a line, and answers each
// with one line:
//   tests                             every test: "test NAME", closed by "end"
//   record FILTER                     runs it without a mutant: "CPU_MS ID ID ..." of what it executed, or
//   "failed" try ID CPU_LIMIT_MS FILTER        runs it with a mutant: "survived", or "killed test|crash|time
//   limit"
// Each runs in a process of its own, so that nothing of a mutant is left behind.
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <sstream>
#include <string>

namespace mutation {

constexpr std::size_t most_mutants = 1U << 16U;
int active = 0;
unsigned char before_main[most_mutants];
unsigned char* executed = before_main;

}  // namespace mutation

namespace {

struct Outcome {
    int status;
    long cpu_ms;
};

Outcome run_in_child(int mutant, long cpu_limit_ms, const std::string& filter) {
    std::fflush(nullptr);
    const pid_t child = fork();
    if (child == 0) {
        mutation::active = mutant;
        static_cast<void>(std::freopen("/dev/null", "w", stdout));
        static_cast<void>(std::freopen("/dev/null", "w", stderr));
        const rlimit no_core{0, 0};
        setrlimit(RLIMIT_CORE, &no_core);
        const rlimit memory{2UL << 30U, 2UL << 30U};
        setrlimit(RLIMIT_AS, &memory);
        const itimerval limit{{0, 0}, {cpu_limit_ms / 1000, (cpu_limit_ms % 1000) * 1000}};
        setitimer(ITIMER_PROF, &limit, nullptr);
        alarm(static_cast<unsigned>(60 + cpu_limit_ms / 50));  // should it wait for ever
        GTEST_FLAG_SET(filter, filter);
        GTEST_FLAG_SET(fail_fast, true);
        _exit(RUN_ALL_TESTS());
    }
    int status = 0;
    rusage used{};
    wait4(child, &status, 0, &used);
    return {status, used.ru_utime.tv_sec * 1000L + used.ru_utime.tv_usec / 1000L};
}

void list_tests() {
    const testing::UnitTest& all = *testing::UnitTest::GetInstance();
    for (int i = 0; i < all.total_test_suite_count(); ++i) {
        const testing::TestSuite& suite = *all.GetTestSuite(i);
        for (int k = 0; k < suite.total_test_count(); ++k) {
            std::cout << "test " << suite.name() << '.' << suite.GetTestInfo(k)->name() << '\n';
        }
    }
    std::cout << "end" << std::endl;
}

void record(const std::string& filter) {
    std::fill_n(mutation::executed, mutation::most_mutants, static_cast<unsigned char>(0U));
    const Outcome outcome = run_in_child(0, 600'000, filter);
    if (outcome.status != 0) {
        std::cout << "failed" << std::endl;
        return;
    }
    std::cout << outcome.cpu_ms;
    for (std::size_t mutant = 0U; mutant < mutation::most_mutants; ++mutant) {
        if (mutation::executed[mutant] != 0U) {
            std::cout << ' ' << mutant;
        }
    }
    std::cout << std::endl;
}

void try_mutant(int mutant, long cpu_limit_ms, const std::string& filter) {
    const int status = run_in_child(mutant, cpu_limit_ms, filter).status;
    if (status == 0) {
        std::cout << "survived" << std::endl;
    } else if (WIFEXITED(status)) {
        std::cout << "killed test" << std::endl;
    } else {
        const int signal = WTERMSIG(status);
        const bool too_long = (signal == SIGPROF) || (signal == SIGALRM);
        std::cout << (too_long ? "killed time limit" : "killed crash") << std::endl;
    }
}

}  // namespace

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    void* const shared =
        mmap(nullptr, mutation::most_mutants, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (shared == MAP_FAILED) {
        return 1;
    }
    mutation::executed = static_cast<unsigned char*>(shared);
    for (std::string line; std::getline(std::cin, line);) {
        std::istringstream request{line};
        std::string what;
        std::string filter;
        int mutant = 0;
        long cpu_limit_ms = 0;
        request >> what;
        if (what == "tests") {
            list_tests();
        } else if (what == "record") {
            request >> filter;
            record(filter);
        } else if (what == "try") {
            request >> mutant >> cpu_limit_ms >> filter;
            try_mutant(mutant, cpu_limit_ms, filter);
        }
    }
    return 0;
}
