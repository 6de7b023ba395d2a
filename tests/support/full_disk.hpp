// FullDisk: as long as it lives, no file of this process can grow beyond a length, as if there were no more
// room.
#pragma once

#include <sys/resource.h>

#include <csignal>

namespace test_support {

class FullDisk {
 public:
    explicit FullDisk(rlim_t bytes) : signal_{std::signal(SIGXFSZ, SIG_IGN)} {
        static_cast<void>(::getrlimit(RLIMIT_FSIZE, &before_));
        const rlimit now{bytes, before_.rlim_max};
        static_cast<void>(::setrlimit(RLIMIT_FSIZE, &now));
    }
    ~FullDisk() {
        static_cast<void>(::setrlimit(RLIMIT_FSIZE, &before_));
        static_cast<void>(std::signal(SIGXFSZ, signal_));
    }
    FullDisk(const FullDisk&) = delete;
    FullDisk& operator=(const FullDisk&) = delete;

 private:
    rlimit before_{};
    void (*signal_)(int);
};

}  // namespace test_support
