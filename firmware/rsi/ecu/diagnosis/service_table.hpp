// Service table: services, sub-functions and request lengths that the server accepts, with the sessions and
// the addressing of each. The server checks a request against it before it runs the service.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "rsi/ecu/diagnosis/uds.hpp"

namespace rsi::diagnosis {

namespace service_id {
inline constexpr std::uint8_t session_control = 0x10U;
inline constexpr std::uint8_t reset = 0x11U;
inline constexpr std::uint8_t clear_codes = 0x14U;
inline constexpr std::uint8_t read_codes = 0x19U;
inline constexpr std::uint8_t read_data = 0x22U;
inline constexpr std::uint8_t security_access = 0x27U;
inline constexpr std::uint8_t communication_control = 0x28U;
inline constexpr std::uint8_t write_data = 0x2EU;
inline constexpr std::uint8_t routine_control = 0x31U;
inline constexpr std::uint8_t request_download = 0x34U;
inline constexpr std::uint8_t transfer_data = 0x36U;
inline constexpr std::uint8_t transfer_exit = 0x37U;
inline constexpr std::uint8_t tester_present = 0x3EU;
inline constexpr std::uint8_t code_setting = 0x85U;
}  // namespace service_id

// Sub-functions of ReadDTCInformation.
namespace dtc_report {
inline constexpr std::uint8_t number_by_status_mask = 0x01U;
inline constexpr std::uint8_t by_status_mask = 0x02U;
inline constexpr std::uint8_t snapshot_by_number = 0x04U;
inline constexpr std::uint8_t extended_data_by_number = 0x06U;
inline constexpr std::uint8_t supported = 0x0AU;
inline constexpr std::uint8_t fault_detection_counter = 0x14U;
}  // namespace dtc_report

// Sub-functions of SecurityAccess, for the one security level.
namespace security {
inline constexpr std::uint8_t request_seed = 0x01U;
inline constexpr std::uint8_t send_key = 0x02U;
}  // namespace security

// Sets of sessions, one bit each.
namespace in {
constexpr std::uint8_t session(Session session) noexcept {
    return static_cast<std::uint8_t>(1U << static_cast<unsigned>(session));
}
inline constexpr std::uint8_t extended = session(Session::extended);
inline constexpr std::uint8_t programming = session(Session::programming);
inline constexpr std::uint8_t not_standard = extended | programming;
inline constexpr std::uint8_t all = not_standard | session(Session::standard);
}  // namespace in

enum class SubFunction : std::uint8_t {
    none,    // the second byte is data
    listed,  // one of sub_functions, checked before the service
    own,     // the service checks it after its other data, as ISO 14229-1 orders
};

struct Service {
    std::uint8_t id;
    std::uint8_t sessions;
    bool is_secured;     // every request needs security access, whatever it holds
    bool is_functional;  // answered under functional addressing
    SubFunction sub_function;
};

inline constexpr std::array<Service, 14> services{{
    {service_id::session_control, in::all, false, true, SubFunction::listed},
    {service_id::reset, in::not_standard, false, true, SubFunction::listed},
    {service_id::clear_codes, in::not_standard, true, true, SubFunction::none},
    {service_id::read_codes, in::all, false, true, SubFunction::listed},
    {service_id::read_data, in::all, false, true, SubFunction::none},
    {service_id::security_access, in::not_standard, false, false, SubFunction::listed},
    {service_id::communication_control, in::extended, false, true, SubFunction::listed},
    {service_id::write_data, in::extended, false, false, SubFunction::none},
    {service_id::routine_control, in::not_standard, false, false, SubFunction::own},
    {service_id::request_download, in::programming, false, false, SubFunction::none},
    {service_id::transfer_data, in::programming, true, false, SubFunction::none},
    {service_id::transfer_exit, in::programming, true, false, SubFunction::none},
    {service_id::tester_present, in::all, false, true, SubFunction::listed},
    {service_id::code_setting, in::extended, false, true, SubFunction::listed},
}};

struct ListedSubFunction {
    std::uint8_t service;
    std::uint8_t number;
    std::uint8_t length;  // of the whole request, in bytes
};

inline constexpr std::array<ListedSubFunction, 18> sub_functions{{
    {service_id::session_control, 0x01U, 2U},
    {service_id::session_control, 0x02U, 2U},
    {service_id::session_control, 0x03U, 2U},
    {service_id::reset, 0x01U, 2U},  // hardReset
    {service_id::reset, 0x03U, 2U},  // softReset; this ECU treats both alike
    {service_id::read_codes, dtc_report::number_by_status_mask, 3U},
    {service_id::read_codes, dtc_report::by_status_mask, 3U},
    {service_id::read_codes, dtc_report::snapshot_by_number, 6U},
    {service_id::read_codes, dtc_report::extended_data_by_number, 6U},
    {service_id::read_codes, dtc_report::supported, 2U},
    {service_id::read_codes, dtc_report::fault_detection_counter, 2U},
    {service_id::security_access, security::request_seed, 2U},
    {service_id::security_access, security::send_key, 18U},  // a key of 16 bytes
    {service_id::communication_control, 0x00U, 3U},          // enableRxAndTx
    {service_id::communication_control, 0x01U, 3U},          // enableRxAndDisableTx
    {service_id::tester_present, 0x00U, 2U},
    {service_id::code_setting, 0x01U, 2U},  // on
    {service_id::code_setting, 0x02U, 2U},  // off
}};

// NRC 0x7E (sub-function not supported in active session) is never sent: each sub-function is available in
// every session of its service.

}  // namespace rsi::diagnosis
