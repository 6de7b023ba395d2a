#include "sil/studies/identification/identification_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sil/page/study_page.hpp"
#include "sil/studies/identification/calibration_writer.hpp"
#include "sil/studies/identification/report.hpp"
#include "sil/units.hpp"

namespace sil {
namespace {

Table table_of_values(const Identification& result) {
    Table table{"values",
                "",
                {{"value", TableColumn::of_words, ""},
                 {"is", TableColumn::of_words, ""},
                 {"origin", TableColumn::of_words, ""}},
                {},
                "All that depend on the vehicle; the rest of the calibration is as in the template."};
    for (const IdentifiedValue& value : result.values) {
        table.rows.push_back({value.key, value_text(value), value.origin});
    }
    return table;
}

// Root of the mean square of the differences that are known.
template <typename Difference>
double rms(const FittedDrive& drive, const Difference& difference) {
    double squares = 0.0;
    std::size_t count = 0U;
    for (std::size_t place = 0U; place < drive.fitted.size(); ++place) {
        const double value = difference(drive.drive->samples[place], drive.fitted[place]);
        squares += std::isnan(value) ? 0.0 : value * value;
        count += std::isnan(value) ? 0U : 1U;
    }
    return count > 0U ? std::sqrt(squares / static_cast<double>(count)) : DriveSample::not_available;
}

// Residuals of the drive with this name, at its place in a list.
const DriveResidual* residual_of(const std::vector<DriveResidual>& residuals, const std::string& name) {
    const auto found = std::find_if(residuals.begin(), residuals.end(),
                                    [&name](const DriveResidual& each) { return each.name == name; });
    return found == residuals.end() ? nullptr : &*found;
}

Table table_of_drives(const Identification& result, const std::vector<FittedDrive>& drives) {
    Table table{
        "drives",
        "",
        {{"drive", TableColumn::of_words, ""},
         {"kind", TableColumn::of_words, ""},
         {"used from", 2, "s"},
         {"to", 2, "s"},
         {"why no later", TableColumn::of_words, ""},
         {"up to", 2, "g"},
         {"up to", 2, "deg"},
         {"moment, R2", 4, ""},
         {"its residual", 0, "N m rms"},
         {"roll angle predicted within", 3, "deg rms"},
         {"load transfer, R2", 4, ""},
         {"its error", 4, "rms"}},
        {},
        "R2: which share of the variation the model explains. Predicted: by the model alone, from the "
        "measured lateral force."};
    for (std::size_t place = 0U; place < drives.size(); ++place) {
        const PreparedDrive& drive = *drives[place].drive;
        const DriveResidual& moment = result.roll.drives[place];
        const DriveResidual* load =
            drive.has_wheel_loads ? residual_of(result.load_transfer, drive.name) : nullptr;
        table.rows.push_back(
            {drive.name, std::string{drives[place].dynamic ? "dynamic" : "ramp"},
             drive.samples.front().time_s, drive.samples.back().time_s,
             drive.cut_s ? drive.cut_reason : std::string{"it ends"}, drive.largest_parallel_mps2 / g_mps2,
             drive.largest_roll_angle_rad * degrees_per_radian, moment.r_squared, moment.rms,
             degrees_per_radian * rms(drives[place],
                                      [](const RollSample& sample, const FittedSample& fitted) {
                                          return sample.roll_angle_rad - fitted.predicted_roll_angle_rad;
                                      }),
             load != nullptr ? load->r_squared : DriveSample::not_available,
             load != nullptr ? load->rms : DriveSample::not_available});
    }
    return table;
}

// A line of one drive; left out where none of its values is known.
template <typename Value>
void add_line(StudyChart& chart, const FittedDrive& drive, StudyLine line, const Value& value) {
    const std::vector<RollSample>& samples = drive.drive->samples;
    const std::size_t stride = chart_stride(samples.size());
    bool is_known = false;
    for (std::size_t place = 0U; place < samples.size(); place += stride) {
        const double y = value(samples[place], drive.fitted[place]);
        is_known = is_known || std::isfinite(y);
        line.points.push_back({samples[place].time_s, y});
    }
    if (is_known) {
        chart.lines.push_back(line);
    }
}

StudyChart chart_over_time(const std::string& name, const char* heading, const char* words, const char* unit,
                           int digits) {
    StudyChart chart;
    chart.name = name;
    chart.heading = heading;
    chart.x = {"time", "s", 2, {}, {}};
    chart.y = {words, unit, digits, {}, {}};
    chart.marks_y = {0.0};
    return chart;
}

void add_drive(StudyPage& page, const FittedDrive& drive, std::size_t number) {
    using Sample = const RollSample&;
    using Fitted = const FittedSample&;
    page.section(fmt::format("{}: {}", drive.dynamic ? "Dynamic drive" : "Ramp", drive.drive->name));
    const auto name = [number](const char* what) { return fmt::format("{}_{}", what, number); };
    const auto show = [&page](const StudyChart& chart) {
        if (!chart.lines.empty()) {
            page.chart(chart);
        }
    };
    StudyChart roll = chart_over_time(name("roll"), "Roll angle", "roll angle", "deg", 3);
    roll.note =
        "Predicted: by the fitted model alone, from the measured lateral force and the first angle and rate.";
    add_line(roll, drive, measured_line("measured"),
             [](Sample sample, Fitted) { return sample.roll_angle_rad * degrees_per_radian; });
    add_line(roll, drive, predicted_line("predicted"),
             [](Sample, Fitted fitted) { return fitted.predicted_roll_angle_rad * degrees_per_radian; });
    show(roll);
    StudyChart load =
        chart_over_time(name("load"), "Load transfer", "half track times (right - left)", "kN m", 3);
    add_line(load, drive, measured_line("of the wheels"),
             [](Sample sample, Fitted) { return 0.001 * sample.load_moment_nm; });
    if (drive.drive->has_wheel_loads) {
        add_line(load, drive, predicted_line("as the component has it"),
                 [](Sample, Fitted fitted) { return 0.001 * fitted.fitted_load_moment_nm; });
    }
    show(load);
    StudyChart response = chart_over_time(name("response"), "Lateral response", "acceleration", "m/s^2", 3);
    add_line(response, drive, measured_line("A, measured"),
             [](Sample sample, Fitted) { return sample.parallel_mps2; });
    add_line(response, drive, plain_line("asked for by the steering", "--quiet", 1.5),
             [](Sample, Fitted fitted) { return fitted.steering_acceleration_mps2; });
    add_line(response, drive, predicted_line("response to it, as fitted"),
             [](Sample, Fitted fitted) { return fitted.response_mps2; });
    if (response.lines.size() > 1U) {
        show(response);
    }
    StudyChart moment = chart_over_time(name("moment"), "Roll moment", "moment", "kN m", 3);
    add_line(moment, drive, measured_line("m_s H f, measured"),
             [](Sample, Fitted fitted) { return 0.001 * fitted.moment_nm; });
    add_line(moment, drive, predicted_line("M + c p + Ixx p', fitted"),
             [](Sample, Fitted fitted) { return 0.001 * fitted.fitted_moment_nm; });
    add_line(moment, drive, plain_line("residual", "--purple", 1.2),
             [](Sample, Fitted fitted) { return 0.001 * (fitted.moment_nm - fitted.fitted_moment_nm); });
    show(moment);
}

StudyChart chart_of_stiffness(const Identification& result, const std::vector<FittedDrive>& drives) {
    StudyChart chart;
    chart.name = "stiffness";
    chart.heading = "Roll stiffness";
    chart.x = {"roll angle", "deg", 2, {}, {}};
    chart.y = {"moment", "kN m", 3, {}, {}};
    chart.marks_y = {0.0};
    StudyLine cloud;
    cloud.words = "ramps, without what moving adds";
    cloud.colour = "--sky";
    cloud.style = StudyLine::Style::cloud;
    StudyLine curve;
    curve.words = "fitted";
    curve.colour = "--vermilion";
    StudyLine linear;
    linear.words = "its linear part";
    linear.colour = "--quiet";
    linear.dash = {6, 3};
    linear.width = 1.2;
    for (const FittedDrive& drive : drives) {
        const std::size_t stride = chart_stride(drive.fitted.size());
        for (std::size_t place = 0U; place < drive.fitted.size() && !drive.dynamic; place += stride) {
            cloud.points.push_back({drive.drive->samples[place].roll_angle_rad * degrees_per_radian,
                                    0.001 * drive.fitted[place].static_moment_nm});
        }
    }
    for (const StiffnessPoint& point : stiffness_curve(result)) {
        curve.points.push_back({point.roll_angle_rad * degrees_per_radian, 0.001 * point.moment_nm});
        linear.points.push_back({point.roll_angle_rad * degrees_per_radian, 0.001 * point.linear_moment_nm});
    }
    chart.lines = {cloud, curve, linear};
    if (result.roll.needed_up_to_rad > result.roll.data_end_rad) {
        const double end_deg = result.roll.data_end_rad * degrees_per_radian;
        chart.marks_x = {-end_deg, end_deg};
        chart.note =
            fmt::format("The drives reach {:.2f} deg; beyond it, up to {:.2f} deg, the curve is a guess.",
                        end_deg, result.roll.needed_up_to_rad * degrees_per_radian);
    }
    return chart;
}

}  // namespace

std::string identification_page(const Identification& result) {
    const std::vector<FittedDrive> drives = fitted_drives(result);
    StudyPage page{"Identification: " + result.vehicle.name,
                   fmt::format("ramps: {}, dynamic drives: {}", result.ramps.size(), result.dynamics.size())};
    page.section("What to know about it");
    if (result.warnings.empty()) {
        page.text("Nothing to warn of.");
    } else {
        page.list(result.warnings);
    }
    page.section("Values");
    page.table(table_of_values(result));
    page.section("Fit");
    page.chart(chart_of_stiffness(result, drives));
    page.table(table_of_drives(result, drives));
    for (std::size_t number = 0U; number < drives.size(); ++number) {
        add_drive(page, drives[number], number + 1U);
    }
    return page.html();
}

}  // namespace sil
