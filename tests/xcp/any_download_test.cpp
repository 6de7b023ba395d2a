// For any write, in any order, whole or in pieces, and broken off anywhere: the component runs on parameters
// that validate accepts, and on written ones only.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>

#include "rsi/parameters.hpp"
#include "tests/xcp/bench.hpp"

namespace testing_xcp {
namespace {

constexpr std::size_t field_count = rsi::application::section::value_count;

std::uint32_t bits_of(float value) {
    std::uint32_t word = 0U;
    std::memcpy(&word, &value, sizeof word);
    return word;
}

// The limits, beside them, far beyond, and what is no number.
std::vector<std::uint32_t> trials(std::size_t field) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    if (field >= rsi::parameter_fields.size()) {
        const rsi::SelectionField& selection = rsi::selection_fields[field - rsi::parameter_fields.size()];
        const auto count = static_cast<std::uint32_t>(selection.choice_count);
        return {0U, 1U, count - 1U, count, 0xFFFFFFFFU, 0x80000000U};
    }
    const rsi::ParameterField& number = rsi::parameter_fields[field];
    std::vector<std::uint32_t> words;
    for (const float value :
         {number.minimum, number.maximum, std::nextafter(number.minimum, -infinity),
          std::nextafter(number.maximum, infinity), 0.5F * (number.minimum + number.maximum), -1.0e30F,
          infinity, std::numeric_limits<float>::quiet_NaN()}) {
        words.push_back(bits_of(value));
    }
    return words;
}

class AnyDownload : public ::testing::TestWithParam<unsigned> {
 protected:
    AnyDownload() {
        bench.connect_and_unlock();
        for (std::size_t field = 0U; field < field_count; ++field) {
            written[field].insert(word_in_use(field));
        }
    }

    std::uint32_t word_in_use(std::size_t field) {
        std::uint32_t word = 0U;
        std::memcpy(&word, static_cast<const char*>(static_cast<const void*>(&bench.used())) + 4U * field,
                    4U);
        return word;
    }

    void check() {
        const rsi_validation answer = rsi::validate(bench.used());
        ASSERT_EQ(answer.accepted, 1) << answer.field << ' ' << answer.reason;
        for (std::size_t field = 0U; field < field_count; ++field) {
            ASSERT_EQ(written[field].count(word_in_use(field)), 1U) << "value " << field;
        }
    }

    unsigned below(std::size_t count) { return static_cast<unsigned>(random() % count); }

    // A value at once, in two commands, or broken off after some of its bytes.
    void write_one() {
        const std::size_t field = below(field_count);
        const std::vector<std::uint32_t> words = trials(field);
        const std::uint32_t word = (below(3U) == 0U) ? bits_of_start[field] : words[below(words.size())];
        const Bytes bytes = Bench::with_word({}, word);
        const std::uint32_t address = map::parameters_at + static_cast<std::uint32_t>(4U * field);
        const unsigned cut = 1U + below(7U);  // 4 and more: whole
        bench.download(address, {bytes.begin(), bytes.begin() + std::min(cut, 4U)});
        check();
        if (cut < 4U && below(2U) == 0U) {
            return;  // broken off
        }
        if (cut < 4U) {
            bench.download(address + cut, {bytes.begin() + cut, bytes.end()});
        }
        written[field].insert(word);
    }

    void do_anything() {
        switch (below(16U)) {
            case 0U:
                bench.command({0xEB, 0x01, 0, static_cast<std::uint8_t>(below(2U))});
                break;
            case 1U:
                bench.command({0xE4, 0, 1, 0, 0});
                break;
            case 2U:
                bench.cycles(static_cast<int>(below(250U)));
                break;
            case 3U:
                bench.command({0xF9, 0x01});
                break;
            case 4U:
                if (below(4U) == 0U) {
                    bench.restart();
                }
                bench.connect_and_unlock();
                break;
            default:
                write_one();
                break;
        }
        check();
    }

    Bench bench;
    std::mt19937 random{GetParam()};
    std::array<std::set<std::uint32_t>, field_count> written;
    std::array<std::uint32_t, field_count> bits_of_start{};
};

TEST_P(AnyDownload, NeverMakesTheComponentRunOnARefusedPage) {
    for (std::size_t field = 0U; field < field_count; ++field) {
        bits_of_start[field] = word_in_use(field);
    }
    std::uint32_t changes = 0U;
    for (int k = 0; k < 400; ++k) {
        do_anything();
        ASSERT_FALSE(HasFatalFailure()) << "action " << k;
        changes = std::max(changes, bench.changes());
    }
    EXPECT_GT(changes, 5U) << "nothing was ever taken over, so this proves nothing";
}

INSTANTIATE_TEST_SUITE_P(Seeds, AnyDownload, ::testing::Range(1U, 9U));

// Field by field: both limits and beyond them, from the calibration as it is.
TEST(EachField, IsTakenOverIfItsPageIsAcceptedAndOnlyThen) {
    Bench bench;
    bench.connect_and_unlock();
    unsigned accepted = 0U;
    unsigned refused = 0U;
    for (std::size_t field = 0U; field < field_count; ++field) {
        const std::uint32_t address = map::parameters_at + static_cast<std::uint32_t>(4U * field);
        const std::uint32_t start = bench.word(address);
        for (const std::uint32_t word : trials(field)) {
            rsi::Parameters wanted = image_parameters();
            std::memcpy(static_cast<char*>(static_cast<void*>(&wanted)) + 4U * field, &word, 4U);
            const bool is_good = rsi::validate(wanted).accepted == 1;
            ASSERT_TRUE(Bench::is_good(bench.download(address, Bench::with_word({}, word))));
            const Bytes status = bench.upload(map::change_at, 3U);
            EXPECT_EQ(status[2] == 0U, is_good) << "value " << field;
            bench.cycles(status[1] == 1U ? 200 : 1);
            EXPECT_EQ(std::memcmp(&bench.used(), &wanted, sizeof wanted) == 0, is_good) << "value " << field;
            (is_good ? accepted : refused) += 1U;
            ASSERT_TRUE(Bench::is_good(bench.download(address, Bench::with_word({}, start))));
            bench.cycles(200);
        }
    }
    EXPECT_GT(accepted, field_count);
    EXPECT_GT(refused, field_count);
}

}  // namespace
}  // namespace testing_xcp
