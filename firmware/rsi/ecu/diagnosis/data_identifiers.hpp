// Data identifiers: what ReadDataByIdentifier (22) and WriteDataByIdentifier (2E) know.
//
//   F182                           name of the calibration in use, filled up with zeros: of the section, else
//                                  that of the integration
//   F18C, F191, F195, F197         texts of the integration, likewise
//   F186                           the session
//   F1A0                           CRC-32 of the values in use, as XCP's BUILD_CHECKSUM has it
//   F1A1                           operation cycles since the trouble memory was new, with the present one
//   F190, F199                     vehicle identification number, programming date (BCD): written, and kept
//   1000 + n, 1100 + n             the outputs of the component: numbers (float) and codes (one byte), each
//                                  in the order of rsi/output_table.hpp
//   1200 + n                       its inputs (float), in the order of rsi_inputs; NaN: not available
//
// A number has its most significant byte first.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "rsi/ecu/application/calibration_identity.hpp"
#include "rsi/ecu/diagnosis/message.hpp"
#include "rsi/ecu/diagnosis/uds.hpp"
#include "rsi/output_table.hpp"
#include "rsi/types.hpp"

namespace rsi::diagnosis {

using ShortText = std::array<char, 16>;
using LongText = std::array<char, 48>;

// Its first letters, and zeros.
template <typename Text, std::size_t size>
constexpr Text text_of(const char (&letters)[size]) noexcept {
    Text text{};
    static_assert(size - 1U <= std::tuple_size<Text>::value, "too long");
    for (std::size_t place = 0U; place + 1U < size; ++place) {
        text[place] = letters[place];
    }
    return text;
}

// Texts of the integration.
struct Identification {
    ShortText system_name{text_of<ShortText>("Rollover warning")};
    ShortText software_version{};
    LongText calibration_name{};
    ShortText hardware{};
    ShortText serial_number{};
};

inline constexpr std::uint32_t calibration_name_identifier = 0xF182U;
inline constexpr std::uint32_t serial_number_identifier = 0xF18CU;
inline constexpr std::uint32_t hardware_identifier = 0xF191U;
inline constexpr std::uint32_t software_version_identifier = 0xF195U;
inline constexpr std::uint32_t system_name_identifier = 0xF197U;
inline constexpr std::uint32_t active_session_identifier = 0xF186U;
inline constexpr std::uint32_t vehicle_number_identifier = 0xF190U;
inline constexpr std::uint32_t programming_date_identifier = 0xF199U;
inline constexpr std::uint32_t calibration_checksum_identifier = 0xF1A0U;
inline constexpr std::uint32_t operation_cycles_identifier = 0xF1A1U;

// Data written by a workshop.
struct WrittenData {
    std::array<std::uint8_t, 17> vehicle_number{};
    std::array<std::uint8_t, 4> programming_date{};
};

struct InputValue {
    const char* name;
    const char* unit;
    float rsi::Inputs::* member;
};

inline constexpr std::array<InputValue, 9> input_values{{
    {"lateral_specific_force_mps2", "m/s^2", &rsi::Inputs::lateral_specific_force_mps2},
    {"vertical_specific_force_mps2", "m/s^2", &rsi::Inputs::vertical_specific_force_mps2},
    {"roll_rate_radps", "rad/s", &rsi::Inputs::roll_rate_radps},
    {"roll_angle_rad", "rad", &rsi::Inputs::roll_angle_rad},
    {"bank_angle_rad", "rad", &rsi::Inputs::bank_angle_rad},
    {"yaw_rate_radps", "rad/s", &rsi::Inputs::yaw_rate_radps},
    {"speed_mps", "m/s", &rsi::Inputs::speed_mps},
    {"steering_wheel_angle_rad", "rad", &rsi::Inputs::steering_wheel_angle_rad},
    {"vehicle_mass_kg", "kg", &rsi::Inputs::vehicle_mass_kg},
}};
static_assert(sizeof(rsi::Inputs) == input_values.size() * sizeof(float), "an input has no identifier");

inline constexpr std::uint32_t first_number_identifier = 0x1000U;
inline constexpr std::uint32_t first_code_identifier = 0x1100U;
inline constexpr std::uint32_t first_input_identifier = 0x1200U;

// The members alone: names and units of the table stay out of the image.
template <typename Member, typename Table>
constexpr std::array<Member, std::tuple_size<Table>::value> members_of(const Table& table) {
    std::array<Member, std::tuple_size<Table>::value> members{};
    for (std::size_t index = 0U; index < members.size(); ++index) {
        members[index] = table[index].member;
    }
    return members;
}

// Sources of the identifiers' data.
struct DataSources {
    const Identification& identification;
    const application::CalibrationIdentity& calibration;
    const WrittenData& written;
    const rsi::Inputs& inputs;
    const rsi::Outputs& outputs;
    Session session;
    const std::array<std::uint8_t, 4>& operation_cycles;
};

// Adds the identifier and its data to the response; false for an unknown one.
bool read_identifier(std::uint32_t identifier, const DataSources& sources, Response& response) noexcept;

// 0 where it cannot be written.
std::size_t writable_length(std::uint32_t identifier) noexcept;

// True for data that may be written there: the letters and digits of a vehicle identification number (ISO
// 3779, without I, O and Q), a date of this century. They are as long as that, from their place in the
// request on.
bool is_writable(std::uint32_t identifier, const Request& request, std::size_t place) noexcept;

// Takes such data.
void write_identifier(std::uint32_t identifier, const Request& request, std::size_t place,
                      WrittenData& written) noexcept;

}  // namespace rsi::diagnosis
