#include "rsi/ecu/diagnosis/trouble_report.hpp"

#include "rsi/ecu/diagnosis/service_table.hpp"

namespace rsi::diagnosis {
namespace {

// DTCFormatIdentifier of ISO 14229-1: a DTC is a base code of two bytes and a failure type byte.
constexpr std::uint8_t dtc_format_iso_14229_1 = 0x01U;

constexpr std::uint8_t identifiers_per_snapshot = 1U;

// A row is an index into trouble_codes.
void put_dtc_and_status(std::size_t row, const TroubleMemory& memory, Response& response) {
    response.put_u24(trouble_code_numbers[row]);
    response.put(memory.state(row).status);
}

void put_snapshot(std::uint8_t record_number, const FreezeFrame& frame, Response& response) {
    response.put(record_number);
    response.put(identifiers_per_snapshot);
    response.put_u16(freeze_frame_identifier);
    response.put_bytes(frame);
}

void put_count_by_mask(std::uint8_t mask, const TroubleMemory& memory, Response& response) {
    std::uint32_t count = 0U;
    for (std::size_t row = 0U; row < trouble_code_count; ++row) {
        count += ((memory.state(row).status & mask) != 0U) ? 1U : 0U;
    }
    response.put(status::available);
    response.put(dtc_format_iso_14229_1);
    response.put_u16(count);
}

void put_dtcs_by_mask(std::uint8_t mask, const TroubleMemory& memory, Response& response) {
    response.put(status::available);
    for (std::size_t row = 0U; row < trouble_code_count; ++row) {
        if ((memory.state(row).status & mask) != 0U) {
            put_dtc_and_status(row, memory, response);
        }
    }
}

void put_all_dtcs(const TroubleMemory& memory, Response& response) {
    response.put(status::available);
    for (std::size_t row = 0U; row < trouble_code_count; ++row) {
        put_dtc_and_status(row, memory, response);
    }
}

// Codes that are about to be confirmed; ISO 14229-1 leaves out those that are, and those that are not.
void put_counters(const monitoring::DiagnosticMemory& monitoring, Response& response) {
    constexpr std::uint8_t failed = 127U;
    for (std::size_t row = 0U; row < trouble_code_count; ++row) {
        const auto code = static_cast<monitoring::DiagnosticCode>(row + 1U);
        const std::uint8_t counter = monitoring.fault_detection_counter(code);
        if ((counter != 0U) && (counter != failed)) {
            response.put_u24(trouble_code_numbers[row]);
            response.put(counter);
        }
    }
}

bool is_requested(std::uint8_t asked_record, std::uint8_t record) {
    return (asked_record == all_records) || (asked_record == record);
}

// A DTC without a stored snapshot gets a positive response with the DTC and its status alone.
Nrc report_snapshots(const Request& request, const TroubleMemory& memory, Response& response) {
    const std::size_t row = row_of_number(request.u24_at(2U));
    const std::uint8_t asked_record = request.byte(5U);
    const bool is_known_record =
        is_requested(asked_record, first_snapshot) || is_requested(asked_record, last_snapshot);
    if ((row == trouble_code_count) || !is_known_record) {
        return Nrc::request_out_of_range;
    }
    put_dtc_and_status(row, memory, response);
    const TroubleSnapshots* const stored = memory.snapshots(row);
    if (stored != nullptr) {
        if (is_requested(asked_record, first_snapshot)) {
            put_snapshot(first_snapshot, stored->first, response);
        }
        if (is_requested(asked_record, last_snapshot)) {
            put_snapshot(last_snapshot, stored->last, response);
        }
    }
    return Nrc::none;
}

Nrc report_extended_data(const Request& request, const TroubleMemory& memory, Response& response) {
    const std::size_t row = row_of_number(request.u24_at(2U));
    const std::uint8_t asked_record = request.byte(5U);
    const bool is_known_record =
        is_requested(asked_record, occurrences_record) || is_requested(asked_record, ageing_record);
    if ((row == trouble_code_count) || !is_known_record) {
        return Nrc::request_out_of_range;
    }
    put_dtc_and_status(row, memory, response);
    if (is_requested(asked_record, occurrences_record)) {
        response.put(occurrences_record);
        response.put(memory.state(row).occurrences);
    }
    if (is_requested(asked_record, ageing_record)) {
        response.put(ageing_record);
        response.put(memory.state(row).ageing);
    }
    return Nrc::none;
}

}  // namespace

Nrc report_codes(std::uint8_t sub_function, const Request& request, const TroubleMemory& memory,
                 const monitoring::DiagnosticMemory& monitoring, Response& response) noexcept {
    response.put(sub_function);
    switch (sub_function) {
        case dtc_report::number_by_status_mask:
            put_count_by_mask(request.byte(2U), memory, response);
            return Nrc::none;
        case dtc_report::by_status_mask:
            put_dtcs_by_mask(request.byte(2U), memory, response);
            return Nrc::none;
        case dtc_report::snapshot_by_number:
            return report_snapshots(request, memory, response);
        case dtc_report::extended_data_by_number:
            return report_extended_data(request, memory, response);
        case dtc_report::fault_detection_counter:
            put_counters(monitoring, response);
            return Nrc::none;
        default:  // dtc_report::supported
            put_all_dtcs(memory, response);
            return Nrc::none;
    }
}

}  // namespace rsi::diagnosis
