// Index score: up to which threshold an index would have warned of a run, by the rules of the firmware's own
// warning.
#pragma once

#include <optional>
#include <vector>

#include "rsi/types.hpp"
#include "rsi/warning/warning_state_machine.hpp"
#include "sil/judge/two_wheel_lift.hpp"

namespace sil {

// Output of an index over a run, cycle by cycle: its level, 1 where it says "warn", and its side.
struct IndexCourse {
    std::vector<double> times_s{};
    std::vector<rsi::RiskLevel> risks{};
};

// The state machine behind one index: a copy of the firmware's, which warns by the index with the levels and
// times of the calibration; at `threshold`, above 0, it warns where the firmware's would at warning_on.
class IndexWarning {
 public:
    IndexWarning(const rsi::Parameters& calibration, double threshold);

    // In every cycle. A level without a number is no statement.
    void update(const rsi::RiskLevel& risk);

    WarningState state() const { return static_cast<WarningState>(machine_.state()); }
    WarningSide side() const { return static_cast<WarningSide>(machine_.side()); }

 private:
    rsi::WarningStateMachine machine_{};
    float scale_;
    rsi::WarningStateMachine::Constants constants_;  // advisory_on is at most warning_on, as validated
};

// Thresholds are powers of 1.01, so 1 is one of them; 0: at none of them.
struct IndexScore {
    // The largest threshold at which the index warns. For a run with two-wheel lift-off: as it happens, the
    // warning in force names the falling side, for at least so long. For any other: there is an alarm; then
    // all three are the same.
    double threshold{0.0};
    double threshold_100ms{0.0};
    double threshold_200ms{0.0};
    std::optional<double> lead_s{};  // with the threshold at 1
};

inline constexpr double smallest_threshold = 0.2;
inline constexpr double largest_threshold = 5.0;

// By an IndexWarning at each threshold in turn. A smaller threshold is taken to warn of whatever a larger one
// warns of.
IndexScore score_of(const IndexCourse& course, const rsi::Parameters& calibration,
                    const std::optional<TwoWheelLiftOff>& lift_off);

// Whether that warning raises an alarm.
bool index_alarms(const IndexCourse& course, const rsi::Parameters& calibration, double threshold);

// The largest threshold at which it raises an alarm, to 1e-9 of the highest level; 0 when there is none.
double alarm_threshold(const IndexCourse& course, const rsi::Parameters& calibration);

// The largest threshold with alarms in at least this share of the runs, of which alarm_threshold() is given;
// infinite for a share of 0 and without runs. At a threshold of 0 an index would warn always: the least is
// 1e-9.
double matched_threshold(std::vector<double> alarm_thresholds, double share);

// The risk of falling to either side.
rsi::RiskLevel risk_of(float right, float left);

// The lead of that warning over two-wheel lift-off; empty unless it is in force with the falling side.
std::optional<double> index_lead_s(const IndexCourse& course, const rsi::Parameters& calibration,
                                   double threshold, const TwoWheelLiftOff& lift_off);

}  // namespace sil
