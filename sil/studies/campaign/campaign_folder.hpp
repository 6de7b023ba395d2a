// Campaign folder: holds the rows of one campaign and no other, and is used by one program at a time.
#pragma once

#include <filesystem>

#include "sil/studies/campaign/settings.hpp"

namespace sil {

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
    void compare_or_store(const CampaignSettings& settings);

    std::filesystem::path path_;
    int lock_{-1};
};

}  // namespace sil
