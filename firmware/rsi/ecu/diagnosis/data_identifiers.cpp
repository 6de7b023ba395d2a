#include "rsi/ecu/diagnosis/data_identifiers.hpp"

#include "rsi/ecu/application/little_endian.hpp"

namespace rsi::diagnosis {
namespace {

template <std::size_t length>
void take_bytes(const Request& request, std::size_t place, std::array<std::uint8_t, length>& bytes) {
    for (std::size_t index = 0U; index < length; ++index) {
        bytes[index] = request.byte(place + index);
    }
}

template <typename Element, std::size_t count>
bool answer(std::uint32_t identifier, const std::array<Element, count>& elements, Response& response) {
    response.put_u16(identifier);
    for (const Element each : elements) {
        response.put(static_cast<std::uint8_t>(each));
    }
    return true;
}

bool read_identification(std::uint32_t identifier, const DataSources& sources, Response& response) {
    const Identification& texts = sources.identification;
    switch (identifier) {
        case calibration_name_identifier:
            return (sources.calibration.name[0] != '\0')
                       ? answer(identifier, sources.calibration.name, response)
                       : answer(identifier, texts.calibration_name, response);
        case calibration_checksum_identifier:
            response.put_u16(identifier);
            response.put_u32(sources.calibration.checksum);
            return true;
        case operation_cycles_identifier:
            return answer(identifier, sources.operation_cycles, response);
        case active_session_identifier:
            return answer(identifier, std::array<Session, 1>{sources.session}, response);
        case serial_number_identifier:
            return answer(identifier, texts.serial_number, response);
        case vehicle_number_identifier:
            return answer(identifier, sources.written.vehicle_number, response);
        case hardware_identifier:
            return answer(identifier, texts.hardware, response);
        case software_version_identifier:
            return answer(identifier, texts.software_version, response);
        case system_name_identifier:
            return answer(identifier, texts.system_name, response);
        case programming_date_identifier:
            return answer(identifier, sources.written.programming_date, response);
        default:
            return false;
    }
}

constexpr std::array<float rsi::Outputs::*, rsi::number_count> number_members =
    members_of<float rsi::Outputs::*>(rsi::number_outputs);
constexpr std::array<std::int32_t rsi::Outputs::*, rsi::code_count> code_members =
    members_of<std::int32_t rsi::Outputs::*>(rsi::code_outputs);
constexpr std::array<float rsi::Inputs::*, input_values.size()> input_members =
    members_of<float rsi::Inputs::*>(input_values);

bool read_value(std::uint32_t identifier, const DataSources& sources, Response& response) {
    // Below its first one, each is a large number.
    const std::size_t number = identifier - first_number_identifier;
    const std::size_t code = identifier - first_code_identifier;
    const std::size_t input = identifier - first_input_identifier;
    if (number < number_members.size()) {
        response.put_u16(identifier);
        response.put_u32(application::float_bits(sources.outputs.*number_members[number]));
    } else if (code < code_members.size()) {
        response.put_u16(identifier);
        response.put(static_cast<std::uint8_t>(sources.outputs.*code_members[code]));
    } else if (input < input_members.size()) {
        response.put_u16(identifier);
        response.put_u32(application::float_bits(sources.inputs.*input_members[input]));
    } else {
        return false;
    }
    return true;
}

bool is_between(std::uint32_t number, std::uint32_t first, std::uint32_t last) {
    return (number >= first) && (number <= last);
}

bool is_of_a_vehicle_number(std::uint8_t letter) {
    const bool is_digit = is_between(letter, '0', '9');
    const bool is_capital = is_between(letter, 'A', 'Z');
    return is_digit || (is_capital && (letter != 'I') && (letter != 'O') && (letter != 'Q'));
}

bool is_decimal(std::uint8_t byte) {
    return ((byte >> 4U) <= 9U) && ((byte & 0x0FU) <= 9U);
}

// Number of two decimal digits.
std::uint32_t decimal(std::uint8_t byte) {
    return 10U * (std::uint32_t{byte} >> 4U) + (byte & 0x0FU);
}

// Century, year, month and day; years that can be divided by four are leap years until 2100.
bool is_date(const Request& request, std::size_t place) {
    constexpr std::array<std::uint8_t, 12> days{31U, 28U, 31U, 30U, 31U, 30U, 31U, 31U, 30U, 31U, 30U, 31U};
    const std::uint32_t year = decimal(request.byte(place + 1U));
    const std::uint32_t month = decimal(request.byte(place + 2U));
    const bool is_year = (request.byte(place) == 0x20U) && is_decimal(request.byte(place + 1U));
    const bool are_digits = is_decimal(request.byte(place + 2U)) && is_decimal(request.byte(place + 3U));
    if (!is_year || !are_digits || !is_between(month, 1U, 12U)) {
        return false;
    }
    const bool is_long = (month == 2U) && (year % 4U == 0U);
    const std::uint32_t last = days[month - 1U] + (is_long ? 1U : 0U);
    return is_between(decimal(request.byte(place + 3U)), 1U, last);
}

}  // namespace

bool read_identifier(std::uint32_t identifier, const DataSources& sources, Response& response) noexcept {
    return read_value(identifier, sources, response) || read_identification(identifier, sources, response);
}

std::size_t writable_length(std::uint32_t identifier) noexcept {
    if (identifier == vehicle_number_identifier) {
        return std::tuple_size<decltype(WrittenData::vehicle_number)>::value;
    }
    return (identifier == programming_date_identifier)
               ? std::tuple_size<decltype(WrittenData::programming_date)>::value
               : 0U;
}

bool is_writable(std::uint32_t identifier, const Request& request, std::size_t place) noexcept {
    if (identifier != vehicle_number_identifier) {
        return is_date(request, place);
    }
    bool is_good = true;
    for (std::size_t index = 0U; index < std::tuple_size<decltype(WrittenData::vehicle_number)>::value;
         ++index) {
        is_good = is_good && is_of_a_vehicle_number(request.byte(place + index));
    }
    return is_good;
}

void write_identifier(std::uint32_t identifier, const Request& request, std::size_t place,
                      WrittenData& written) noexcept {
    if (identifier == vehicle_number_identifier) {
        take_bytes(request, place, written.vehicle_number);
    } else {
        take_bytes(request, place, written.programming_date);
    }
}

}  // namespace rsi::diagnosis
