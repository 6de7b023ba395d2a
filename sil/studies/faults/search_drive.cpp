#include "sil/studies/faults/search_drive.hpp"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "sil/random.hpp"
#include "sil/simulation/pace.hpp"
#include "sil/world/manoeuvres/everyday_turns.hpp"

namespace sil {
namespace {

constexpr double share_at_rest = 0.06;
constexpr double share_at_a_crawl = 0.12;
constexpr double share_after_straight = 0.45;
constexpr double share_after_turns = 0.25;
constexpr double share_reset = 0.25;
constexpr double latest_reset = 0.6;  // as a share of the drive

constexpr double rest_s = 4.0;
constexpr double crawl_s = 8.0;
constexpr double longest_manoeuvre_s = 10.0;

Manoeuvre manoeuvre_of(const DrawnRun& drawn, RandomStream& chance) {
    Manoeuvre manoeuvre = drawn.manoeuvre;
    const double own_s = drawn.options.duration_s > 0.0 ? drawn.options.duration_s : manoeuvre.duration_s;
    manoeuvre.duration_s = std::min(own_s, longest_manoeuvre_s);
    const double lead_in = chance.between(0.0, 1.0);
    const double straight_s = chance.between(0.5, 4.0);
    if (lead_in < share_after_straight) {
        return with_lead_in(manoeuvre, straight_s);
    }
    if (lead_in < share_after_straight + share_after_turns) {
        const Manoeuvre turns = gentle_turns(gentle_turn_s);
        return with_lead_in(with_lead_in(manoeuvre, straight_s), gentle_turn_s, &turns);
    }
    return manoeuvre;
}

std::pair<std::string, RecordedDrive> record(const DrawnRun& drawn, RandomStream& chance) {
    SensorOptions sensors = drawn.sensors;
    sensors.roll.reports_bank = true;
    const double state = chance.between(0.0, 1.0);
    if (state < share_at_rest) {
        return {"rest", record_rest(drawn.vehicle, rest_s, {sensors}).front()};
    }
    if (state < share_at_rest + share_at_a_crawl) {
        RunOptions options;
        options.mirrored = drawn.options.mirrored;
        options.speed_factor = chance.between(0.5, 1.5);
        options.steering_factor = chance.between(0.2, 1.5);
        const Manoeuvre slow = slow_turns(crawl_s);
        return {slow.name, record_drive(drawn.vehicle, slow, options, {sensors}).front()};
    }
    RunOptions options = drawn.options;
    options.duration_s = 0.0;
    return {drawn.manoeuvre.name,
            record_drive(drawn.vehicle, manoeuvre_of(drawn, chance), options, {sensors}).front()};
}

// From that cycle on, to two-wheel lift-off if there is one.
FaultedDrive drive_from(const RecordedDrive& recorded, std::size_t begin) {
    const std::size_t size = recorded.samples.size();
    const std::size_t end = recorded.two_wheel_lift ? std::min(size, *recorded.two_wheel_lift + 1U) : size;
    FaultedDrive drive;
    static_cast<RecordedDrive&>(drive) = part_of(recorded, begin, end);
    drive.fault_end = drive.samples.size();
    return drive;
}

std::optional<std::size_t> first_warning_of(const FaultyRun& run) {
    const auto warns = [](const std::optional<EcuAnswer>& answer) {
        return answer->state == WarningState::warning;
    };
    const auto found = std::find_if(run.answers.begin(), run.answers.end(), warns);
    return found == run.answers.end()
               ? std::nullopt
               : std::optional<std::size_t>{static_cast<std::size_t>(found - run.answers.begin())};
}

}  // namespace

SearchDrive record_search_drive(const CampaignWorld& world, std::uint64_t number) {
    const DrawnRun drawn = world.prepare(number);
    RandomStream chance{scrambled(scrambled(world.settings().seed) ^ number)};
    const auto [name, recorded] = record(drawn, chance);
    const std::size_t last = recorded.two_wheel_lift.value_or(recorded.samples.size());
    const bool reset = chance.between(0.0, 1.0) < share_reset;
    const auto begin =
        static_cast<std::size_t>(reset ? chance.between(0.0, latest_reset) * static_cast<double>(last) : 0.0);
    const FaultedDrive drive = drive_from(recorded, begin);
    RightRuns right{drive, drawn.calibration};
    const std::optional<std::size_t> due = first_warning_of(right.of(Fault{}));
    const std::string& file = world.settings().vehicles[drawn.draw.vehicle].parameters;
    return {std::filesystem::path{file}.stem().string(),
            name,
            static_cast<double>(begin) * cycle_time_s,
            drawn.calibration,
            drive,
            std::move(right),
            due};
}

}  // namespace sil
