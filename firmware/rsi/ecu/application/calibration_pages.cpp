#include "rsi/ecu/application/calibration_pages.hpp"

#include <cstring>

#include "rsi/ecu/application/calibration_epk.hpp"
#include "rsi/ecu/application/little_endian.hpp"
#include "rsi/hal/saturating_count.hpp"

namespace rsi::application {
namespace {

namespace map = calibration_map;

constexpr std::array<std::uint8_t, 7> program_name{{'r', 's', 'i', '-', 'e', 'c', 'u'}};

bool are_same(const char* name, const char* other) {
    std::size_t place = 0U;
    while ((name[place] == other[place]) && (name[place] != '\0')) {
        ++place;
    }
    return name[place] == other[place];
}

// 1 + index of the field with that name in parameter_fields, then selection_fields; 0 if there is none.
std::uint8_t number_of(const char* name) {
    std::uint8_t number = 0U;
    std::uint8_t found = 0U;
    const auto look_at = [&](const char* field) {
        ++number;
        if (are_same(name, field)) {
            found = number;
        }
    };
    for (const rsi::ParameterField& field : rsi::parameter_fields) {
        look_at(field.name);
    }
    for (const rsi::SelectionField& field : rsi::selection_fields) {
        look_at(field.name);
    }
    return found;
}

std::uint8_t byte_of(std::uint32_t word, std::uint32_t place) {
    return static_cast<std::uint8_t>(word >> (8U * (place % 4U)));
}

// A byte of an object of words.
template <typename Object>
std::uint8_t byte_in(const Object& object, std::uint32_t place) {
    std::array<std::uint32_t, sizeof(Object) / 4U> words{};
    std::memcpy(words.data(), &object, sizeof words);
    return byte_of(words[place / 4U], place);
}

std::uint8_t byte_in_set(monitoring::CodeSet codes, std::uint32_t place) {
    return static_cast<std::uint8_t>(codes >> (8U * place));
}

// Safe for any address: below the range, the unsigned difference wraps to more than any range's length.
bool is_within(std::uint32_t address, std::size_t count, xcp::Target::Range range) {
    return (count <= range.length) && (address - range.address <= range.length - count);
}

constexpr xcp::Target::Range parameter_range{map::parameters_at, map::parameters_length};
constexpr xcp::Target::Range output_range{map::outputs_at, map::outputs_length};
constexpr xcp::Target::Range input_range{map::inputs_at, map::inputs_length};
constexpr xcp::Target::Range code_range{map::codes_at, map::codes_length};
constexpr xcp::Target::Range change_range{map::change_at, map::change_length};
constexpr xcp::Target::Range epk_range{map::epk_at, calibration_epk.size()};
constexpr xcp::Target::Range name_range{map::name_at, static_cast<std::uint32_t>(program_name.size())};

}  // namespace

ParameterSectionAnswer CalibrationPages::init() noexcept {
    ParameterSectionAnswer answer{ParametersRefusal::missing, rsi::Validation{0, "", ""}};
    if (start_with_stored(answer)) {
        is_usable_ = true;
        return answer;
    }
    answer = ecu_.init(reference_, reference_length_);
    is_usable_ = (answer.refusal == ParametersRefusal::none) || (answer.refusal == ParametersRefusal::value);
    if (is_usable_) {
        take_reference();
    }
    return answer;
}

// False where no good section is stored.
bool CalibrationPages::start_with_stored(ParameterSectionAnswer& answer) noexcept {
    if (stored_ == nullptr) {
        return false;
    }
    const RecordState state = stored_->read(working_);
    ecu_.report_stored_section(refusal_of(state));
    if (!has_record(state)) {
        return false;
    }
    answer = ecu_.init(working_.data(), section::length);
    if (answer.refusal != ParametersRefusal::none) {
        ecu_.report_stored_section(answer.refusal);
    }
    return answer.refusal == ParametersRefusal::none;
}

void CalibrationPages::take_reference() noexcept {
    working_ = SectionBytes{};
    std::memcpy(working_.data(), reference_, section::length);
}

void CalibrationPages::go_on() noexcept {
    if (change_.prepare()) {
        ecu_.change(change_);
        is_changing_ = false;
        hal::count_up(changes_);
    }
}

bool CalibrationPages::begin_change(const std::uint8_t* section) noexcept {
    const rsi::Parameters wanted = section::values_of(section);
    const rsi::Validation answer = change_.begin(ecu_.parameters(), wanted);
    is_changing_ = (answer.accepted != 0);
    refused_field_ = is_changing_ ? std::uint8_t{0U} : number_of(answer.field);
    return is_changing_;
}

bool CalibrationPages::read(std::uint32_t address, xcp::Page page, std::uint8_t* bytes,
                            std::size_t count) const noexcept {
    const bool is_declared =
        (is_usable_ && is_within(address, count, parameter_range)) ||
        is_within(address, count, output_range) || is_within(address, count, input_range) ||
        is_within(address, count, code_range) || is_within(address, count, change_range) ||
        is_within(address, count, epk_range) || is_within(address, count, name_range);
    for (std::size_t place = 0U; is_declared && (place < count); ++place) {
        bytes[place] = byte_at(address + static_cast<std::uint32_t>(place), page);
    }
    return is_declared;
}

// Precondition: `address` is in one of the ranges.
std::uint8_t CalibrationPages::byte_at(std::uint32_t address, xcp::Page page) const noexcept {
    if (address >= map::name_at) {
        return program_name[address - map::name_at];
    }
    if (address >= map::epk_at) {
        return calibration_epk[address - map::epk_at];
    }
    if (address >= map::change_at) {
        return change_byte(address - map::change_at);
    }
    if (address >= map::outputs_at) {
        return measured_byte(address);
    }
    const std::uint32_t place =
        static_cast<std::uint32_t>(section::values_at) + (address - map::parameters_at);
    return (page == xcp::Page::working) ? working_[place] : reference_[place];
}

std::uint8_t CalibrationPages::change_byte(std::uint32_t place) const noexcept {
    const std::array<std::uint8_t, 4> codes{static_cast<std::uint8_t>(selected_),
                                            static_cast<std::uint8_t>(is_changing_), refused_field_, 0U};
    return (place < codes.size()) ? codes[place] : byte_of(changes_, place);
}

// Precondition: `address` is in the range of the outputs, inputs or codes.
std::uint8_t CalibrationPages::measured_byte(std::uint32_t address) const noexcept {
    if (address >= map::codes_at) {
        const monitoring::DiagnosticMemory& memory = ecu_.diagnostic_memory();
        const std::uint32_t place = address - map::codes_at;
        constexpr std::uint32_t length = sizeof(monitoring::CodeSet);
        return (place < length) ? byte_in_set(memory.active_codes(), place)
                                : byte_in_set(memory.confirmed_codes(), place - length);
    }
    if (address >= map::inputs_at) {
        return byte_in(ecu_.inputs(), address - map::inputs_at);
    }
    return byte_in(ecu_.outputs(), address - map::outputs_at);
}

bool CalibrationPages::checksum(std::uint32_t address, xcp::Page page, std::size_t count,
                                std::uint32_t& sum) const noexcept {
    if (!is_usable_ || !is_within(address, count, parameter_range)) {
        return false;
    }
    std::uint32_t remainder = crc32_start;
    for (std::size_t place = 0U; place < count; ++place) {
        remainder = crc32_update(remainder, byte_at(address + static_cast<std::uint32_t>(place), page));
    }
    sum = crc32_end(remainder);
    return true;
}

// A write that begins inside a value is refused unless it continues the last write.
xcp::Error CalibrationPages::write(std::uint32_t address, const std::uint8_t* bytes,
                                   std::size_t count) noexcept {
    if (!is_usable_ || !is_within(address, count, parameter_range)) {
        const bool is_measured = is_within(address, count, output_range) ||
                                 is_within(address, count, input_range) ||
                                 is_within(address, count, code_range);
        return is_measured ? xcp::Error::write_protected : xcp::Error::access_denied;
    }
    std::uint32_t place = address - map::parameters_at;
    if ((place % 4U != 0U) && (place != piece_ends_at_)) {
        return xcp::Error::out_of_range;
    }
    bool is_changed = false;
    for (std::size_t byte = 0U; byte < count; ++byte) {
        piece_[place % 4U] = bytes[byte];
        ++place;
        if (place % 4U == 0U) {
            std::memcpy(&working_[section::values_at + place - 4U], piece_.data(), piece_.size());
            is_changed = true;
        }
    }
    piece_ends_at_ = place;
    if (is_changed && (selected_ == xcp::Page::working)) {
        static_cast<void>(begin_change(working_.data()));  // a refusal is in refused_field_
    }
    return xcp::Error::none;
}

xcp::Error CalibrationPages::select(xcp::Page page) noexcept {
    if (!is_usable_) {
        return xcp::Error::page_not_valid;
    }
    if (!begin_change((page == xcp::Page::working) ? working_.data() : reference_)) {
        return xcp::Error::page_not_valid;
    }
    selected_ = page;
    return xcp::Error::none;
}

xcp::Error CalibrationPages::copy_reference() noexcept {
    if (!is_usable_) {
        return xcp::Error::page_not_valid;
    }
    take_reference();
    piece_ends_at_ = 0U;
    if (selected_ == xcp::Page::working) {
        static_cast<void>(begin_change(working_.data()));
    }
    return xcp::Error::none;
}

// Stores only a section that a start without authority would accept, without a seal, because one that was
// read with it would not be of these values. Tries are limited, so that the memory lasts even where it
// refuses.
xcp::Error CalibrationPages::store() noexcept {
    section::put_checksum(working_.data());
    std::memset(&working_[section::length], 0, seal::sealed_length - section::length);
    rsi::Parameters unused{};
    if (!is_usable_ || (stored_ == nullptr) || (stores_left_ == 0U)) {
        return xcp::Error::access_denied;
    }
    if (read_parameter_section(working_.data(), section::length, unused).refusal != ParametersRefusal::none) {
        return xcp::Error::page_not_valid;
    }
    --stores_left_;
    return stored_->write(working_) ? xcp::Error::none : xcp::Error::temporarily_not_accessible;
}

xcp::Target::Range CalibrationPages::calibration() const noexcept {
    return parameter_range;
}

xcp::Target::Range CalibrationPages::name() const noexcept {
    return name_range;
}

}  // namespace rsi::application
