// Campaign folder: campaign.toml says what its rows are of.
#include "sil/studies/campaign/campaign_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <sstream>

#include "sil/files/file_io.hpp"
#include "sil/results/versions.hpp"
#include "sil/studies/campaign/fingerprint.hpp"

namespace sil {
namespace {

constexpr const char* made_with = "[made_with]";

std::string fingerprint(const std::filesystem::path& path) {
    return fingerprint_of(read_whole_file(path));
}

// The revision does not tell one build from another, with changes that are not committed or other options.
const std::string& fingerprint_of_this_program() {
    static const std::string value = fingerprint("/proc/self/exe");
    return value;
}

// All that its rows follow from.
std::string origin(const CampaignSettings& settings) {
    const Versions versions = built_versions();
    std::string text = "# The settings of the campaign whose rows are beside; `rsi-sil campaign` wrote it.\n";
    text += to_toml(settings);
    text += fmt::format("\n{}\ncomponent = \"{}\"\ngit_revision = \"{}\"\nprogram = \"{}\"\n", made_with,
                        versions.component, versions.git_revision, fingerprint_of_this_program());
    for (std::size_t i = 0U; i < settings.vehicles.size(); ++i) {
        text += fmt::format("vehicle_{0}_parameters = \"{1}\"\nvehicle_{0}_calibration = \"{2}\"\n", i + 1U,
                            fingerprint(settings.vehicles[i].parameters),
                            fingerprint(settings.vehicles[i].calibration));
    }
    return text;
}

std::string described(const CampaignSettings& settings) {
    return origin(settings) + fmt::format("parts = \"{}\"\n", campaign_fingerprint(settings));
}

std::string line_or_nothing(std::istream& stream) {
    std::string line;
    return std::getline(stream, line) ? line : "nothing";
}

void refuse_difference(const std::filesystem::path& path, const std::string& stored,
                       const std::string& wanted) {
    std::istringstream stored_lines{stored};
    std::istringstream wanted_lines{wanted};
    std::string advice = fmt::format(", or the settings of this one: --settings {}", path.string());
    while (stored_lines && wanted_lines) {
        const std::string there = line_or_nothing(stored_lines);
        const std::string here = line_or_nothing(wanted_lines);
        if (there == made_with || here == made_with) {
            advice = ", so that rows of different programs or vehicles do not get mixed";
        }
        if (there != here) {
            throw InputError(fmt::format(
                "{} is of another campaign: it has `{}` where now there is `{}`. Use another output folder{}",
                path.string(), there, here, advice));
        }
    }
}

void compare_or_store(const std::filesystem::path& folder, const CampaignSettings& settings) {
    const std::filesystem::path file = folder / "campaign.toml";
    if (!std::filesystem::exists(file)) {
        if (std::filesystem::exists(folder / "runs.csv")) {
            throw InputError(
                fmt::format("{} has rows but no campaign.toml to describe them; use another "
                            "output folder",
                            folder.string()));
        }
        write_file_atomically(file, described(settings));
        return;
    }
    CampaignSettings stored_size = settings;
    stored_size.runs = load_campaign(file).runs;
    refuse_difference(file, read_whole_file(file), described(stored_size));
    if (settings.runs < stored_size.runs) {
        throw InputError(fmt::format("{} has {} runs; their number can grow, not shrink to {}",
                                     folder.string(), stored_size.runs, settings.runs));
    }
    if (settings.runs > stored_size.runs) {
        write_file_atomically(file, described(settings));
    }
}

}  // namespace

std::string campaign_fingerprint(CampaignSettings settings) {
    settings.runs = 0U;
    return fingerprint_of(origin(settings));
}

void begin_campaign_folder(const std::filesystem::path& path, const CampaignSettings& settings) {
    if (std::filesystem::exists(path / "runs.csv")) {
        throw InputError(fmt::format(
            "{} holds the rows of a campaign in one file, runs.csv; put parts into another folder",
            path.string()));
    }
    make_folder(path);
    compare_or_store(path, settings);
}

CampaignFolder::CampaignFolder(const std::filesystem::path& path, const CampaignSettings& settings)
    : path_{path} {
    make_folder(path_);
    lock();
    try {
        compare_or_store(path_, settings);
    } catch (...) {
        ::close(lock_);
        throw;
    }
}

CampaignFolder::~CampaignFolder() {
    ::close(lock_);
}

// The system releases the lock when the program ends, however it ends.
void CampaignFolder::lock() {
    const std::filesystem::path file = path_ / ".lock";
    lock_ = ::open(file.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0644);
    if (lock_ < 0) {
        throw InputError(fmt::format("{}: cannot be written: {}", file.string(), std::strerror(errno)));
    }
    if (::flock(lock_, LOCK_EX | LOCK_NB) != 0) {
        ::close(lock_);
        throw InputError(fmt::format(
            "{}: another campaign is writing into this folder; wait for it or end it", path_.string()));
    }
}

}  // namespace sil
