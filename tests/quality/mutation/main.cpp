// The main function of a test program in a mutated build. It reads requests, one a line, and answers each
// with one line:
//   tests                       every test: "test NAME", closed by "end"
//   record LIMIT_MS TEST        runs it without a mutant: "failed", or "CPU_MS ID ID ... | ID ID ...":
//   mutants whose
//                               places it executed and that make another value there; those that make the
//                               same. After LIMIT_MS of CPU time it ends with what it has executed so far.
//   try ID CPU_LIMIT_MS FILTER  runs it with a mutant until a test notices: "survived", or
//                               "killed by a test|a crash|the time limit", a tab, and the test that ran then
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
#include <filesystem>
#include <iostream>
#include <sstream>
#include <string>

namespace mutation {

constexpr std::size_t most_mutants = 1U << 16U;
int active = 0;
bool recording = false;
unsigned char* record = nullptr;

}  // namespace mutation

namespace {

// Result of a child for its parent, for any end.
struct Shared {
    unsigned char record[mutation::most_mutants];
    char running_test[512];
};
Shared* shared = nullptr;

std::string name_of(const testing::TestInfo& test) {
    return std::string{test.test_suite_name()} + '.' + test.name();
}

class Observation final : public testing::EmptyTestEventListener {
    void OnTestStart(const testing::TestInfo& test) override {
        std::snprintf(shared->running_test, sizeof shared->running_test, "%s", name_of(test).c_str());
    }
    void OnTestPartResult(const testing::TestPartResult& result) override {
        if (result.failed()) {
            _exit(1);
        }
    }
};

struct Outcome {
    int status;
    long cpu_ms;
};

void limit_resources(long cpu_limit_ms) {
    const rlimit no_core{0, 0};
    setrlimit(RLIMIT_CORE, &no_core);
    const rlimit memory{2UL << 30U, 2UL << 30U};
    setrlimit(RLIMIT_AS, &memory);
    const itimerval limit{{0, 0}, {cpu_limit_ms / 1000, (cpu_limit_ms % 1000) * 1000}};
    setitimer(ITIMER_PROF, &limit, nullptr);
    alarm(static_cast<unsigned>(60 + cpu_limit_ms / 50));  // should it wait for ever
}

// Files of its own: the same test may run at the same time with another mutant, and one that is ended leaves
// them behind.
Outcome run_in_child(int mutant, long cpu_limit_ms, const std::string& filter) {
    std::fflush(nullptr);
    char folder[] = "/tmp/rsi_mutation_XXXXXX";
    if (mkdtemp(folder) == nullptr) {
        std::abort();
    }
    const pid_t child = fork();
    if (child == 0) {
        setenv("TMPDIR", folder, 1);
        setenv("TEST_TMPDIR", folder, 1);
        mutation::active = mutant;
        mutation::recording = (mutant == 0);
        static_cast<void>(std::freopen("/dev/null", "w", stdout));
        static_cast<void>(std::freopen("/dev/null", "w", stderr));
        limit_resources(cpu_limit_ms);
        GTEST_FLAG_SET(filter, filter);
        _exit(RUN_ALL_TESTS());
    }
    int status = 0;
    rusage used{};
    wait4(child, &status, 0, &used);
    std::error_code left;
    std::filesystem::remove_all(folder, left);
    return {status, used.ru_utime.tv_sec * 1000L + used.ru_utime.tv_usec / 1000L};
}

void list_tests() {
    const testing::UnitTest& all = *testing::UnitTest::GetInstance();
    for (int i = 0; i < all.total_test_suite_count(); ++i) {
        const testing::TestSuite& suite = *all.GetTestSuite(i);
        for (int k = 0; k < suite.total_test_count(); ++k) {
            std::cout << "test " << name_of(*suite.GetTestInfo(k)) << '\n';
        }
    }
    std::cout << "end" << std::endl;
}

bool is_out_of_time(int status) {
    return WIFSIGNALED(status) && ((WTERMSIG(status) == SIGPROF) || (WTERMSIG(status) == SIGALRM));
}

void list_recorded(mutation::Recorded what) {
    for (std::size_t mutant = 0U; mutant < mutation::most_mutants; ++mutant) {
        if (shared->record[mutant] == what) {
            std::cout << ' ' << mutant;
        }
    }
}

void record(long cpu_limit_ms, const std::string& filter) {
    std::fill_n(shared->record, mutation::most_mutants, static_cast<unsigned char>(0U));
    const Outcome outcome = run_in_child(0, cpu_limit_ms, filter);
    if ((outcome.status != 0) && !is_out_of_time(outcome.status)) {
        std::cout << "failed" << std::endl;
        return;
    }
    std::cout << outcome.cpu_ms;
    list_recorded(mutation::differing);
    std::cout << " |";
    list_recorded(mutation::executed);
    std::cout << std::endl;
}

const char* how_killed(int status) {
    if (WIFEXITED(status)) {
        return "a test";
    }
    return is_out_of_time(status) ? "the time limit" : "a crash";
}

void try_mutant(int mutant, long cpu_limit_ms, const std::string& filter) {
    const int status = run_in_child(mutant, cpu_limit_ms, filter).status;
    if (status == 0) {
        std::cout << "survived" << std::endl;
    } else {
        std::cout << "killed by " << how_killed(status) << '\t' << shared->running_test << std::endl;
    }
}

}  // namespace

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    void* const memory =
        mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) {
        return 1;
    }
    shared = static_cast<Shared*>(memory);
    mutation::record = shared->record;
    testing::TestEventListeners& listeners = testing::UnitTest::GetInstance()->listeners();
    delete listeners.Release(listeners.default_result_printer());
    listeners.Append(new Observation);
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
            request >> cpu_limit_ms >> filter;
            record(cpu_limit_ms, filter);
        } else if (what == "try") {
            request >> mutant >> cpu_limit_ms >> filter;
            try_mutant(mutant, cpu_limit_ms, filter);
        }
    }
    return 0;
}
