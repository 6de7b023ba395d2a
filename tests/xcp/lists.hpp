// Lists of measurements, commanded by a master with the key.
#pragma once

#include <gtest/gtest.h>

#include "tests/xcp/bench.hpp"

namespace testing_xcp {

inline const Bytes good{0xFF};
inline constexpr std::uint8_t with_time = 0x10U;

inline Bytes error(int code) {
    return {0xFE, static_cast<std::uint8_t>(code)};
}

class Lists : public ::testing::Test {
 protected:
    Lists() { bench.connect_and_unlock(); }

    Bytes allot_lists(std::uint8_t count) { return bench.command({0xD5, 0, count, 0}); }
    Bytes allot_parts(std::uint8_t list, std::uint8_t count) {
        return bench.command({0xD4, 0, list, 0, count});
    }
    Bytes allot_entries(std::uint8_t list, std::uint8_t part, std::uint8_t count) {
        return bench.command({0xD3, 0, list, 0, part, count});
    }
    Bytes point_to(std::uint8_t list, std::uint8_t part, std::uint8_t entry) {
        return bench.command({0xE2, 0, list, 0, part, entry});
    }
    Bytes write(std::uint32_t address, std::uint8_t size) {
        return bench.command(Bench::with_word({0xE1, 0xFF, size, 0}, address));
    }
    Bytes set_mode(std::uint8_t list, std::uint8_t mode, std::uint8_t event = 0U,
                   std::uint8_t prescaler = 1U) {
        return bench.command({0xE0, mode, list, 0, event, 0, prescaler, 0});
    }
    Bytes start(std::uint8_t list) { return bench.command({0xDE, 1, list, 0}); }
    Bytes stop(std::uint8_t list) { return bench.command({0xDE, 0, list, 0}); }
    Bytes select(std::uint8_t list) { return bench.command({0xDE, 2, list, 0}); }

    // One list with one part of one entry each: the outputs' first word, and the one after it.
    void two_lists() {
        ASSERT_EQ(bench.command({0xD6}), good);
        ASSERT_EQ(allot_lists(2U), good);
        for (std::uint8_t list = 0U; list < 2U; ++list) {
            ASSERT_EQ(allot_parts(list, 1U), good);
        }
        for (std::uint8_t list = 0U; list < 2U; ++list) {
            ASSERT_EQ(allot_entries(list, 0U, 1U), good);
            ASSERT_EQ(point_to(list, 0U, 0U), good);
            ASSERT_EQ(write(map::outputs_at + 4U * list, 4U), good);
        }
    }

    Bench bench;
};

}  // namespace testing_xcp
