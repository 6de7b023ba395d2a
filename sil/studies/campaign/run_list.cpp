#include "sil/studies/campaign/run_list.hpp"

#include <algorithm>
#include <cstring>
#include <string>
#include <unordered_map>
#include <utility>

namespace sil {
namespace {

// Runs of each kind by the threshold up to which they are warned of. Indices know some hundred thresholds,
// however many runs there are.
class ThresholdCounts {
 public:
    enum Kind : std::size_t { calm, lifted, lifted_100ms, lifted_200ms, first_band };
    static constexpr std::size_t kinds = first_band + band_count;
    using Counts = std::array<std::size_t, kinds>;

    void add(double threshold, std::size_t kind) {
        std::uint64_t bits = 0U;  // by which a number is found more quickly than by itself
        std::memcpy(&bits, &threshold, sizeof bits);
        auto& [of, counts] = counts_[bits];
        of = threshold;
        ++counts[kind];
    }

    // From the highest threshold downwards, each with those of all above.
    std::vector<std::pair<double, Counts>> reached() const {
        std::vector<std::pair<double, Counts>> all;
        for (const auto& [bits, counted] : counts_) {
            all.push_back(counted);
        }
        std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
        for (std::size_t i = 1U; i < all.size(); ++i) {
            for (std::size_t kind = 0U; kind < kinds; ++kind) {
                all[i].second[kind] += all[i - 1U].second[kind];
            }
        }
        return all;
    }

 private:
    std::unordered_map<std::uint64_t, std::pair<double, Counts>> counts_{};
};

}  // namespace

bool is_lifted(const RecordedCampaignRun& run) {
    return run.two_wheel_lift_time_s.has_value();
}

bool is_calm(const RecordedCampaignRun& run) {
    return is_calm(is_lifted(run), load_band(run.largest_ltr));
}

RunList::RunList(const std::vector<const RecordedCampaignRun*>& runs) {
    std::unordered_map<const std::string*, std::uint32_t> numbers;
    for (const RecordedCampaignRun* run : runs) {
        numbers.emplace(&run->vehicle.text(), 0U);
    }
    std::vector<const std::string*> names;
    for (const auto& [name, number] : numbers) {
        names.push_back(name);
    }
    std::sort(names.begin(), names.end(), [](const auto* one, const auto* other) { return *one < *other; });
    for (const std::string* name : names) {
        numbers[name] = static_cast<std::uint32_t>(vehicles_++);
    }
    entries_.reserve(runs.size());
    for (const RecordedCampaignRun* run : runs) {
        entries_.push_back(
            {run, {numbers[&run->vehicle.text()], is_lifted(*run), load_band(run->largest_ltr)}});
    }
}

Detection detection_of_warning(const RunList& runs) {
    DetectionCounts counts;
    for (const RunList::Entry& entry : runs.entries()) {
        counts.add(entry.kind, entry.run->lead_s, entry.run->warnings > 0U);
    }
    return counts.detection();
}

IndexOverRuns::IndexOverRuns(const RunList& runs, std::size_t index) : runs_{runs} {
    recorded_.reserve(runs.entries().size());
    for (const RunList::Entry& entry : runs.entries()) {
        recorded_.push_back(entry.run->indices[index]);
    }
}

Detection IndexOverRuns::at_one() const {
    DetectionCounts counts;
    for (std::size_t place = 0U; place < recorded_.size(); ++place) {
        counts.add(runs_.entries()[place].kind, recorded_[place].lead_s, recorded_[place].threshold >= 1.0);
    }
    return counts.detection();
}

Detection IndexOverRuns::at(double threshold) const {
    DetectionCounts counts;
    for (std::size_t place = 0U; place < recorded_.size(); ++place) {
        const IndexScore& recorded = recorded_[place];
        counts.add(runs_.entries()[place].kind,
                   WarningInRun{recorded.threshold >= threshold, recorded.threshold_100ms >= threshold,
                                recorded.threshold_200ms >= threshold, recorded.threshold >= threshold});
    }
    return counts.detection();
}

std::vector<CurvePoint> IndexOverRuns::curve() const {
    ThresholdCounts counts;
    ThresholdCounts::Counts totals{};
    const auto add = [&](double threshold, std::size_t kind) {
        counts.add(threshold, kind);
        ++totals[kind];
    };
    for (std::size_t place = 0U; place < recorded_.size(); ++place) {
        const RunKind& run = runs_.entries()[place].kind;
        const IndexScore& recorded = recorded_[place];
        if (run.lifted) {
            add(recorded.threshold, ThresholdCounts::lifted);
            add(recorded.threshold_100ms, ThresholdCounts::lifted_100ms);
            add(recorded.threshold_200ms, ThresholdCounts::lifted_200ms);
            continue;
        }
        add(recorded.threshold, ThresholdCounts::first_band + static_cast<std::size_t>(run.band));
        if (is_calm(run.lifted, run.band)) {
            add(recorded.threshold, ThresholdCounts::calm);
        }
    }
    std::vector<CurvePoint> curve;
    for (const auto& each : counts.reached()) {
        const double threshold = each.first;
        const ThresholdCounts::Counts& reached = each.second;
        // 0 is no threshold: the run is warned of at none.
        if (threshold <= 0.0) {
            break;
        }
        const auto share = [&reached, &totals](std::size_t kind) {
            return Share{reached[kind], totals[kind]};
        };
        CurvePoint point;
        point.threshold = threshold;
        point.false_alarms = share(ThresholdCounts::calm);
        for (std::size_t band = 0U; band < band_count; ++band) {
            point.alarms[band] = share(ThresholdCounts::first_band + band);
        }
        point.warned = share(ThresholdCounts::lifted);
        point.warned_100ms = share(ThresholdCounts::lifted_100ms);
        point.warned_200ms = share(ThresholdCounts::lifted_200ms);
        curve.push_back(point);
    }
    return curve;
}

std::optional<CurvePoint> best_at(const std::vector<CurvePoint>& curve, double limit) {
    std::optional<CurvePoint> best;
    for (const CurvePoint& point : curve) {
        // Lower thresholds only warn of more; of equals the highest is kept. Without calm runs the share of
        // false alarms is no number, which no limit allows.
        const bool allowed = point.warned.total > 0U && point.false_alarms.value() <= limit;
        const bool better = !best || point.warned.count > best->warned.count ||
                            point.warned_100ms.count > best->warned_100ms.count ||
                            point.warned_200ms.count > best->warned_200ms.count;
        if (allowed && better) {
            best = point;
        }
    }
    return best;
}

}  // namespace sil
