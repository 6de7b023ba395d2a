// Campaign: threads that take the next missing run until none is left.
#include "sil/studies/campaign/campaign.hpp"

#include <fmt/format.h>

#include <chrono>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

#include "sil/studies/campaign/campaign_folder.hpp"
#include "sil/studies/campaign/row_file.hpp"

namespace sil {
namespace {

class Workers {
 public:
    Workers(const CampaignWorld& world, RowFile& file, unsigned jobs, const std::atomic<bool>& stop,
            const CampaignListener& listener)
        : world_{world}, file_{file}, stop_{stop}, listener_{listener} {
        progress_.total = world.settings().runs;
        progress_.begun_with = file.finished_runs().size();
        progress_.finished = progress_.begun_with;
        progress_.jobs = jobs;
        for (std::uint64_t number = 0U; number < progress_.total; ++number) {
            if (file.finished_runs().count(number) == 0U) {
                missing_.push_back(number);
            }
        }
    }

    CampaignProgress work() {
        std::vector<std::thread> threads;
        try {
            while (threads.size() < progress_.jobs) {
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
        while (!stop_ && !failed_) {
            const std::size_t index = next_++;
            if (index >= missing_.size()) {
                return;
            }
            try {
                keep(drive(missing_[index]));
            } catch (...) {
                fail(std::current_exception());
            }
        }
    }

    CampaignRow drive(std::uint64_t number) const {
        try {
            return world_.run(number);
        } catch (const std::exception& error) {
            throw std::runtime_error(fmt::format("run {}: {}", number, error.what()));
        }
    }

    void keep(const CampaignRow& row) {
        const std::string line = row_line(row);
        const std::lock_guard<std::mutex> lock{mutex_};
        file_.append(row.draw.number, line);
        ++progress_.finished;
        progress_.simulated_s += row.outcome.end_time_s;
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

    const CampaignWorld& world_;
    RowFile& file_;
    const std::atomic<bool>& stop_;
    const CampaignListener& listener_;
    const std::chrono::steady_clock::time_point start_{std::chrono::steady_clock::now()};
    std::vector<std::uint64_t> missing_;
    std::atomic<std::size_t> next_{0U};
    std::atomic<bool> failed_{false};
    std::mutex mutex_;  // of all below
    CampaignProgress progress_;
    std::exception_ptr failure_;
};

}  // namespace

CampaignProgress run_campaign(const CampaignWorld& world, const std::filesystem::path& output, unsigned jobs,
                              const std::atomic<bool>& stop, const CampaignListener& listener) {
    const CampaignFolder folder{output, world.settings()};
    RowFile file{folder.rows(), row_header()};
    const CampaignProgress progress = Workers{world, file, jobs, stop, listener}.work();
    if (progress.finished >= progress.total) {
        file.finish();
    }
    return progress;
}

}  // namespace sil
