// Comparison of two candump logs: walk both, find where they agree again, tell what differs.
#include "tests/application/regression/candump_compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

namespace sil {
namespace {

constexpr std::size_t resynchronisation_window = 32U;
constexpr std::size_t resynchronisation_run = 3U;  // so many equal frames are no coincidence

std::int64_t time_us(const LoggedFrame& logged) {
    return logged.frame.receive_time.nanoseconds / 1'000;
}

bool same_content(const LoggedFrame& a, const LoggedFrame& b) {
    return a.frame.identifier == b.frame.identifier && a.frame.extended == b.frame.extended &&
           a.frame.flexible_data_rate == b.frame.flexible_data_rate &&
           (a.fd_flags & canonical_fd_flags) == (b.fd_flags & canonical_fd_flags) &&
           a.frame.length == b.frame.length &&
           std::equal(a.frame.data.begin(), a.frame.data.begin() + a.frame.length, b.frame.data.begin());
}

bool same_kind(const LoggedFrame& a, const LoggedFrame& b) {
    return a.frame.identifier == b.frame.identifier && a.frame.extended == b.frame.extended &&
           a.frame.flexible_data_rate == b.frame.flexible_data_rate;
}

// How many frames of each log belong to a difference, 0 or more each, not both 0.
struct Extent {
    std::size_t expected{0U};
    std::size_t actual{0U};
};

class Comparison {
 public:
    Comparison(const std::vector<LoggedFrame>& expected, const std::vector<LoggedFrame>& actual,
               const CompareOptions& options)
        : expected_(expected), actual_(actual), options_(options) {
        if (options.times_relative_to_first && !expected.empty() && !actual.empty()) {
            time_offset_us_ = time_us(actual.front()) - time_us(expected.front());
        }
    }

    LogComparison run() {
        while (expected_at_ < expected_.size() || actual_at_ < actual_.size()) {
            if (expected_at_ < expected_.size() && actual_at_ < actual_.size() &&
                same_content(expected_[expected_at_], actual_[actual_at_])) {
                if (!same_time()) {
                    note({1U, 1U});
                }
                ++expected_at_;
                ++actual_at_;
                continue;
            }
            const Extent extent = difference_here();
            note(extent);
            expected_at_ += extent.expected;
            actual_at_ += extent.actual;
        }
        return result();
    }

 private:
    std::int64_t time_difference_us() const {
        return time_us(actual_[actual_at_]) - time_offset_us_ - time_us(expected_[expected_at_]);
    }

    bool same_time() const { return std::abs(time_difference_us()) <= options_.time_tolerance_us; }

    // Equal content from these frames on, for `count` frames or to the end of one log, but at least for one.
    bool agree(std::size_t expected_at, std::size_t actual_at, std::size_t count) const {
        std::size_t agreed = 0U;
        while (agreed < count && expected_at + agreed < expected_.size() &&
               actual_at + agreed < actual_.size()) {
            if (!same_content(expected_[expected_at + agreed], actual_[actual_at + agreed])) {
                return false;
            }
            ++agreed;
        }
        return agreed > 0U;
    }

    // A changed frame first (both logs go on in step), then the smallest insertion or omission after which
    // the logs agree again.
    Extent difference_here() const {
        const std::size_t expected_left = expected_.size() - expected_at_;
        const std::size_t actual_left = actual_.size() - actual_at_;
        if (expected_left == 0U || actual_left == 0U) {
            return {std::min<std::size_t>(expected_left, 1U), std::min<std::size_t>(actual_left, 1U)};
        }
        if (same_kind(expected_[expected_at_], actual_[actual_at_]) &&
            agree(expected_at_ + 1U, actual_at_ + 1U, 1U)) {
            return {1U, 1U};
        }
        for (std::size_t skipped = 1U; skipped <= resynchronisation_window; ++skipped) {
            if (agree(expected_at_ + skipped, actual_at_, resynchronisation_run)) {
                return {skipped, 0U};
            }
            if (agree(expected_at_, actual_at_ + skipped, resynchronisation_run)) {
                return {0U, skipped};
            }
        }
        return {1U, 1U};
    }

