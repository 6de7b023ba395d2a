// Whole folder: a folder of results that appears complete or not at all.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace sil {

// Results are written into a folder NAME.partial beside the one that is meant; commit() gives it its name.
// Without commit the destructor removes it. Results of an earlier replay of the name are removed at the
// start, so that they cannot pass for this one's.
class WholeFolder {
 public:
    // `contents`: the files that a result may have. Throws std::runtime_error when the folder exists with
    // anything else in it (then it is not, or not only, a result, and stays) or cannot be made.
    WholeFolder(std::filesystem::path folder, const std::vector<std::string>& contents);
    ~WholeFolder();
    WholeFolder(const WholeFolder&) = delete;
    WholeFolder& operator=(const WholeFolder&) = delete;

    // Where to write.
    const std::filesystem::path& path() const { return partial_; }

    // Throws std::runtime_error.
    void commit();

 private:
    std::filesystem::path folder_;
    std::filesystem::path partial_;
};

}  // namespace sil
