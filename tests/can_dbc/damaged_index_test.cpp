// The receiver's place in its window, which memory has changed: nothing beyond the window is read or written.
#include <gtest/gtest.h>

#include <cstddef>

#include "rsi/can_dbc/e2e/state_machine.hpp"
#include "tests/support/memory_damage.hpp"

namespace {

using rsi::can_dbc::e2e::CheckStatus;

constexpr rsi::can_dbc::e2e::StateMachineSettings settings{6U, {1U, 1U}, {1U, 2U}, {3U, 1U}, true};
using Machine = rsi::can_dbc::e2e::StateMachine<settings>;

TEST(ADamagedIndex, OfTheReceiverStaysInItsWindow) {
    Machine sound;
    for (int frame = 0; frame < 8; ++frame) {
        sound.update(CheckStatus::ok);
    }
    for (std::size_t byte = 0U; byte < sizeof sound; ++byte) {
        for (unsigned bit = 0U; bit < 8U; ++bit) {
            rsi_test::Fenced<Machine> fenced;
            fenced.object = sound;
            rsi_test::flip(fenced.object, byte, bit);
            for (int frame = 0; frame < 8; ++frame) {
                fenced.object.update(CheckStatus::error);
            }
            EXPECT_TRUE(fenced.is_whole()) << byte << ' ' << bit;
        }
    }
}

}  // namespace
