// Load keeper: keeps the learnt load and the accelerometer's offset in non-volatile memory over a restart.
#pragma once

#include <cstdint>

#include "rsi/component.hpp"
#include "rsi/ecu/application/load_record.hpp"
#include "rsi/ecu/application/write_pace.hpp"
#include "rsi/ecu/monitoring/input_monitor.hpp"
#include "rsi/hal/storage.hpp"

namespace rsi::application {

// Stores a load or an offset that clearly differs from the stored one, at most once a minute to limit memory
// wear. A memory that refuses them is tried at a pace of its own.
class LoadKeeper {
 public:
    // `storage` must outlive the keeper. Without one nothing is kept.
    void use(hal::Storage& storage) noexcept { storage_ = &storage; }

    // Before the first cycle: restores what is stored for these parameters, if anything is. `doubted`: the
    // load may have changed since; no loss of power turns a sensor's housing.
    [[gnu::cold]] void restore(const rsi::Parameters& parameters, rsi::Component& component,
                               monitoring::InputMonitor& monitor, bool doubted) noexcept;

    // From now on all is stored for these parameters.
    [[gnu::cold]] void follow(const rsi::Parameters& parameters) noexcept;

    // One cycle.
    void keep(const rsi::LearntLoad& load, float lateral_offset_mps2) noexcept;

    // CRC-32 of the parameters for which it keeps them.
    std::uint32_t parameters_check_word() const noexcept { return parameters_check_word_; }

    // The memory has refused a record for some time, or had one at the start that it did not give whole; and
    // has taken none since.
    bool is_failing() const noexcept { return is_failing_; }

 private:
    hal::Storage* storage_{nullptr};
    std::uint32_t parameters_check_word_{0U};
    std::uint32_t cycles_since_store_{0U};
    WritePace pace_{};
    bool is_failing_{false};
    Learnt stored_{};
};

}  // namespace rsi::application
