// Warning judgement: whether a warning was right, on the right side and in time. Every warning, in a run, a
// replayed drive or a campaign, is judged here.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "sil/judge/two_wheel_lift.hpp"
#include "sil/judge/warning.hpp"

namespace sil {

// How early a warning is wanted: in force when the wheels lift, and so much before.
inline constexpr double early_s = 0.1;
inline constexpr double very_early_s = 0.2;

// Whether a lead over two-wheel lift-off is at least the wanted one; without a lead it is not.
bool is_warned(const std::optional<double>& lead_s, double wanted_s = 0.0);

// How near a run without two-wheel lift-off came to it, by its largest |LTR|.
enum class LoadBand : std::uint8_t { below_0_7, from_0_7, from_0_8, from_0_9 };
inline constexpr LoadBand load_bands[] = {LoadBand::below_0_7, LoadBand::from_0_7, LoadBand::from_0_8,
                                          LoadBand::from_0_9};
LoadBand load_band(double largest_load_transfer_ratio);
// "below 0.7", "0.7 to 0.8", "0.8 to 0.9", "0.9 to lift".
const char* to_string(LoadBand band);

// A warning while it names one side.
struct NamedWarning {
    double begin_s{0.0};
    double end_s{0.0};  // of its last frame
    WarningSide side{WarningSide::none};
};

// The warnings of a drive in their order. One that changes its side is one of each side; a break in the side
// alone is none.
class NamedWarnings {
 public:
    // At every warning frame.
    void observe(WarningState state, WarningSide side, double time_s);

    const std::vector<NamedWarning>& all() const { return warnings_; }

 private:
    bool in_force_{false};
    std::vector<NamedWarning> warnings_{};
};

// The warning that is in force, and since when with its side.
class WarningInForce {
 public:
    void observe(WarningState state, WarningSide side, double time_s);

    WarningSide side() const { return side_; }  // none: no warning, or one that names no side

    // For how long it has been in force without a break when the wheels lift, if it names the side that
    // falls; else empty. Nothing after that moment must have been observed.
    std::optional<double> lead_s(double lift_off_time_s, WarningSide falling_side) const;

 private:
    WarningSide side_{WarningSide::none};
    double since_s_{0.0};
};

struct WarningJudgement {
    bool lifted{false};                               // two wheels of a side
    WarningSide falling_side{WarningSide::none};      // from then on
    WarningSide side_at_lift_off{WarningSide::none};  // that the warning in force names; none: no warning
    std::optional<double> lead_s{};                   // at two-wheel lift-off; empty unless warned
    bool late{false};                                 // the right warning came only after it

    double wrong_side_s{
        0.0};  // a warning names the side that is loaded less, but for swing_s and foresight_s
    double warning_s{0.0};
    double advisory_s{0.0};
    double unavailable_s{0.0};                // beyond the start-up
    unsigned warnings{0U};                    // how often it began
    unsigned advisories{0U};                  // how often one began that was not left over from a warning
    double largest_load_transfer_ratio{0.0};  // |LTR|

    LoadBand band() const { return load_band(largest_load_transfer_ratio); }
};

class WarningJudge {
 public:
    // Load transfer swings faster than any warning can follow.
    static constexpr double swing_s = 0.1;
    // A warning may name the side to which the load swings within so long: it looks ahead. If the swing does
    // not come, or the warning names another side before, all of it was wrong.
    static constexpr double foresight_s = 0.3;
    // The start-up: until the ECU is ready for the first time, but no longer than this. Its inputs must prove
    // good, and a signal that never comes must be known to be missing before others replace it.
    static constexpr double start_up_s = 0.5;

    // At every step, in the order of time: the load transfer ratio of the true wheel loads, > 0 where the
    // right wheels carry more; NaN where it is not known.
    void observe(double time_s, double load_transfer_ratio);

    // When a warning frame has arrived.
    void observe(WarningState state, WarningSide side, double reception_time_s);

    // When two-wheel lift-off is known, which may be some time after it.
    void lift_off(const TwoWheelLiftOff& lift_off);

    const WarningJudgement& judgement() const { return judgement_; }

 private:
    struct Change {
        double time_s;
        WarningState state;
        WarningSide side;
    };

    void count_time(double step_s, double begin_s);
    void count_warning(double step_s, double begin_s);
    void swing_to(WarningSide side);

    WarningJudgement judgement_{};
    WarningState state_{WarningState::unavailable};
    WarningSide side_{WarningSide::none};
    std::vector<Change> changes_{};
    bool started_{false};  // has been available
    std::optional<double> first_time_s_{};
    double time_s_{0.0};
    WarningSide loaded_side_{WarningSide::none};
    double swung_s_{0.0};
    double wrong_until_now_s_{0.0};  // of wrong_side_s: without a break until now
};

}  // namespace sil
