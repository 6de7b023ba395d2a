// Row file: runs.csv, to which finished runs are appended line by line, and which a later call takes up
// again.
#pragma once

#include <cstdint>
#include <filesystem>
#include <set>
#include <string>

namespace sil {

class RowFile {
 public:
    // Opens or begins the file. A last line without its end is dropped: it was being written when a campaign
    // was killed. Throws InputError when the file has other columns, or a damaged line before the last.
    RowFile(std::filesystem::path path, const std::string& header);
    ~RowFile();
    RowFile(const RowFile&) = delete;
    RowFile& operator=(const RowFile&) = delete;

    // The numbers of the runs whose rows are in the file.
    const std::set<std::uint64_t>& finished_runs() const { return finished_runs_; }

    // Writes a row's line, which begins with the run's number, in one piece. Throws std::runtime_error when
    // the system refuses.
    void append(std::uint64_t run, const std::string& line);

    // Sorts the rows by run number. Nothing can be appended afterwards.
    void finish();

 private:
    void take_up(const std::string& header);
    void open();
    void close();

    std::filesystem::path path_;
    std::set<std::uint64_t> finished_runs_;
    int descriptor_{-1};
};

}  // namespace sil
