#include "rsi/ecu/diagnosis/trouble_memory.hpp"

namespace rsi::diagnosis {
namespace {

using monitoring::CodeSet;

constexpr std::uint32_t cycles_per_second = 100U;
constexpr std::uint8_t most_occurrences = 255U;

constexpr CodeSet bit_of(std::size_t row) {
    return CodeSet{2U} << row;  // the codes count from 1
}

constexpr std::uint8_t code_of(std::size_t row) {
    return static_cast<std::uint8_t>(row + 1U);
}

std::uint8_t count_up(std::uint8_t count) {
    return static_cast<std::uint8_t>(count + ((count < most_occurrences) ? 1U : 0U));
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
std::uint32_t in_steps(float value, float steps_per_unit) {
    constexpr std::uint32_t not_available = 0x8000U;
    constexpr float most = 32767.0F;
    const float steps = value * steps_per_unit;
    const bool is_number = (steps >= 0.0F) || (steps < 0.0F);
    if (!is_number) {
        return not_available;
    }
    const float rounded = steps + ((steps < 0.0F) ? -0.5F : 0.5F);
    const float below = (rounded > most) ? most : rounded;
    const float bounded = (below < -most) ? -most : below;
    return static_cast<std::uint32_t>(static_cast<std::int32_t>(bounded)) & 0xFFFFU;
}

void put(FreezeFrame& frame, std::size_t place, std::uint32_t value) {
    frame[place] = static_cast<std::uint8_t>(value >> 8U);
    frame[place + 1U] = static_cast<std::uint8_t>(value & 0xFFU);
}

FreezeFrame frame_of(const monitoring::Snapshot& measured, std::uint32_t cycles) {
    constexpr std::uint32_t later = 65535U;
    const std::uint32_t seconds = cycles / cycles_per_second;
    FreezeFrame frame{};
    put(frame, 0U, in_steps(measured.lateral_acceleration_mps2, 100.0F));
    put(frame, 2U, in_steps(measured.roll_rate_radps, 1000.0F));
    put(frame, 4U, in_steps(measured.roll_angle_rad, 1000.0F));
    put(frame, 6U, in_steps(measured.speed_mps, 100.0F));
    put(frame, 8U, (seconds < later) ? seconds : later);
    return frame;
}

}  // namespace

void TroubleMemory::start(bool is_new_cycle) noexcept {
    untested_ = 0U;
    for (std::size_t row = 0U; row < trouble_code_count; ++row) {
        if (is_new_cycle) {
            count_cycle(data_.states[row], row);
        }
        clear_bits(data_.states[row].status, status::test_failed);
        untested_ |= has(data_.states[row].status, status::cleared) ? bit_of(row) : CodeSet{0U};
    }
    begin_tests(untested_);
    if (is_new_cycle) {
        data_.states[resets_at].occurrences = 0U;
        count_operation_cycle();
    }
    failed_ = 0U;
    cleared_ = 0U;
    cycles_ = 0U;
    request_storing(is_new_cycle ? Storing::now : Storing::not_needed);
}

// The carry goes from the last byte to the first.
void TroubleMemory::count_operation_cycle() noexcept {
    bool carries = true;
    for (std::size_t place = data_.operation_cycles.size(); place > 0U; --place) {
        std::uint8_t& byte = data_.operation_cycles[place - 1U];
        byte = static_cast<std::uint8_t>(byte + (carries ? 1U : 0U));
        carries = carries && (byte == 0U);
    }
}

// Closes the previous operation cycle at start-up; its end cannot be observed.
void TroubleMemory::count_cycle(TroubleState& state, std::size_t row) noexcept {
    constexpr std::uint8_t not_good = 0x42U;  // not completed in it, or failed
    const bool was_good = !has(state.status, not_good);
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

void TroubleMemory::take_change(CodeSet failed, const monitoring::Snapshot& measured,
                                std::uint32_t checksum) noexcept {
    const CodeSet changed = failed ^ failed_;
    failed_ = failed;
    measured_ = frame_of(measured, cycles_);
    for (std::size_t index = 0U; index < 4U; ++index) {
        measured_[10U + index] = data_.operation_cycles[index];
        measured_[14U + index] = static_cast<std::uint8_t>((checksum >> (24U - 8U * index)) & 0xFFU);
    }
    for (std::size_t row = 0U; row < trouble_code_count; ++row) {
        const CodeSet bit = bit_of(row);
        if ((changed & failed & bit) != 0U) {
            fail(row);
        } else if ((changed & bit) != 0U) {
            clear_bits(data_.states[row].status, status::test_failed);
        } else {
            // as it was
        }
    }
}

void TroubleMemory::fail(std::size_t row) noexcept {
    TroubleState& state = data_.states[row];
    // Repeated failures in one operation cycle do not wear the memory out, and beyond the largest count they
    // change nothing that it would have to keep.
    if (!has(state.status, status::failed_this_cycle)) {
        request_storing(Storing::now);
    } else if (state.occurrences < most_occurrences) {
        request_storing(Storing::later);
    } else {
        // it stands
    }
    set_bits(state.status, status::failure);
    clear_bits(state.status, status::cleared);
    untested_ &= ~bit_of(row);
    state.occurrences = count_up(state.occurrences);
    state.ageing = 0U;
    keep_snapshot(row);
}

// Adds one to the number of each code at once, as a ripple-carry adder does.
void TroubleMemory::count_tests(const Findings& found) noexcept {
    const CodeSet interrupted = found.active & ~active_ & untested_;  // its good tests are not in a row
    active_ = found.active;
    if (interrupted != 0U) {
        begin_tests(interrupted);
    }
    CodeSet carry = found.tested & ~found.active & untested_;
    for (CodeSet& bits : good_tests_) {
        const CodeSet next = bits & carry;
        bits ^= carry;
        carry = next;
    }
    if (carry != 0U) {
        complete(carry);
    }
}

void TroubleMemory::begin_tests(CodeSet codes) noexcept {
    CodeSet left = codes >> 1U;  // from the first row on
    for (std::size_t row = 0U; row < trouble_code_count; ++row) {
        if ((left & 1U) != 0U) {
            begin_test(row);
        }
        left >>= 1U;
    }
}

void TroubleMemory::begin_test(std::size_t row) noexcept {
    const CodeSet bit = bit_of(row);
    // As many of its lowest bits are taken as the numbers have: they overflow after `heal` good tests.
    std::uint32_t number =
        0U - monitoring::debounce_of(static_cast<monitoring::DiagnosticCode>(code_of(row))).heal;
    for (CodeSet& bits : good_tests_) {
        bits = (bits & ~bit) | (((number & 1U) != 0U) ? bit : CodeSet{0U});
        number >>= 1U;
    }
}

void TroubleMemory::complete(CodeSet codes) noexcept {
    untested_ &= ~codes;
    CodeSet left = codes >> 1U;
    for (std::size_t row = 0U; row < trouble_code_count; ++row) {
        if ((left & 1U) != 0U) {
            clear_bits(data_.states[row].status, status::cleared);
        }
        left >>= 1U;
    }
    request_storing(Storing::later);
}

void TroubleMemory::clear_all() noexcept {
    for (std::size_t row = 0U; row < trouble_code_count; ++row) {
        clear(row);
    }
}

// A code that still fails, fails anew in the next cycle.
void TroubleMemory::clear(std::size_t row) noexcept {
    data_.states[row] = TroubleState{};
    forget_snapshots(row);
    failed_ &= ~bit_of(row);
    cleared_ |= bit_of(row);
    untested_ |= bit_of(row);
    begin_test(row);
    request_storing(Storing::now);
}

const TroubleSnapshots* TroubleMemory::snapshots(std::size_t row) const noexcept {
    for (const TroubleSnapshots& each : data_.snapshots) {
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
    TroubleSnapshots* unused = nullptr;
    TroubleSnapshots* displaced = nullptr;
    for (TroubleSnapshots& each : data_.snapshots) {
        if (each.code == code_of(row)) {
            return &each;
        }
        if (each.code == 0U) {
            unused = &each;
        } else if ((failed_ & (CodeSet{1U} << each.code)) == 0U) {
            displaced = &each;
        } else {
            // it is needed
        }
    }
    return (unused != nullptr) ? unused : displaced;
}

void TroubleMemory::forget_snapshots(std::size_t row) noexcept {
    for (TroubleSnapshots& each : data_.snapshots) {
        if (each.code == code_of(row)) {
            each = TroubleSnapshots{};
        }
    }
}

void TroubleMemory::restore(const Stored& stored) noexcept {
    data_ = stored;
    for (TroubleState& each : data_.states) {
        each.status = static_cast<std::uint8_t>(each.status & status::available);
    }
    for (TroubleSnapshots& each : data_.snapshots) {
        each = (each.code <= trouble_code_count) ? each : TroubleSnapshots{};
    }
}

}  // namespace rsi::diagnosis
