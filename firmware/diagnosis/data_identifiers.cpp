#include "diagnosis/data_identifiers.hpp"

#include "application/little_endian.hpp"

namespace diagnosis {
namespace {

void put_text(const char* text, std::size_t length, Response& response) {
    for (std::size_t count = 0U; count < length; ++count) {
        response.put(static_cast<std::uint8_t>(*text));
        text += (*text != '\0') ? 1 : 0;
    }
}

template <std::size_t length>
void put_bytes(const std::array<std::uint8_t, length>& bytes, Response& response) {
    for (const std::uint8_t byte : bytes) {
        response.put(byte);
    }
}

bool read_identification(std::uint32_t identifier, const DataSources& sources, Response& response) {
    for (const IdentificationText& each : identification_texts) {
        if (identifier == each.identifier) {
            response.put_16(identifier);
            put_text(sources.identification.*each.text, each.length, response);
            return true;
        }
    }
    if (identifier == active_session_identifier) {
        response.put_16(identifier);
        response.put(static_cast<std::uint8_t>(sources.session));
    } else if (identifier == vehicle_number_identifier) {
        response.put_16(identifier);
        put_bytes(sources.written.vehicle_number, response);
    } else if (identifier == programming_date_identifier) {
        response.put_16(identifier);
        put_bytes(sources.written.programming_date, response);
    } else {
        return false;
    }
    return true;
}

// The members alone: names and units of the table stay out of the image.
template <typename Member, typename Table>
constexpr std::array<Member, std::tuple_size<Table>::value> members_of(const Table& table) {
    std::array<Member, std::tuple_size<Table>::value> members{};
    for (std::size_t index = 0U; index < members.size(); ++index) {
        members[index] = table[index].member;
    }
    return members;
}

constexpr std::array<float rsi::Outputs::*, rsi::number_count> numbers =
    members_of<float rsi::Outputs::*>(rsi::number_outputs);
constexpr std::array<std::int32_t rsi::Outputs::*, rsi::code_count> codes =
    members_of<std::int32_t rsi::Outputs::*>(rsi::code_outputs);
constexpr std::array<float rsi::Inputs::*, input_values.size()> inputs =
    members_of<float rsi::Inputs::*>(input_values);

bool read_value(std::uint32_t identifier, const DataSources& sources, Response& response) {
    // Below its first one, each is a large number.
    const std::size_t number = identifier - first_number_identifier;
    const std::size_t code = identifier - first_code_identifier;
    const std::size_t input = identifier - first_input_identifier;
    if (number < numbers.size()) {
        response.put_16(identifier);
        response.put_32(application::word_of(sources.outputs.*numbers[number]));
    } else if (code < codes.size()) {
        response.put_16(identifier);
        response.put(static_cast<std::uint8_t>(sources.outputs.*codes[code]));
    } else if (input < inputs.size()) {
        response.put_16(identifier);
        response.put_32(application::word_of(sources.inputs.*inputs[input]));
    } else {
        return false;
    }
    return true;
}

}  // namespace

bool read_identifier(std::uint32_t identifier, const DataSources& sources, Response& response) noexcept {
    return read_value(identifier, sources, response) || read_identification(identifier, sources, response);
}

WritableData writable_data(std::uint32_t identifier, WrittenData& written) noexcept {
    if (identifier == vehicle_number_identifier) {
        return WritableData{written.vehicle_number.data(), written.vehicle_number.size()};
    }
    if (identifier == programming_date_identifier) {
        return WritableData{written.programming_date.data(), written.programming_date.size()};
    }
    return WritableData{nullptr, 0U};
}

}  // namespace diagnosis
