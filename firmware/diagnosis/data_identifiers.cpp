#include "diagnosis/data_identifiers.hpp"

#include "application/little_endian.hpp"

namespace diagnosis {
namespace {

void put_text(std::string_view text, std::size_t length, Response& response) {
    for (std::size_t place = 0U; place < length; ++place) {
        response.put((place < text.size()) ? static_cast<std::uint8_t>(text[place]) : std::uint8_t{0U});
    }
}

template <std::size_t length>
void take_bytes(const Request& request, std::size_t place, std::array<std::uint8_t, length>& bytes) {
    for (std::size_t index = 0U; index < length; ++index) {
        bytes[index] = request.byte(place + index);
    }
}

bool read_identification(std::uint32_t identifier, const DataSources& sources, Response& response) {
    for (const IdentificationText& each : identification_texts) {
        if (identifier == each.identifier) {
            response.put_two(identifier);
            put_text(sources.identification.*each.text, each.length, response);
            return true;
        }
    }
    if (identifier == active_session_identifier) {
        response.put_two(identifier);
        response.put(static_cast<std::uint8_t>(sources.session));
    } else if (identifier == vehicle_number_identifier) {
        response.put_two(identifier);
        response.put_all(sources.written.vehicle_number);
    } else if (identifier == programming_date_identifier) {
        response.put_two(identifier);
        response.put_all(sources.written.programming_date);
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
        response.put_two(identifier);
        response.put_four(application::word_of(sources.outputs.*numbers[number]));
    } else if (code < codes.size()) {
        response.put_two(identifier);
        response.put(static_cast<std::uint8_t>(sources.outputs.*codes[code]));
    } else if (input < inputs.size()) {
        response.put_two(identifier);
        response.put_four(application::word_of(sources.inputs.*inputs[input]));
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

}  // namespace diagnosis
