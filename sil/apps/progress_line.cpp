#include "sil/apps/progress_line.hpp"

#include <fmt/format.h>
#include <unistd.h>

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

}  // namespace sil