    std::string text(const LoggedFrame& logged) const {
        std::string line = format_candump_line(logged);
        if (options_.describe) {
            const std::string description = options_.describe(logged.frame);
            line += description.empty() ? "" : "   " + description;
        }
        return line;
    }

    void append_context(std::size_t begin, std::size_t end) {
        for (std::size_t index = begin; index < std::min(end, expected_.size()); ++index) {
            report_ += fmt::format("    {}\n", text(expected_[index]));
        }
    }

    void note(const Extent& extent) {
        ++differences_;
        if (differences_ > options_.differences_shown) {
            return;
        }
        const bool first = differences_ == 1U;
        report_ += fmt::format("{}: expected frame {}, actual frame {}: {}\n",
                               first ? "first difference" : "difference", expected_at_ + 1U, actual_at_ + 1U,
                               kind_of_difference(extent));
        if (first) {
            append_context(expected_at_ - std::min(expected_at_, options_.context_frames), expected_at_);
        }
        for (std::size_t index = 0U; index < extent.expected; ++index) {
            report_ += fmt::format("  - {}\n", text(expected_[expected_at_ + index]));
        }
        for (std::size_t index = 0U; index < extent.actual; ++index) {
            report_ += fmt::format("  + {}\n", text(actual_[actual_at_ + index]));
        }
        if (extent.expected == 1U && extent.actual == 1U) {
            append_byte_marks(expected_[expected_at_], actual_[actual_at_]);
        }
        if (first) {
            const std::size_t after = expected_at_ + extent.expected;
            append_context(after, after + options_.context_frames);
        }
    }

    std::string kind_of_difference(const Extent& extent) const {
        if (extent.actual == 0U) {
            return fmt::format("{} missing", extent.expected);
        }
        if (extent.expected == 0U) {
            return fmt::format("{} too many", extent.actual);
        }
        const LoggedFrame& expected = expected_[expected_at_];
        const LoggedFrame& actual = actual_[actual_at_];
        if (same_content(expected, actual)) {
            return fmt::format("time differs by {} us, tolerance {} us", time_difference_us(),
                               options_.time_tolerance_us);
        }
        if (!same_kind(expected, actual)) {
            return "another identifier";
        }
        if (expected.frame.length != actual.frame.length) {
            return fmt::format("{} bytes expected, {} found", expected.frame.length, actual.frame.length);
        }
        return "other content";
    }

    // '^^' below every byte that differs.
    void append_byte_marks(const LoggedFrame& expected, const LoggedFrame& actual) {
        if (!same_kind(expected, actual)) {
            return;
        }
        LoggedFrame empty = actual;
        empty.frame.length = 0U;
        std::string marks(format_candump_line(empty).size(), ' ');
        const std::size_t length = std::min(expected.frame.length, actual.frame.length);
        for (std::size_t index = 0U; index < length; ++index) {
            marks += expected.frame.data[index] == actual.frame.data[index] ? "  " : "^^";
        }
        marks.erase(marks.find_last_not_of(' ') + 1U);
        if (!marks.empty()) {
            report_ += fmt::format("    {}\n", marks);
        }
    }

    LogComparison result() const {
        LogComparison comparison;
        comparison.equal = differences_ == 0U;
        comparison.differences = differences_;
        if (comparison.equal) {
            comparison.report = fmt::format("the logs agree: {} frames\n", expected_.size());
            return comparison;
        }
        comparison.report =
            fmt::format(
                "the logs differ in {} places ({} frames expected, {} found; '-' expected, '+' found)\n",
                differences_, expected_.size(), actual_.size()) +
            report_;
        if (differences_ > options_.differences_shown) {
            comparison.report +=
                fmt::format("... and {} differences more\n", differences_ - options_.differences_shown);
        }
        return comparison;
    }

    const std::vector<LoggedFrame>& expected_;
    const std::vector<LoggedFrame>& actual_;
    const CompareOptions& options_;
    std::int64_t time_offset_us_{0};
    std::size_t expected_at_{0U};
    std::size_t actual_at_{0U};
    std::size_t differences_{0U};
    std::string report_;
};

}  // namespace

LogComparison compare_logs(const std::vector<LoggedFrame>& expected, const std::vector<LoggedFrame>& actual,
                           const CompareOptions& options) {
    return Comparison(expected, actual, options).run();
}

}  // namespace sil
