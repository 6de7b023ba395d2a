// Load keeper: keeps the learnt load in non-volatile memory over a restart.
#pragma once

#include <cstdint>

#include "rsi/component.hpp"
#include "rsi/ecu/application/write_pace.hpp"
#include "rsi/hal/storage.hpp"

namespace rsi::application {

// Stores a load that clearly differs from the stored one, at most once a minute to limit memory wear. A
// memory that refuses it is tried at a pace of its own.
class LoadKeeper {
 public:
    // `storage` must outlive the keeper. Without one nothing is kept.
    void use(hal::Storage& storage) noexcept { storage_ = &storage; }

    // Before the first cycle: restores the load stored for these parameters, if there is one. `doubted`: the
    // load may have changed since.
    [[gnu::cold]] void restore(const rsi::Parameters& parameters, rsi::Component& component,
                               bool doubted) noexcept;

    // From now on loads are stored for these parameters.
    [[gnu::cold]] void follow(const rsi::Parameters& parameters) noexcept;

    // One cycle.
    void keep(const rsi::LearntLoad& learnt) noexcept;

    // CRC-32 of the parameters for which it keeps loads.
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
    rsi::LearntLoad stored_{};
};

}  // namespace rsi::application
