// Row: the outcome of a run by the true wheel loads, what a campaign keeps of it, and its line in runs.csv.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sil/judge/index_score.hpp"
#include "sil/judge/two_wheel_lift.hpp"
#include "sil/judge/warning_judgement.hpp"
#include "sil/studies/campaign/draw.hpp"
#include "sil/world/vehicle/truth.hpp"

namespace sil {

struct Outcome {
    std::optional<double> one_wheel_lift_time_s;        // the first time that any wheel carries no load
    std::optional<double> two_wheel_lift_time_s;        // the lasting one (sil/judge/two_wheel_lift.hpp)
    std::optional<double> brief_two_wheel_lift_time_s;  // the first brief one before it
    double largest_ltr{0.0};                            // |LTR| over the whole run
    double largest_ltr_before_lift{0.0};                // |LTR| before any wheel has lifted
    double largest_lateral_acceleration_mps2{0.0};
    double largest_roll_angle_rad{0.0};  // relative to the road
    bool rolled_over{false};             // the roll angle went beyond any way back
    double distance_m{0.0};
    double end_time_s{0.0};
};

class OutcomeObserver {
 public:
    // No vehicle here has its balance point, about atan(SSF), beyond it.
    static constexpr double rolled_over_rad = 1.0;
    // After so long on two wheels it is of no more interest whether the vehicle falls or comes back.
    static constexpr double settled_after_lift_s = 1.0;

    // At every step of the vehicle, in the order of time.
    void observe(const Truth& truth);

    // No more can come that a campaign wants to know: the vehicle has rolled over, or two-wheel lift-off is
    // long past.
    bool settled() const;

    const Outcome& outcome() const { return outcome_; }
    const std::optional<TwoWheelLiftOff>& lift_off() const { return lift_.lift_off(); }

 private:
    Outcome outcome_{};
    TwoWheelLiftObserver lift_{};
};

// The last column of a row.
inline constexpr const char* row_check_name = "row_check";

struct CampaignRow {
    RunDraw draw{};
    std::string vehicle{};   // its file's name without folder and ending
    std::string in_class{};  // as the settings say
    std::string manoeuvre{};
    double speed_kmh{0.0};
    Outcome outcome{};
    std::optional<double> warning_time_s{};  // of the firmware's first warning
    WarningJudgement judgement{};            // of the firmware's warning
    std::uint64_t codes{0U};                 // that the firmware confirmed in it; see code_names
    unsigned interventions{0U};              // how often the settings' intervention began
    double intervention_s{0.0};              // for how long it had an effect
    std::vector<IndexScore> indices{};       // in the order of campaign_indices()
};

struct RowColumn {
    enum class Kind : std::uint8_t { text, count, yes_or_no, number };  // yes_or_no: 1 or 0

    std::string name{};
    Kind kind{Kind::text};
    std::string unit{};  // empty: none
    std::string meaning{};
};

// All columns in their order, also as JSON: an array of objects with name, kind, unit and meaning.
std::vector<RowColumn> row_columns();
std::string row_columns_json();

// Their names, without the end of the line.
std::string row_header();

// The row as a line of the CSV, without its end; the same text for the same row.
std::string row_line(const CampaignRow& row);

}  // namespace sil
