// Campaign: a row of each run, made by as many threads as wanted.
#include "sil/studies/campaign/campaign.hpp"

#include <fmt/format.h>

#include <exception>
#include <stdexcept>

#include "sil/files/file_io.hpp"
#include "sil/studies/campaign/campaign_folder.hpp"
#include "sil/studies/campaign/campaign_part.hpp"
#include "sil/studies/campaign/row_file.hpp"
#include "sil/studies/campaign/run_trace.hpp"

namespace sil {
namespace {

// `traces`: their folder.
MadeRow drive_with_trace(const CampaignWorld& world, std::uint64_t number,
                         const std::filesystem::path& traces) {
    try {
        RunTrace trace;
        const CampaignRow row = world.run(number, &trace);
        trace.write(traces, row);
        return {row_line(row), row.outcome.end_time_s};
    } catch (const std::exception& error) {
        throw std::runtime_error(fmt::format("run {}: {}", number, error.what()));
    }
}

void refuse_rows_without_traces(const RowFile& file, const std::filesystem::path& traces) {
    for (const std::uint64_t number : file.finished_runs()) {
        if (!std::filesystem::exists(trace_file(traces, number))) {
            throw InputError(fmt::format("{}: run {} was driven without a trace; use another output folder",
                                         traces.parent_path().string(), number));
        }
    }
}

// The rows of a folder of parts are not in one file.
void refuse_parts(const std::filesystem::path& output) {
    if (!parts_of(output).empty()) {
        throw InputError(fmt::format(
            "{} holds parts of a campaign; go on with `rsi-sil campaign part`, report on them with "
            "`rsi-sil campaign report`, or use another output folder",
            output.string()));
    }
}

}  // namespace

RowWork campaign_work(const CampaignWorld& world, std::uint64_t count, unsigned jobs) {
    RowWork work{count, jobs};
    work.make_together = [&world](const NextRow& next, const RowTaker& take) {
        world.run_together(next, [&take](const CampaignRow& row) {
            return take(row.draw.number, {row_line(row), row.outcome.end_time_s});
        });
    };
    return work;
}

RowProgress run_campaign(const CampaignWorld& world, const std::filesystem::path& output, unsigned jobs,
                         const std::atomic<bool>& stop, const RowListener& listener, bool with_traces) {
    refuse_parts(output);
    const CampaignFolder folder{output, world.settings()};
    RowFile file{folder.rows(), row_header()};
    const std::filesystem::path traces = with_traces ? output / "traces" : std::filesystem::path{};
    if (with_traces) {
        refuse_rows_without_traces(file, traces);
        make_folder(traces);
    }
    RowWork work = campaign_work(world, world.settings().runs, jobs);
    if (with_traces) {
        work = {world.settings().runs, jobs};
        work.make = [&](std::uint64_t number) { return drive_with_trace(world, number, traces); };
    }
    return make_rows(file, work, stop, listener);
}

}  // namespace sil
