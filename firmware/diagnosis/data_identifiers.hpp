// Data identifiers: what ReadDataByIdentifier (22) and WriteDataByIdentifier (2E) know.
//
//   F182, F18C, F191, F195, F197   texts of the integration, filled up with zeros
//   F186                           the session
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
#include <string_view>

#include "diagnosis/message.hpp"
#include "diagnosis/uds.hpp"
#include "rsi/output_table.hpp"
#include "rsi/types.hpp"

namespace diagnosis {

// Texts that outlive the diagnosis; a longer one is cut off.
struct Identification {
    std::string_view system_name{"Rollover warning"};
    std::string_view software_version{""};
    std::string_view calibration_name{""};
    std::string_view hardware{""};
    std::string_view serial_number{""};
};

struct IdentificationText {
    std::uint32_t identifier;
    std::size_t length;
    std::string_view Identification::* text;
    const char* name;
};

inline constexpr std::array<IdentificationText, 5> identification_texts{{
    {0xF182U, 48U, &Identification::calibration_name, "calibration name"},
    {0xF18CU, 16U, &Identification::serial_number, "serial number"},
    {0xF191U, 16U, &Identification::hardware, "hardware"},
    {0xF195U, 16U, &Identification::software_version, "software version"},
    {0xF197U, 16U, &Identification::system_name, "system name"},
}};

inline constexpr std::uint32_t active_session_identifier = 0xF186U;
inline constexpr std::uint32_t vehicle_number_identifier = 0xF190U;
inline constexpr std::uint32_t programming_date_identifier = 0xF199U;

// What a workshop has written.
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

// What identifiers are read from.
struct DataSources {
    const Identification& identification;
    const WrittenData& written;
    const rsi::Inputs& inputs;
    const rsi::Outputs& outputs;
    Session session;
};

// Adds the identifier and its data to the response; false where nobody knows it.
bool read_identifier(std::uint32_t identifier, const DataSources& sources, Response& response) noexcept;

// 0 where it cannot be written.
std::size_t writable_length(std::uint32_t identifier) noexcept;

// Takes the data, which are as long as that, from their place in the request.
void write_identifier(std::uint32_t identifier, const Request& request, std::size_t place,
                      WrittenData& written) noexcept;

}  // namespace diagnosis
