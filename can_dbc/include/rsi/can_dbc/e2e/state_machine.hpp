// AUTOSAR's end-to-end receiver state machine (E2E_SMCheck): from the checks of single frames to a statement
// about the channel. A single damaged frame does not make a channel invalid, and a channel that keeps
// damaging frames is not used although some of them arrive whole.
//
// One window for all states, as in release 4.2. Not here: the window sizes of each state and the clearing of
// the window that later releases added.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "rsi/can_dbc/e2e/check_status.hpp"

namespace rsi::can_dbc::e2e {

enum class ChannelState : std::uint8_t {
    no_data,  // no undamaged frame since the start
    init,     // frames arrive, too few of them to judge
    valid,    // the signals may be used
    invalid,  // they may not: too many frames damaged, or too few in sequence
};

// Requirements on the last checks, as many as the window holds.
struct StateLimits {
    std::uint8_t minimum_ok{1U};      // at least so many were ok or ok_some_lost
    std::uint8_t maximum_errors{0U};  // at most so many were error
};

struct StateMachineSettings {
    std::uint8_t window_size{1U};  // checks that are remembered, the newest included
    StateLimits init{};            // to become valid from init; more errors make it invalid
    StateLimits valid{};           // to stay valid
    StateLimits invalid{};         // to become valid again

    // AUTOSAR's machine spends the first frame on the way from no_data to init. When this is set, that frame
    // is already judged by the limits of init, so that with minimum_ok 1 the first good frame is valid.
    bool first_frame_counts{false};
};

// Whether every state can be reached and left, and coming in is never easier than staying in.
constexpr bool are_consistent(const StateMachineSettings& settings) {
    const auto fits = [&settings](const StateLimits& limits) {
        return limits.minimum_ok >= 1U && limits.minimum_ok + limits.maximum_errors <= settings.window_size;
    };
    return fits(settings.init) && fits(settings.valid) && fits(settings.invalid) &&
           settings.valid.minimum_ok <= settings.init.minimum_ok &&
           settings.init.minimum_ok <= settings.invalid.minimum_ok &&
           settings.valid.maximum_errors >= settings.init.maximum_errors &&
           settings.init.maximum_errors >= settings.invalid.maximum_errors;
}

// Watches one channel, which is one data identifier. The caller owns it, one a message; `settings` is a
// constant at namespace scope.
template <const StateMachineSettings& settings>
class StateMachine {
    static_assert(are_consistent(settings),
                  "minimum_ok and maximum_errors of each state must fit into the window together, minimum_ok "
                  "be at least 1, and grow (maximum_errors fall) from valid over init to invalid");

 public:
    // Takes the status of one check: of every received frame, and no_new_data once for a cycle without one.
    constexpr void update(CheckStatus status) {
        if (state_ == ChannelState::no_data) {
            if (status == CheckStatus::error || status == CheckStatus::no_new_data) {
                return;
            }
            state_ = ChannelState::init;
            if constexpr (!settings.first_frame_counts) {
                return;
            }
        }
        remember(status);
        state_ = next_state();
    }

    constexpr ChannelState state() const { return state_; }
    constexpr bool is_valid() const { return state_ == ChannelState::valid; }

    // Counts of the checks in the window, since leaving no_data.
    constexpr std::uint8_t ok_count() const { return ok_count_; }
    constexpr std::uint8_t error_count() const { return error_count_; }

 private:
    // Repeated frames, wrong sequences and empty cycles take a place in the window and count as neither.
    constexpr void remember(CheckStatus status) {
        // Bounded before it is used: within the window, whatever memory has made of it.
        newest_ = static_cast<std::uint8_t>((newest_ + 1U) % settings.window_size);
        CheckStatus& oldest = window_[newest_];
        ok_count_ = static_cast<std::uint8_t>(ok_count_ - count_of_ok(oldest) + count_of_ok(status));
        error_count_ =
            static_cast<std::uint8_t>(error_count_ - count_of_error(oldest) + count_of_error(status));
        oldest = status;
    }

    static constexpr std::uint8_t count_of_ok(CheckStatus status) { return is_usable(status) ? 1U : 0U; }
    static constexpr std::uint8_t count_of_error(CheckStatus status) {
        return status == CheckStatus::error ? 1U : 0U;
    }

    constexpr bool holds(const StateLimits& limits) const {
        return error_count_ <= limits.maximum_errors && ok_count_ >= limits.minimum_ok;
    }

    constexpr ChannelState next_state() const {
        if (state_ == ChannelState::init) {
            if (holds(settings.init)) {
                return ChannelState::valid;
            }
            return error_count_ > settings.init.maximum_errors ? ChannelState::invalid : ChannelState::init;
        }
        const StateLimits& limits = state_ == ChannelState::valid ? settings.valid : settings.invalid;
        return holds(limits) ? ChannelState::valid : ChannelState::invalid;
    }

    static constexpr std::array<CheckStatus, settings.window_size> make_empty_window() {
        std::array<CheckStatus, settings.window_size> window{};
        for (CheckStatus& status : window) {
            status = CheckStatus::no_new_data;
        }
        return window;
    }

    std::array<CheckStatus, settings.window_size> window_{make_empty_window()};
    std::uint8_t newest_{0U};  // the place of the last check; the next one takes that after it
    std::uint8_t ok_count_{0U};
    std::uint8_t error_count_{0U};
    ChannelState state_{ChannelState::no_data};
};

}  // namespace rsi::can_dbc::e2e
