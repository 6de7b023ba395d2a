// Run timing: the bus and the pace of a run, over a CAN interface or in this process.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include "rsi/types.hpp"
#include "sil/simulation/pace.hpp"

namespace sil {

class RunTiming {
 public:
    RunTiming(const RunTiming&) = delete;
    RunTiming& operator=(const RunTiming&) = delete;
    virtual ~RunTiming() = default;

    virtual rsi::hal::CanBus& bus() = 0;
    virtual Pace& pace() = 0;
    virtual std::uint64_t missed_cycles() const { return 0U; }

    // Outputs of the firmware in the latest cycle; null when it runs elsewhere.
    virtual const rsi::Outputs* outputs() const { return nullptr; }

    // Finishes the log, if there is one. Throws std::runtime_error when it cannot.
    virtual void close() {}

 protected:
    RunTiming() = default;
};

// All throw std::exception with a message for the user; a log is written to `log` as one of `interface`.
std::unique_ptr<RunTiming> real_time(const std::string& interface);
std::unique_ptr<RunTiming> lock_step(const std::string& interface, const std::filesystem::path& log);

// The firmware in this process. Its log is that of the same run in lock-step.
std::unique_ptr<RunTiming> in_process(const rsi::Parameters& calibration, const std::string& interface,
                                      const std::filesystem::path& log);

}  // namespace sil
