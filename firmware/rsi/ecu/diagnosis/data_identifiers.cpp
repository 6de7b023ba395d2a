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
            return answer(identifier, texts.calibration_name, response);
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

void write_identifier(std::uint32_t identifier, const Request& request, std::size_t place,
                      WrittenData& written) noexcept {
    if (identifier == vehicle_number_identifier) {
        take_bytes(request, place, written.vehicle_number);
    } else {
        take_bytes(request, place, written.programming_date);
    }
}

}  // namespace rsi::diagnosis
