// Recording: what the host hands to the program on the target. 32-bit words, little-endian as both sides are:
//   magic, number of drives, then each drive: rsi_parameters, number of records, records.
// For the least squares: magic, rsi_parameters, number of records, LeastSquaresRecords.
#pragma once

#include <stdint.h>

#include "rsi/rsi.h"

namespace budgets {

inline constexpr uint32_t recording_magic = 0x42495352U;  // "RSIB"
inline constexpr uint32_t regression_magic = 0x52495352U;

struct Record {
    rsi_inputs inputs;
    uint32_t on_copy;  // 1: steps a copy of the component, which stays where it is: "what if this came next"
};

struct LeastSquaresRecord {
    float output_nm;
    float psi[3];
};

static_assert(sizeof(rsi_parameters) % sizeof(uint32_t) == 0U, "the recording consists of 32-bit words");
static_assert(sizeof(Record) == 10U * sizeof(uint32_t), "the recording consists of 32-bit words");

}  // namespace budgets
