// Fault schedule: when which fault is there in a long drive; by chance, but drawn towards due warnings.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sil/random.hpp"
#include "sil/studies/faults/fault.hpp"

namespace sil {

struct ScheduledFault {
    Fault fault{};
    std::uint64_t begin{0U};
    std::uint64_t end{0U};
    bool is_active(std::uint64_t cycle) const { return cycle >= begin && cycle < end; }
};

// One fault at a time, in one of four cases two that overlap: the second one of a signal or a frame.
class FaultSchedule {
 public:
    explicit FaultSchedule(std::uint64_t seed) : chance_{seed} {}

    void draw(std::uint64_t from);

    // A warning is due in that cycle: in four of five cases what has not begun yet is moved to where it is
    // there then, or has just ended.
    // True when it is moved.
    bool draw_towards(std::uint64_t due, std::uint64_t now);

    const std::array<ScheduledFault, 2U>& faults() const { return faults_; }
    bool has_two() const { return faults_[1].fault.kind != FaultKind::none; }

    std::uint64_t begin() const { return faults_[0].begin; }
    // Times of the faults and their consequences: a stopped process goes on later than the fault's end.
    std::uint64_t over() const { return over_; }
    // At the latest two seconds ago.
    bool is_near(std::uint64_t cycle) const { return cycle >= begin() && cycle < over_ + near_cycles; }

 private:
    static constexpr std::uint64_t near_cycles = 200U;

    Fault any_fault();
    void place(std::uint64_t begin);

    RandomStream chance_;
    std::array<ScheduledFault, 2U> faults_{};
    std::uint64_t over_{0U};
    bool drawn_to_warning_{false};
};

}  // namespace sil
