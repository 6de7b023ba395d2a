#include "sil/apps/progress_line.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <stdexcept>
#include <utility>

#include "sil/apps/command_line.hpp"

namespace sil {

ProgressLine::ProgressLine(Text text) : text_{std::move(text)}, terminal_{::isatty(STDERR_FILENO) == 1} {}

void ProgressLine::show(const RowProgress& progress) {
    const bool last = progress.finished == progress.total;
    if (!last && progress.elapsed_s < next_s_) {
        return;
    }
    next_s_ = progress.elapsed_s + (terminal_ ? 0.5 : 10.0);
    const double rate = static_cast<double>(progress.finished - progress.begun_with) / progress.elapsed_s;
    const double left_s = static_cast<double>(progress.total - progress.finished) / rate;
    tell(fmt::format("{}{}{}", terminal_ ? "\r" : "", text_(progress, rate, left_s),
                     terminal_ && !last ? "      " : "\n"));
}

void require_finished(const RowProgress& progress, const char* rows, const std::filesystem::path& folder) {
    if (progress.finished < progress.total) {
        throw std::runtime_error(fmt::format(
            "interrupted after {} of {} {}, which are kept in {}. The same command goes on from there.",
            progress.finished, progress.total, rows, folder.string()));
    }
}

}  // namespace sil
