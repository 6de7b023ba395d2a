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

bool read_value(std::uint32_t identifier, const DataSources& sources, Response& response) {
    // Below its first one, each is a large number.
    const std::size_t number = identifier - first_number_identifier;
    const std::size_t code = identifier - first_code_identifier;
    const std::size_t input = identifier - first_input_identifier;
    if (number < rsi::number_outputs.size()) {
        response.put_16(identifier);
        response.put_32(application::word_of(sources.outputs.*rsi::number_outputs[number].member));
    } else if (code < rsi::code_outputs.size()) {
        response.put_16(identifier);
        response.put(static_cast<std::uint8_t>(sources.outputs.*rsi::code_outputs[code].member));
    } else if (input < input_values.size()) {
        response.put_16(identifier);
        response.put_32(application::word_of(sources.inputs.*input_values[input].member));
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
