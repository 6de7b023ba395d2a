// Campaign: a row of each run, made by as many threads as wanted.
#include "sil/studies/campaign/campaign.hpp"

#include <fmt/format.h>

#include <exception>
#include <stdexcept>

#include "sil/studies/campaign/campaign_folder.hpp"
#include "sil/studies/campaign/row_file.hpp"

namespace sil {
namespace {

MadeRow drive(const CampaignWorld& world, std::uint64_t number) {
    try {
        const CampaignRow row = world.run(number);
        return {row_line(row), row.outcome.end_time_s};
    } catch (const std::exception& error) {
        throw std::runtime_error(fmt::format("run {}: {}", number, error.what()));
    }
}

}  // namespace

RowProgress run_campaign(const CampaignWorld& world, const std::filesystem::path& output, unsigned jobs,
                         const std::atomic<bool>& stop, const RowListener& listener) {
    const CampaignFolder folder{output, world.settings()};
    RowFile file{folder.rows(), row_header()};
    return make_rows(
        file, {world.settings().runs, jobs, [&world](std::uint64_t number) { return drive(world, number); }},
        stop, listener);
}

}  // namespace sil
