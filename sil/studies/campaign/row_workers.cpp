// Row workers: each thread takes the next missing row until none is left.
#include "sil/studies/campaign/row_workers.hpp"

#include <chrono>
#include <exception>
#include <functional>
#include <mutex>
#include <numeric>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace sil {
namespace {

// Takes a row that was made; called by one thread at a time.
using RowKeeper = std::function<void(std::uint64_t number, const MadeRow& row)>;

class Workers {
 public:
    Workers(const RowWork& work, std::vector<std::uint64_t> missing, RowKeeper keep,
            const std::atomic<bool>& stop, const RowListener& listener)
        : work_{work},
          keep_{std::move(keep)},
          stop_{stop},
          listener_{listener},
          missing_{std::move(missing)} {
        progress_.total = work.total;
        progress_.begun_with = progress_.finished = work.total - missing_.size();
    }

    RowProgress work() {
        std::vector<std::thread> threads;
        try {
            while (threads.size() < work_.jobs) {
                threads.emplace_back([this] { work_alone(); });
            }
        } catch (const std::system_error&) {
            // No more threads than these are to be had.
            if (threads.empty()) {
                throw;
            }
        }
        for (std::thread& thread : threads) {
            thread.join();
        }
        if (failure_) {
            std::rethrow_exception(failure_);
        }
        return progress_;
    }

 private:
    void work_alone() {
        try {
            if (work_.make_together) {
                work_.make_together([this] { return next_missing(); },
                                    [this](std::uint64_t number, const MadeRow& row) {
                                        keep(number, row);
                                        return !stop_ && !failed_;
                                    });
                return;
            }
            while (const std::optional<std::uint64_t> number = next_missing()) {
                keep(*number, work_.make(*number));
            }
        } catch (...) {
            fail(std::current_exception());
        }
    }

    std::optional<std::uint64_t> next_missing() {
        if (stop_ || failed_) {
            return std::nullopt;
        }
        const std::size_t index = next_++;
        return index < missing_.size() ? std::optional{missing_[index]} : std::nullopt;
    }

    void keep(std::uint64_t number, const MadeRow& row) {
        const std::lock_guard<std::mutex> lock{mutex_};
        keep_(number, row);
        ++progress_.finished;
        progress_.simulated_s += row.simulated_s;
        progress_.elapsed_s =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
        if (listener_) {
            listener_(progress_);
        }
    }

    void fail(std::exception_ptr failure) {
        const std::lock_guard<std::mutex> lock{mutex_};
        if (!failure_) {
            failure_ = std::move(failure);
        }
        failed_ = true;
    }

    const RowWork& work_;
    const RowKeeper keep_;
    const std::atomic<bool>& stop_;
    const RowListener& listener_;
    const std::chrono::steady_clock::time_point start_{std::chrono::steady_clock::now()};
    const std::vector<std::uint64_t> missing_;
    std::atomic<std::size_t> next_{0U};
    std::atomic<bool> failed_{false};
    std::mutex mutex_;  // of all below
    RowProgress progress_{};
    std::exception_ptr failure_{};
};

}  // namespace

RowProgress make_rows(RowFile& file, const RowWork& work, const std::atomic<bool>& stop,
                      const RowListener& listener) {
    std::vector<std::uint64_t> missing;
    for (std::uint64_t number = 0U; number < work.total; ++number) {
        if (file.finished_runs().count(number) == 0U) {
            missing.push_back(number);
        }
    }
    const RowProgress progress =
        Workers{work, std::move(missing),
                [&file](std::uint64_t number, const MadeRow& row) { file.append(number, row.line); }, stop,
                listener}
            .work();
    if (progress.finished >= progress.total) {
        file.finish();
    }
    return progress;
}

RowProgress make_lines(std::vector<std::string>& lines, std::uint64_t first, const RowWork& work,
                       const std::atomic<bool>& stop, const RowListener& listener) {
    lines.assign(work.total, {});
    std::vector<std::uint64_t> numbers(work.total);
    std::iota(numbers.begin(), numbers.end(), first);
    const auto keep = [&](std::uint64_t number, const MadeRow& row) { lines[number - first] = row.line; };
    return Workers{work, std::move(numbers), keep, stop, listener}.work();
}

}  // namespace sil
