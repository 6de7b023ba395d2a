// Campaign folder: holds the rows of one campaign and no other, and is used by one program at a time.
#pragma once

#include <filesystem>
#include <string>

#include "sil/studies/campaign/settings.hpp"

namespace sil {

// The same for the same settings, but for the number of runs, the same vehicle files and the same program.
// Throws InputError for a file that cannot be read.
std::string campaign_fingerprint(CampaignSettings settings);

// Begins a folder for parts (campaign_part.hpp), which many programs write at a time, or checks it, as
// CampaignFolder does; refuses one with runs.csv.
void begin_campaign_folder(const std::filesystem::path& path, const CampaignSettings& settings);

class CampaignFolder {
 public:
    // Begins the folder, or checks that it holds the rows of these very settings, of the same vehicle files
    // and of the same program; only the number of runs may have grown. Throws InputError that names the
    // first difference.
    CampaignFolder(const std::filesystem::path& path, const CampaignSettings& settings);
    ~CampaignFolder();
    CampaignFolder(const CampaignFolder&) = delete;
    CampaignFolder& operator=(const CampaignFolder&) = delete;

    std::filesystem::path rows() const { return path_ / "runs.csv"; }

 private:
    void lock();

    std::filesystem::path path_;
    int lock_{-1};
};

}  // namespace sil
