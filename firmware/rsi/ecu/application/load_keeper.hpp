// Load keeper: carries what the component has learnt of the load over a restart.
#pragma once

#include <cstdint>

#include "rsi/component.hpp"
#include "rsi/hal/storage.hpp"

namespace rsi::application {

// Stores when the load is known to be another than stored, and at most once a minute: memories wear out.
class LoadKeeper {
 public:
    // `storage` must outlive the keeper. Without one nothing is kept.
    void use(hal::Storage& storage) noexcept { storage_ = &storage; }

    // Before the first cycle: gives the component what was stored for these parameters, if it was. `doubted`:
    // the load may have changed since.
    [[gnu::cold]] void restore(const rsi::Parameters& parameters, rsi::Component& component,
                               bool doubted) noexcept;

    // Other parameters from now on: what is learnt from here is stored for them.
    [[gnu::cold]] void follow(const rsi::Parameters& parameters) noexcept;

    // One cycle.
    void keep(const rsi::LearntLoad& learnt) noexcept;

 private:
    hal::Storage* storage_{nullptr};
    std::uint32_t parameters_check_word_{0U};
    std::uint32_t cycles_since_store_{0U};
    rsi::LearntLoad stored_{};
};

}  // namespace rsi::application
