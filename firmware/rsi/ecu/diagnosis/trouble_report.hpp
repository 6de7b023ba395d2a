// Trouble report: ReadDTCInformation (service 19).
#pragma once

#include "rsi/ecu/diagnosis/message.hpp"
#include "rsi/ecu/diagnosis/trouble_memory.hpp"
#include "rsi/ecu/diagnosis/uds.hpp"

namespace rsi::diagnosis {

// Record numbers of a code's snapshots and of its extended data; 0xFF asks for all.
inline constexpr std::uint8_t first_snapshot = 0x01U;
inline constexpr std::uint8_t last_snapshot = 0x02U;
inline constexpr std::uint8_t occurrences_record = 0x01U;
inline constexpr std::uint8_t ageing_record = 0x02U;
inline constexpr std::uint8_t all_records = 0xFFU;

// A snapshot has one data identifier: what was measured (FreezeFrame), each number with its most significant
// byte first.
inline constexpr std::uint32_t freeze_frame_identifier = 0x0200U;

// `sub_function` without its suppress bit, listed in sub_functions, the request as long as there.
Nrc report_codes(std::uint8_t sub_function, const Request& request, const TroubleMemory& memory,
                 Response& response) noexcept;

}  // namespace rsi::diagnosis
