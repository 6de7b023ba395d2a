// Event marks: gnuplot assignments.
#include "sil/results/event_marks.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "sil/files/file_io.hpp"
#include "sil/units.hpp"

namespace sil {
namespace {

std::string gnuplot_number(double value) {
    return std::isfinite(value) ? fmt::format("{:.9g}", value) : "NaN";
}

std::string assignments(const char* name, const std::optional<EventMoment>& event) {
    if (!event) {
        return fmt::format("{0}_time_s = NaN\n{0}_ay_g = NaN\n{0}_roll_deg = NaN\n", name);
    }
    return fmt::format("{0}_time_s = {1}\n{0}_ay_g = {2}\n{0}_roll_deg = {3}\n", name,
                       gnuplot_number(event->time_s),
                       gnuplot_number(event->lateral_acceleration_mps2 / g_mps2),
                       gnuplot_number(event->roll_angle_rad * degrees_per_radian));
}

// In gnuplot's single quotes only the quote itself is special.
std::string quoted(const std::string& text) {
    std::string result = "'";
    for (const char character : text) {
        const bool is_control = static_cast<unsigned char>(character) < 0x20U;
        result += is_control ? std::string(" ") : std::string(character == '\'' ? 2U : 1U, character);
    }
    return result + "'";
}

}  // namespace

std::string event_marks(const RunEvents& events, double static_stability_factor, const std::string& title) {
    return fmt::format("title_text = {}\nend_time_s = {}\nssf = {}\n", quoted(title),
                       gnuplot_number(events.end_time_s), gnuplot_number(static_stability_factor)) +
           assignments("warning", events.warning) + assignments("one_wheel_lift", events.one_wheel_lift) +
           assignments("two_wheel_lift", events.two_wheel_lift) +
           assignments("ssf_crossing", events.ssf_crossing);
}

void write_event_marks(const RunEvents& events, double static_stability_factor, const std::string& title,
                       const std::filesystem::path& path) {
    write_file_atomically(path, event_marks(events, static_stability_factor, title));
}

}  // namespace sil
