#include "diagnosis/trouble_memory.hpp"

#include "hal/interface/saturating_count.hpp"

namespace diagnosis {
namespace {

using monitoring::CodeSet;

constexpr std::uint32_t cycles_per_second = 100U;
// Longer than any code that is always judged takes to be confirmed, the time for the sensors to start
// included.
constexpr std::uint32_t cycles_to_judge = 300U;
// The monitoring does not say which of its conditions has been met. After so long at such a speed all that
// ordinary driving can meet have been.
constexpr std::uint32_t driven_cycles_to_judge = 6000U;
constexpr float driving_speed_mps = 10.0F;

constexpr CodeSet judged_always = codes_judged(Judged::always);
constexpr CodeSet judged_driving = codes_judged(Judged::driving);

constexpr CodeSet bit_of(std::size_t row) {
    return CodeSet{2U} << row;  // the codes count from 1
}

constexpr std::uint8_t code_of(std::size_t row) {
    return static_cast<std::uint8_t>(row + 1U);
}

std::uint8_t count_up(std::uint8_t count) {
    return static_cast<std::uint8_t>(count + ((count < 255U) ? 1U : 0U));
}

void set_bits(std::uint8_t& byte, std::uint8_t bits) {
    byte = static_cast<std::uint8_t>(byte | bits);
}

void clear_bits(std::uint8_t& byte, std::uint8_t bits) {
    byte = static_cast<std::uint8_t>(byte & static_cast<std::uint8_t>(~bits));
}

bool has(std::uint8_t byte, std::uint8_t bits) {
    return (byte & bits) != 0U;
}

// NaN compares with nothing.
std::int16_t in_steps(float value, float steps_per_unit) {
    const float steps = value * steps_per_unit;
    const bool is_number = (steps >= 0.0F) || (steps < 0.0F);
    if (!is_number) {
        return FreezeFrame::not_available;
    }
    const float rounded = steps + ((steps < 0.0F) ? -0.5F : 0.5F);
    constexpr float most = 32767.0F;
    const float bounded = (rounded > most) ? most : ((rounded < -most) ? -most : rounded);
    return static_cast<std::int16_t>(bounded);
}

FreezeFrame frame_of(const monitoring::Snapshot& measured, std::uint32_t cycles) {
    const std::uint32_t seconds = cycles / cycles_per_second;
    return FreezeFrame{in_steps(measured.lateral_acceleration_mps2, 100.0F),
                       in_steps(measured.roll_rate_radps, 1000.0F),
                       in_steps(measured.roll_angle_rad, 1000.0F), in_steps(measured.speed_mps, 100.0F),
                       static_cast<std::uint16_t>((seconds < 65535U) ? seconds : 65535U)};
}

std::uint8_t* put_half_word(std::uint8_t* bytes, std::uint32_t value) {
    bytes[0] = static_cast<std::uint8_t>(value & 0xFFU);
    bytes[1] = static_cast<std::uint8_t>((value >> 8U) & 0xFFU);
    return bytes + 2;
}

std::uint8_t* put(std::uint8_t* bytes, const FreezeFrame& frame) {
    bytes = put_half_word(bytes, static_cast<std::uint16_t>(frame.lateral_acceleration));
    bytes = put_half_word(bytes, static_cast<std::uint16_t>(frame.roll_rate));
    bytes = put_half_word(bytes, static_cast<std::uint16_t>(frame.roll_angle));
    bytes = put_half_word(bytes, static_cast<std::uint16_t>(frame.speed));
    return put_half_word(bytes, frame.seconds);
}

std::uint16_t half_word(const std::uint8_t* bytes) {
    return static_cast<std::uint16_t>(bytes[0] | (static_cast<std::uint32_t>(bytes[1]) << 8U));
}

FreezeFrame frame_at(const std::uint8_t* bytes) {
    return FreezeFrame{static_cast<std::int16_t>(half_word(bytes)),
                       static_cast<std::int16_t>(half_word(bytes + 2)),
                       static_cast<std::int16_t>(half_word(bytes + 4)),
                       static_cast<std::int16_t>(half_word(bytes + 6)), half_word(bytes + 8)};
}

}  // namespace

void TroubleMemory::start(bool is_new_cycle) noexcept {
    for (std::size_t row = 0U; row < trouble_code_count; ++row) {
        if (is_new_cycle) {
            count_cycle(states_[row], row);
        }
        clear_bits(states_[row].status, status::test_failed);
    }
    failed_ = 0U;
    cycles_ = 0U;
    good_cycles_ = 0U;
    driven_cycles_ = 0U;
    request_storing(is_new_cycle ? Storing::now : Storing::not_needed);
}

// The end of one operation cycle, of which nobody knows when it ends, at the beginning of the next.
void TroubleMemory::count_cycle(TroubleState& state, std::size_t row) noexcept {
    const bool was_good = !has(state.status, status::not_completed_this_cycle | status::failed_this_cycle);
    if (was_good) {
        clear_bits(state.status, status::pending);
    }
    if (was_good && has(state.status, status::confirmed)) {
        ++state.ageing;
        if (state.ageing >= ageing_cycles) {
            clear_bits(state.status, status::confirmed);
            state.occurrences = 0U;
            state.ageing = 0U;
            forget_snapshots(row);
        }
    }
    clear_bits(state.status, status::failed_this_cycle);
    set_bits(state.status, status::not_completed_this_cycle);
}

void TroubleMemory::update(CodeSet failed, const monitoring::Snapshot& measured, float speed_mps) noexcept {
    hal::count_up(cycles_);
    if (!is_recording_) {
        return;
    }
    const CodeSet changed = failed ^ failed_;
    if (changed != 0U) {
        failed_ = failed;
        measured_ = frame_of(measured, cycles_);
        for (std::size_t row = 0U; row < trouble_code_count; ++row) {
            const CodeSet bit = bit_of(row);
            if ((changed & failed & bit) != 0U) {
                fail(row);
            } else if ((changed & bit) != 0U) {
                clear_bits(states_[row].status, status::test_failed);
            } else {
                // as it was
            }
        }
    }
    if (failed_ == 0U) {
        count_good_cycle(speed_mps);
    }
}

void TroubleMemory::fail(std::size_t row) noexcept {
    TroubleState& state = states_[row];
    // What fails over and over in one operation cycle does not wear the memory out.
    request_storing(has(state.status, status::failed_this_cycle) ? Storing::later : Storing::now);
    set_bits(state.status, status::test_failed | status::failed_this_cycle | status::pending |
                               status::confirmed | status::failed_since_clear);
    clear_bits(state.status, status::cleared);
    state.occurrences = count_up(state.occurrences);
    state.ageing = 0U;
    keep_snapshot(row);
}

// Not while a code fails: what a check needs may be what is missing.
void TroubleMemory::count_good_cycle(float speed_mps) noexcept {
    hal::count_up(good_cycles_);
    if (good_cycles_ == cycles_to_judge) {
        complete(judged_always);
    }
    if (speed_mps > driving_speed_mps) {
        hal::count_up(driven_cycles_);
        if (driven_cycles_ == driven_cycles_to_judge) {
            complete(judged_driving);
        }
    }
}

void TroubleMemory::complete(CodeSet judged) noexcept {
    for (std::size_t row = 0U; row < trouble_code_count; ++row) {
        if ((judged & bit_of(row)) != 0U) {
            clear_bits(states_[row].status, status::cleared);
        }
    }
    request_storing(Storing::now);
}

void TroubleMemory::clear_all() noexcept {
    for (std::size_t row = 0U; row < trouble_code_count; ++row) {
        clear(row);
    }
}

// What still fails, fails anew in the next cycle.
void TroubleMemory::clear(std::size_t row) noexcept {
    states_[row] = TroubleState{};
    forget_snapshots(row);
    failed_ &= ~bit_of(row);
    request_storing(Storing::now);
}

const TroubleSnapshots* TroubleMemory::snapshots(std::size_t row) const noexcept {
    for (const TroubleSnapshots& each : snapshots_) {
        if (each.code == code_of(row)) {
            return &each;
        }
    }
    return nullptr;
}

void TroubleMemory::keep_snapshot(std::size_t row) noexcept {
    TroubleSnapshots* const place = place_for(row);
    if (place == nullptr) {
        return;
    }
    if (place->code != code_of(row)) {
        place->code = code_of(row);
        place->first = measured_;
    }
    place->last = measured_;
}

// The code's own place; else a free one; else that of a code that does not fail now; else none: what failed
// first explains what followed.
TroubleSnapshots* TroubleMemory::place_for(std::size_t row) noexcept {
    TroubleSnapshots* free = nullptr;
    TroubleSnapshots* displaced = nullptr;
    for (TroubleSnapshots& each : snapshots_) {
        if (each.code == code_of(row)) {
            return &each;
        }
        if (each.code == 0U) {
            free = &each;
        } else if ((failed_ & (CodeSet{1U} << each.code)) == 0U) {
            displaced = &each;
        } else {
            // it is needed
        }
    }
    return (free != nullptr) ? free : displaced;
}

void TroubleMemory::forget_snapshots(std::size_t row) noexcept {
    for (TroubleSnapshots& each : snapshots_) {
        if (each.code == code_of(row)) {
            each = TroubleSnapshots{};
        }
    }
}

void TroubleMemory::write(std::uint8_t* bytes) const noexcept {
    for (const TroubleState& each : states_) {
        bytes[0] = each.status;
        bytes[1] = each.occurrences;
        bytes[2] = each.ageing;
        bytes += state_bytes;
    }
    for (const TroubleSnapshots& each : snapshots_) {
        *bytes = each.code;
        bytes = put(put(bytes + 1, each.first), each.last);
    }
}

// The record's check word has been good; a code that nobody knows is none all the same.
void TroubleMemory::restore(const std::uint8_t* bytes) noexcept {
    for (TroubleState& each : states_) {
        each = TroubleState{static_cast<std::uint8_t>(bytes[0] & status::available), bytes[1], bytes[2]};
        bytes += state_bytes;
    }
    for (TroubleSnapshots& each : snapshots_) {
        const bool is_known = (bytes[0] <= trouble_code_count);
        each = is_known ? TroubleSnapshots{bytes[0], frame_at(bytes + 1), frame_at(bytes + 11)}
                        : TroubleSnapshots{};
        bytes += snapshot_bytes;
    }
}

}  // namespace diagnosis
