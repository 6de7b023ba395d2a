// Parameter section as a file: what is written into a flashed image to change its calibration.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "hal/software_keys/cmac.hpp"
#include "rsi/ecu/application/parameter_section.hpp"
#include "rsi/ecu/application/section_authority.hpp"
#include "rsi/types.hpp"

namespace sil {

// The section that rsi::application::read_parameter_section reads. `name` is at most 48 printable ASCII
// characters; throws InputError otherwise. The parameters are written as they are, valid or not.
std::vector<std::uint8_t> parameter_section(const rsi::Parameters& parameters, std::string_view name);

// The same with its seal. `version` is never less than that of the section before.
std::vector<std::uint8_t> sealed(const std::vector<std::uint8_t>& section, std::uint32_t version,
                                 const rsi::hal::Key& key);

// Whether a section that is otherwise good has something behind it that looks like a seal.
bool is_sealed(const std::vector<std::uint8_t>& section);

// The version in a section that is_sealed.
std::uint32_t sealed_version(const std::vector<std::uint8_t>& section);

// Errors of the seal for a control unit with `key` that has used no section yet.
rsi::application::SealFault seal_fault(const std::vector<std::uint8_t>& section, const rsi::hal::Key& key);

// The name in a section that is not `missing` and not too short.
std::string section_name(const std::vector<std::uint8_t>& section);

// Intel HEX with 32-bit addresses, 16 bytes a record. Throws InputError when the section would go
// beyond the last address.
std::string intel_hex(const std::vector<std::uint8_t>& section, std::uint32_t address);

// C source that puts the section into `.parameters` of an image.
std::string section_source(const std::vector<std::uint8_t>& section);

// The values as a calibration file that load_calibration reads back to the very same floats.
std::string calibration_toml(const rsi::Parameters& parameters);

// The same as a C99 header that defines `name`_parameters, for a program that has its calibration built in.
// `name` must be an identifier; throws InputError otherwise.
std::string calibration_header(const rsi::Parameters& parameters, std::string_view name);

// Meaning of a refusal and what to do next, in one sentence without its end.
std::string explain(const rsi::application::ParameterSectionAnswer& answer);
std::string explain(rsi::application::SealFault fault);

}  // namespace sil
