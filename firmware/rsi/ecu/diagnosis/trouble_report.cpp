#include "rsi/ecu/diagnosis/trouble_report.hpp"

namespace rsi::diagnosis {
namespace {

constexpr std::uint8_t iso_14229_1_format = 0x01U;

void put_code(std::size_t row, const TroubleMemory& memory, Response& response) {
    response.put_three(trouble_numbers[row]);
    response.put(memory.state(row).status);
}

void put_frame(std::uint8_t record, const FreezeFrame& frame, Response& response) {
    response.put(record);
    response.put(1U);  // identifier
    response.put_two(freeze_frame_identifier);
    response.put_all(frame);
}

void count_by_mask(std::uint8_t mask, const TroubleMemory& memory, Response& response) {
    std::uint32_t count = 0U;
    for (std::size_t row = 0U; row < trouble_code_count; ++row) {
        count += ((memory.state(row).status & mask) != 0U) ? 1U : 0U;
    }
    response.put(status::available);
    response.put(iso_14229_1_format);
    response.put_two(count);
}

void list_by_mask(std::uint8_t mask, const TroubleMemory& memory, Response& response) {
    response.put(status::available);
    for (std::size_t row = 0U; row < trouble_code_count; ++row) {
        if ((memory.state(row).status & mask) != 0U) {
            put_code(row, memory, response);
        }
    }
}

void list_all(const TroubleMemory& memory, Response& response) {
    response.put(status::available);
    for (std::size_t row = 0U; row < trouble_code_count; ++row) {
        put_code(row, memory, response);
    }
}

bool is_wanted(std::uint8_t record, std::uint8_t which) {
    return (record == all_records) || (record == which);
}

// A code without a snapshot is answered, without one.
Nrc report_snapshots(const Request& request, const TroubleMemory& memory, Response& response) {
    const std::size_t row = row_of_number(request.three_bytes(2U));
    const std::uint8_t record = request.byte(5U);
    const bool is_snapshot = is_wanted(record, first_snapshot) || is_wanted(record, last_snapshot);
    if ((row == trouble_code_count) || !is_snapshot) {
        return Nrc::request_out_of_range;
    }
    put_code(row, memory, response);
    const TroubleSnapshots* const kept = memory.snapshots(row);
    if (kept != nullptr) {
        if (is_wanted(record, first_snapshot)) {
            put_frame(first_snapshot, kept->first, response);
        }
        if (is_wanted(record, last_snapshot)) {
            put_frame(last_snapshot, kept->last, response);
        }
    }
    return Nrc::none;
}

Nrc report_extended_data(const Request& request, const TroubleMemory& memory, Response& response) {
    const std::size_t row = row_of_number(request.three_bytes(2U));
    const std::uint8_t record = request.byte(5U);
    const bool is_count = is_wanted(record, occurrences_record) || is_wanted(record, ageing_record);
    if ((row == trouble_code_count) || !is_count) {
        return Nrc::request_out_of_range;
    }
    put_code(row, memory, response);
    if (is_wanted(record, occurrences_record)) {
        response.put(occurrences_record);
        response.put(memory.state(row).occurrences);
    }
    if (is_wanted(record, ageing_record)) {
        response.put(ageing_record);
        response.put(memory.state(row).ageing);
    }
    return Nrc::none;
}

}  // namespace

Nrc report_codes(std::uint8_t sub_function, const Request& request, const TroubleMemory& memory,
                 Response& response) noexcept {
    response.put(sub_function);
    switch (sub_function) {
        case 0x01U:
            count_by_mask(request.byte(2U), memory, response);
            return Nrc::none;
        case 0x02U:
            list_by_mask(request.byte(2U), memory, response);
            return Nrc::none;
        case 0x04U:
            return report_snapshots(request, memory, response);
        case 0x06U:
            return report_extended_data(request, memory, response);
        default:  // 0A
            list_all(memory, response);
            return Nrc::none;
    }
}

}  // namespace rsi::diagnosis
