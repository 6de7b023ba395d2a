#include "sil/studies/faults/fault_schedule.hpp"

#include <algorithm>

namespace sil {
namespace {

constexpr double share_with_two = 0.25;
constexpr double share_drawn_to_warnings = 0.8;
constexpr std::uint64_t lead_in_cycles = 10U;  // from the move to the fault's beginning

std::uint64_t cycles_in(double seconds) {
    return static_cast<std::uint64_t>(seconds * 100.0);
}

// A second fault must leave the first one as it is.
bool can_be_second(const Fault& second, const Fault& first) {
    return second.place != first.place && second.place <= FaultPlace::vehicle_motion_frame &&
           second.kind != FaultKind::swapped;
}

}  // namespace

Fault FaultSchedule::any_fault() {
    const std::vector<Fault>& all = all_faults();
    const std::vector<Fault> signs = in_each_sign(all[chance_.below(all.size())]);
    return signs[chance_.below(signs.size())];
}

void FaultSchedule::draw(std::uint64_t from) {
    faults_[0].fault = any_fault();
    faults_[1].fault = {};
    if (chance_.between(0.0, 1.0) < share_with_two) {
        do {
            faults_[1].fault = any_fault();
        } while (!can_be_second(faults_[1].fault, faults_[0].fault));
    }
    drawn_to_warning_ = false;
    place(from + cycles_in(chance_.between(1.0, 20.0)));
}

void FaultSchedule::place(std::uint64_t begin) {
    faults_[0].begin = begin;
    faults_[0].end = begin + cycles_in(chance_.between(0.05, 5.0));
    over_ = faults_[0].end;
    const Fault& fault = faults_[0].fault;
    if (fault.kind == FaultKind::process_stop) {
        over_ = std::max(over_, begin + static_cast<std::uint64_t>(fault.magnitude) / 10U + 1U);
    }
    faults_[1].begin = begin + cycles_in(chance_.between(0.0, 2.0));
    faults_[1].end = faults_[1].begin + cycles_in(chance_.between(0.05, 5.0));
    if (has_two()) {
        over_ = std::max(over_, faults_[1].end);
    }
}

bool FaultSchedule::draw_towards(std::uint64_t due, std::uint64_t now) {
    const bool has_begun = now + lead_in_cycles >= begin();
    if (has_begun || drawn_to_warning_ || chance_.between(0.0, 1.0) >= share_drawn_to_warnings) {
        return false;
    }
    drawn_to_warning_ = true;
    const std::uint64_t before = cycles_in(chance_.between(0.0, 3.0));
    place(std::max(now + lead_in_cycles, due - std::min(before, due)));
    return true;
}

}  // namespace sil
