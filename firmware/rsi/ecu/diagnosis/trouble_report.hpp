// Trouble report: ReadDTCInformation (service 0x19).
#pragma once

#include "rsi/ecu/diagnosis/message.hpp"
#include "rsi/ecu/diagnosis/trouble_memory.hpp"
#include "rsi/ecu/diagnosis/uds.hpp"

namespace rsi::diagnosis {

// Record numbers of a DTC's snapshots (first and last failure) and of its extended data; 0xFF asks for all.
inline constexpr std::uint8_t first_snapshot = 0x01U;
inline constexpr std::uint8_t last_snapshot = 0x02U;
inline constexpr std::uint8_t occurrences_record = 0x01U;
inline constexpr std::uint8_t ageing_record = 0x02U;
inline constexpr std::uint8_t all_records = 0xFFU;

// A snapshot has one data identifier (DID), whose data is a FreezeFrame.
inline constexpr std::uint32_t freeze_frame_identifier = 0x0200U;

// Preconditions: `sub_function`, without suppressPosRspMsgIndicationBit, is one of dtc_report, and the
// request has the length that service_table.hpp lists for it.
Nrc report_codes(std::uint8_t sub_function, const Request& request, const TroubleMemory& memory,
                 const monitoring::DiagnosticMemory& monitoring, Response& response) noexcept;

}  // namespace rsi::diagnosis
