// Fault record: what is kept over a reset, so that the firmware can say why it started.
#pragma once

#include <cstdint>

#include "rsi/hal/reset_reason.hpp"

namespace rsi::hal::zynqmp_r5 {

struct Fault {
    ResetReason reason{ResetReason::power_on};
    // Address of the instruction. For a data abort that came late (data_abort.hpp) one after it, for a start
    // without reset the one before the return address, which is the call unless that was the last one of its
    // function.
    std::uint32_t instruction{0U};
    std::uint32_t data{0U};    // address that it wanted, of a data abort; 0 if the processor does not say
    std::uint32_t status{0U};  // fault status register, of an abort
    std::uint32_t program_status{0U};  // CPSR at the time
};

// Lies in memory that no start clears. Either all of it is valid or none: magic number and check sum.
struct FaultRecord {
    std::uint32_t magic;
    std::uint32_t reason;
    std::uint32_t instruction;
    std::uint32_t data;
    std::uint32_t status;
    std::uint32_t program_status;
    std::uint32_t resets;  // since power-on; stays at its largest value
    std::uint32_t check;
};

inline constexpr std::uint32_t fault_record_magic{0x5253'4946U};  // "RSIF"

namespace detail {

constexpr std::uint32_t check_of(const FaultRecord& record) {
    return ~(record.magic + record.reason + record.instruction + record.data + record.status +
             record.program_status + record.resets);
}

}  // namespace detail

constexpr bool is_valid(const FaultRecord& record) {
    return record.magic == fault_record_magic && record.check == detail::check_of(record) &&
           record.reason <= static_cast<std::uint32_t>(ResetReason::start_without_reset);
}

// At a fault. The count of resets goes on when the record was valid.
constexpr void record_fault(const Fault& fault, FaultRecord& record) {
    record.resets = is_valid(record) ? record.resets : 0U;
    record.magic = fault_record_magic;
    record.reason = static_cast<std::uint32_t>(fault.reason);
    record.instruction = fault.instruction;
    record.data = fault.data;
    record.status = fault.status;
    record.program_status = fault.program_status;
    record.check = detail::check_of(record);
}

// At a start, once: why it happened. From now on the record says that the firmware runs; the details of the
// fault stay in it for a debugger.
constexpr ResetReason begin_run(FaultRecord& record) {
    if (!is_valid(record)) {
        record = FaultRecord{};
        record_fault(Fault{ResetReason::outside}, record);
        return ResetReason::power_on;
    }
    const auto reason = static_cast<ResetReason>(record.reason);
    record.reason = static_cast<std::uint32_t>(ResetReason::outside);
    record.resets += record.resets == 0xFFFF'FFFFU ? 0U : 1U;
    record.check = detail::check_of(record);
    return reason;
}

}  // namespace rsi::hal::zynqmp_r5
