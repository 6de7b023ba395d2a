#include "rsi/ecu/application/load_keeper.hpp"

#include "rsi/hal/saturating_count.hpp"
#include "rsi/numeric/bounded.hpp"

namespace rsi::application {
namespace {

constexpr std::uint32_t least_cycles_between_stores = 6000U;  // a minute
// Unit of both: load excess, a share of the calibrated m_s H.
constexpr float worth_storing = 0.03F;    // smaller changes would wear the memory out
constexpr float known_deviation = 0.05F;  // standard deviation below which a load is certain enough to store
constexpr float other_offset_mps2 = 0.1F;

}  // namespace

void LoadKeeper::restore(const rsi::Parameters& parameters, rsi::Component& component,
                         monitoring::InputMonitor& monitor, bool doubted) noexcept {
    parameters_check_word_ = check_word_of(parameters);
    cycles_since_store_ = 0U;
    stored_ = Learnt{component.learnt_load(), 0.0F};
    LoadRecord record{};
    Learnt read{};
    const hal::Reading reading =
        (storage_ == nullptr) ? hal::Reading::never_written : storage_->read(record.data(), record.size());
    const bool is_whole = (reading == hal::Reading::stored) && is_load_record(record);
    is_failing_ = !is_whole && (reading != hal::Reading::never_written);
    if (is_whole && read_load_record(record, parameters_check_word_, read)) {
        stored_.load = component.restore_load(read.load, doubted) ? read.load : stored_.load;
    }
    stored_.lateral_offset_mps2 =
        monitor.restore_offset(read.lateral_offset_mps2) ? read.lateral_offset_mps2 : 0.0F;
}

void LoadKeeper::follow(const rsi::Parameters& parameters) noexcept {
    parameters_check_word_ = check_word_of(parameters);
}

// Stores a load that differs from the stored one and is certain enough, an offset that differs, or either in
// place of a record that is lost; a minute or more after the last store and when the memory's pace allows it.
void LoadKeeper::keep(const rsi::LearntLoad& load, float lateral_offset_mps2) noexcept {
    hal::count_up(cycles_since_store_);
    if ((storage_ == nullptr) || (cycles_since_store_ < least_cycles_between_stores)) {
        return;
    }
    pace_.begin_cycle();
    const bool is_other_load = rsi::absolute(load.excess - stored_.load.excess) > worth_storing;
    const bool is_new_load = is_other_load && (load.excess_deviation < known_deviation);
    const bool is_new_offset =
        rsi::absolute(lateral_offset_mps2 - stored_.lateral_offset_mps2) > other_offset_mps2;
    if ((!is_new_load && !is_new_offset && !is_failing_) || !pace_.is_due()) {
        return;
    }
    const Learnt learnt{is_new_load ? load : stored_.load, lateral_offset_mps2};
    const LoadRecord record = write_load_record(learnt, parameters_check_word_);
    const bool is_taken = storage_->write(record.data(), record.size());
    pace_.tried(is_taken);
    is_failing_ = !is_taken && (is_failing_ || pace_.is_failing());
    if (is_taken) {
        stored_ = learnt;
        cycles_since_store_ = 0U;
    }
}

}  // namespace rsi::application
