// odx-table: what ODX needs to know of the firmware, from the firmware's own tables. Lines of fields that are
// separated by tabs:
//   constant   NAME VALUE
//   code       NUMBER-OF-THE-DIAGNOSTIC-CODE TROUBLE-CODE
//   text       IDENTIFIER LENGTH NAME
//   number     IDENTIFIER NAME UNIT       float
//   choice     IDENTIFIER NAME LARGEST MEANING    one byte
//   service    IDENTIFIER
//   sub        SERVICE NUMBER
#include <fmt/format.h>

#include "rsi/ecu/application/parameter_section.hpp"
#include "rsi/ecu/diagnosis/data_identifiers.hpp"
#include "rsi/ecu/diagnosis/service_table.hpp"
#include "rsi/ecu/diagnosis/trouble_report.hpp"
#include "rsi/ecu/diagnosis/uds_server.hpp"
#include "rsi/rsi_outputs.h"

namespace {

void constants() {
    constexpr rsi::diagnosis::Addresses addresses{};
    fmt::print("constant\tphysical_request\t{}\n", addresses.physical_request);
    fmt::print("constant\tfunctional_request\t{}\n", addresses.functional_request);
    fmt::print("constant\tresponse\t{}\n", addresses.response);
    fmt::print("constant\tself_test_routine\t{}\n", rsi::diagnosis::self_test_routine);
    fmt::print("constant\tcheck_section_routine\t{}\n", rsi::diagnosis::check_section_routine);
    fmt::print("constant\tfreeze_frame_identifier\t{}\n", rsi::diagnosis::freeze_frame_identifier);
    fmt::print("constant\tvehicle_number_identifier\t{}\n", rsi::diagnosis::vehicle_number_identifier);
    fmt::print("constant\tprogramming_date_identifier\t{}\n", rsi::diagnosis::programming_date_identifier);
    fmt::print("constant\tactive_session_identifier\t{}\n", rsi::diagnosis::active_session_identifier);
    fmt::print("constant\tcalibration_checksum_identifier\t{}\n",
               rsi::diagnosis::calibration_checksum_identifier);
    fmt::print("constant\toperation_cycles_identifier\t{}\n", rsi::diagnosis::operation_cycles_identifier);
    fmt::print("constant\tsection_values_at\t{}\n", rsi::application::section::values_at);
    fmt::print("constant\tsection_length\t{}\n", rsi::application::section::length);
}

void codes() {
    for (const rsi::diagnosis::TroubleCode& each : rsi::diagnosis::trouble_codes) {
        fmt::print("code\t{}\t{}\n", static_cast<unsigned>(each.code), each.number);
    }
}

void text(std::uint32_t identifier, std::size_t length, const char* name) {
    fmt::print("text\t{}\t{}\t{}\n", identifier, length, name);
}

void data() {
    const rsi::diagnosis::Identification all{};
    text(rsi::diagnosis::calibration_name_identifier, all.calibration_name.size(), "calibration name");
    text(rsi::diagnosis::serial_number_identifier, all.serial_number.size(), "serial number");
    text(rsi::diagnosis::hardware_identifier, all.hardware.size(), "hardware");
    text(rsi::diagnosis::software_version_identifier, all.software_version.size(), "software version");
    text(rsi::diagnosis::system_name_identifier, all.system_name.size(), "system name");
    std::uint32_t identifier = rsi::diagnosis::first_number_identifier;
    for (const rsi::NumberOutput& each : rsi::number_outputs) {
        fmt::print("number\t{}\t{}\t{}\n", identifier++, each.name, each.unit);
    }
    identifier = rsi::diagnosis::first_input_identifier;
    for (const rsi::diagnosis::InputValue& each : rsi::diagnosis::input_values) {
        fmt::print("number\t{}\t{}\t{}\n", identifier++, each.name, each.unit);
    }
    identifier = rsi::diagnosis::first_code_identifier;
#define RSI_CODE(name, reset, largest, risk, meaning) \
    fmt::print("choice\t{}\t{}\t{}\t{}\n", identifier++, #name, static_cast<int>(largest), meaning);
#define RSI_NOTHING(...)
    RSI_OUTPUTS(RSI_CODE, RSI_NOTHING, RSI_NOTHING)
#undef RSI_NOTHING
#undef RSI_CODE
}

void services() {
    for (const rsi::diagnosis::Service& each : rsi::diagnosis::services) {
        fmt::print("service\t{}\n", unsigned{each.id});
    }
    for (const rsi::diagnosis::ListedSubFunction& each : rsi::diagnosis::sub_functions) {
        fmt::print("sub\t{}\t{}\n", unsigned{each.service}, unsigned{each.number});
    }
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 1) {
        fmt::print(stderr,
                   "{}: takes no arguments; the head of sil/exchange/odx/table.cpp says what it prints\n",
                   argv[0]);
        return 2;
    }
    constants();
    codes();
    data();
    services();
    return 0;
}
