// Progress line: how far long work has come, on stderr: over and over on a terminal, now and then in a log.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "sil/studies/campaign/row_workers.hpp"

namespace sil {

class ProgressLine {
 public:
    // Text of the line: progress, rate in rows a second, time left.
    using Text = std::function<std::string(const RowProgress& progress, double rate, double left_s)>;

    explicit ProgressLine(Text text);

    void show(const RowProgress& progress);

 private:
    Text text_;
    bool terminal_;
    double next_s_{0.0};
};

// Throws std::runtime_error where not all `rows` of work that goes on in `folder` are finished.
void require_finished(const RowProgress& progress, const char* rows, const std::filesystem::path& folder);

}  // namespace sil
