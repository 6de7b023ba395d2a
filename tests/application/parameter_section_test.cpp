// The parameter section: whatever is wrong with it is noticed and named, and nothing of it is used.
#include "rsi/ecu/application/parameter_section.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

#include "tests/application/bench.hpp"
#include "tests/application/roll_plane_vehicle.hpp"

extern "C" const unsigned char rsi_parameter_section[rsi::application::section::length];

namespace testing_application {
namespace {

using rsi::application::ParametersRefusal;
namespace section = rsi::application::section;
using Bytes = std::vector<std::uint8_t>;

// The committed one of the large SUV.
Bytes good_section() {
    return {rsi_parameter_section, rsi_parameter_section + section::length};
}

void write(Bytes& bytes, std::size_t at, std::uint32_t value, std::size_t count = 4U) {
    for (std::size_t index = 0U; index < count; ++index) {
        bytes[at + index] = static_cast<std::uint8_t>(value >> (8U * index));
    }
}

// With the checksum that belongs to what is in it now.
Bytes sealed(Bytes bytes) {
    write(bytes, section::checksum_at, rsi::application::crc32(bytes.data(), section::checksum_at));
    return bytes;
}

std::uint32_t bits_of(float value) {
    std::uint32_t bits = 0U;
    std::memcpy(&bits, &value, sizeof bits);
    return bits;
}

Bytes with_value(std::size_t index, float value) {
    Bytes bytes = good_section();
    write(bytes, section::values_at + 4U * index, bits_of(value));
    return sealed(bytes);
}

// The answer; a refusal must leave every byte of the parameters as it was.
rsi::application::ParameterSectionAnswer read(const Bytes& bytes, std::size_t length) {
    rsi::Parameters parameters{};
    std::memset(&parameters, 0x5A, sizeof parameters);
    const rsi::Parameters before = parameters;
    const rsi::application::ParameterSectionAnswer answer =
        rsi::application::read_parameter_section(bytes.data(), length, parameters);
    if (answer.refusal != ParametersRefusal::none) {
        EXPECT_EQ(std::memcmp(&parameters, &before, sizeof parameters), 0);
    }
    return answer;
}

ParametersRefusal refusal_of(const Bytes& bytes) {
    return read(bytes, bytes.size()).refusal;
}

TEST(Crc32, HasItsCheckValue) {
    const std::string digits = "123456789";
    const Bytes bytes{digits.begin(), digits.end()};
    EXPECT_EQ(rsi::application::crc32(bytes.data(), bytes.size()), 0xCBF4'3926U);
}

TEST(ParameterSection, IsReadWithEveryValueInItsPlace) {
    rsi::Parameters parameters{};
    const Bytes bytes = good_section();
    const rsi::application::ParameterSectionAnswer answer =
        rsi::application::read_parameter_section(bytes.data(), bytes.size(), parameters);
    EXPECT_EQ(answer.refusal, ParametersRefusal::none);
    EXPECT_EQ(answer.validation.accepted, 1);
    EXPECT_EQ(parameters.sprung_mass_kg, 2060.0F);
    EXPECT_EQ(parameters.imu_z_m, -0.35F);
    EXPECT_EQ(parameters.recovery_s, 0.1F);
    EXPECT_EQ(parameters.estimator, RSI_ESTIMATOR_CONSIDER_KALMAN);
    EXPECT_EQ(parameters.warning_indicator, RSI_INDICATOR_PREDICTED_LOAD_TRANSFER);
}

TEST(ParameterSection, MayLieInALargerMemory) {
    Bytes bytes = good_section();
    bytes.resize(4096U, std::uint8_t{0xFFU});
    EXPECT_EQ(refusal_of(bytes), ParametersRefusal::none);
}

TEST(ParameterSection, EveryFlippedBitIsNoticed) {
    for (std::size_t bit = 0U; bit < 8U * section::length; ++bit) {
        Bytes bytes = good_section();
        bytes[bit / 8U] = static_cast<std::uint8_t>(bytes[bit / 8U] ^ (1U << (bit % 8U)));
        ASSERT_NE(refusal_of(bytes), ParametersRefusal::none) << "byte " << bit / 8U << ", bit " << bit % 8U;
    }
}

TEST(ParameterSection, ADamagedValueIsRefusedForTheChecksum) {
    Bytes bytes = good_section();
    bytes[section::values_at + 9U] ^= 0x10U;
    EXPECT_EQ(refusal_of(bytes), ParametersRefusal::checksum);
}

// Memory of exactly that size, so that a sanitizer sees a read beyond it.
TEST(ParameterSection, IsNotReadBeyondItsMemoryAndRefusedWhereThatEndsTooEarly) {
    const Bytes whole = good_section();
    for (std::size_t length = 0U; length < section::length; ++length) {
        const Bytes part{whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length)};
        ASSERT_EQ(refusal_of(part), length < 4U ? ParametersRefusal::missing : ParametersRefusal::length)
            << length;
    }
}

TEST(ParameterSection, ASectionRefusedForItsFormIsNotAcceptedAndNamesNoField) {
    Bytes bytes = good_section();
    bytes[section::checksum_at] ^= 1U;
    const rsi::application::ParameterSectionAnswer answer = read(bytes, bytes.size());
    EXPECT_EQ(answer.refusal, ParametersRefusal::checksum);
    EXPECT_EQ(answer.validation.accepted, 0);
    EXPECT_STREQ(answer.validation.field, "");
    EXPECT_STREQ(answer.validation.reason, "");
}

TEST(ParameterSection, ErasedMemoryIsAMissingSection) {
    EXPECT_EQ(refusal_of(Bytes(4096U, std::uint8_t{0xFFU})), ParametersRefusal::missing);
    EXPECT_EQ(refusal_of(Bytes(4096U, std::uint8_t{0U})), ParametersRefusal::missing);
    rsi::Parameters parameters{};
    EXPECT_EQ(rsi::application::read_parameter_section(nullptr, 0U, parameters).refusal,
              ParametersRefusal::missing);
}

TEST(ParameterSection, AnotherFormatOrLayoutOrLengthIsRefusedAsSuchThoughTheChecksumIsGood) {
    for (const std::uint32_t version : {0U, 2U, 0xFFFFU}) {
        Bytes bytes = good_section();
        write(bytes, section::version_at, version, 2U);
        EXPECT_EQ(refusal_of(sealed(bytes)), ParametersRefusal::version) << version;
    }
    Bytes bytes = good_section();
    write(bytes, section::count_at, section::value_count - 1U, 2U);
    EXPECT_EQ(refusal_of(sealed(bytes)), ParametersRefusal::layout);
    bytes = good_section();
    write(bytes, section::layout_at, section::layout ^ 1U);
    EXPECT_EQ(refusal_of(sealed(bytes)), ParametersRefusal::layout);
    for (const std::size_t length : {std::size_t{0U}, section::length - 4U, section::length + 4U}) {
        bytes = good_section();
        write(bytes, section::length_at, static_cast<std::uint32_t>(length));
        EXPECT_EQ(refusal_of(sealed(bytes)), ParametersRefusal::length) << length;
    }
}

TEST(ParameterSection, AnyWrongByteOfTheHeaderIsRefusedForWhatItBelongsTo) {
    struct Field {
        std::size_t at;
        std::size_t length;
        ParametersRefusal refusal;
    };
    for (const Field& field : {Field{0U, 4U, ParametersRefusal::missing},
                               Field{section::version_at, 2U, ParametersRefusal::version},
                               Field{section::count_at, 2U, ParametersRefusal::layout},
                               Field{section::layout_at, 4U, ParametersRefusal::layout},
                               Field{section::length_at, 4U, ParametersRefusal::length}}) {
        for (std::size_t byte = field.at; byte < field.at + field.length; ++byte) {
            Bytes bytes = good_section();
            bytes[byte] ^= 0x01U;
            EXPECT_EQ(refusal_of(sealed(bytes)), field.refusal) << "byte " << byte;
        }
    }
}

// The committed sections and every flashed one are of this layout. A change of rsi_parameters makes them
// useless, which must be meant: then this number changes, too, and generate_parameter_sections has to run.
TEST(ParameterSection, TheLayoutIsTheOneThatWasFlashed) {
    EXPECT_EQ(section::layout, 0xD0AA'4D68U);
    EXPECT_EQ(section::length, 348U);
    EXPECT_EQ(section::layout_of_values(), section::layout);
}

// The text that the layout's checksum is of, put together in another way.
TEST(ParameterSection, TheLayoutIsTheChecksumOfEveryNameAndTheFirstChoices) {
    std::string text;
    for (const rsi::ParameterField& field : rsi::parameter_fields) {
        text += std::string{field.name} + '\n';
    }
    for (const rsi::SelectionField& field : rsi::selection_fields) {
        text += std::string{field.name} + ':';
        ASSERT_LE(field.choices_in_layout, field.choice_count);
        for (std::int32_t choice = 0; choice < field.choices_in_layout; ++choice) {
            text += std::string{field.choices[choice]} + ',';
        }
    }
    const Bytes bytes{text.begin(), text.end()};
    EXPECT_EQ(section::layout_of_values(), rsi::application::crc32(bytes.data(), bytes.size()));
}

TEST(ParameterSection, EachValueOutsideItsRangeIsRefusedByItsName) {
    std::size_t index = 0U;
    for (const rsi::ParameterField& field : rsi::parameter_fields) {
        for (const float bad : {field.minimum - 1.0F - 0.01F * field.maximum,
                                field.maximum + 1.0F + 0.01F * field.maximum, rsi::can_dbc::not_available}) {
            const Bytes bytes = with_value(index, bad);
            const rsi::application::ParameterSectionAnswer answer = read(bytes, bytes.size());
            EXPECT_EQ(answer.refusal, ParametersRefusal::value) << field.name;
            EXPECT_STREQ(answer.validation.field, field.name);
            EXPECT_STRNE(answer.validation.reason, "");
        }
        ++index;
    }
    for (const rsi::SelectionField& field : rsi::selection_fields) {
        Bytes bytes = good_section();
        write(bytes, section::values_at + 4U * index, 0xFFFF'FFFFU);
        const rsi::application::ParameterSectionAnswer answer = read(sealed(bytes), bytes.size());
        EXPECT_EQ(answer.refusal, ParametersRefusal::value) << field.name;
        EXPECT_STREQ(answer.validation.field, field.name);
        ++index;
    }
}

TEST(TheEcu, StartedWithAGoodSectionBecomesReadyAndSaysNothingOfItsParameters) {
    Bench bench;
    EXPECT_EQ(bench.start_with(good_section()).refusal, ParametersRefusal::none);
    bench.run_until_ready();
    EXPECT_EQ(bench.state(), rsi::can_dbc::RolloverWarning::State::ready);
    EXPECT_FALSE(bench.status().parameters_invalid);
    EXPECT_EQ(bench.last().warning.value.parameters_refusal,
              rsi::can_dbc::RolloverWarning::ParametersRefusal::none);
}

struct Refused {
    rsi::can_dbc::RolloverWarning::ParametersRefusal sent;
    Bytes section;
};

std::vector<Refused> refused_sections() {
    using Sent = rsi::can_dbc::RolloverWarning::ParametersRefusal;
    Bytes version = good_section();
    write(version, section::version_at, 2U, 2U);
    Bytes layout = good_section();
    write(layout, section::layout_at, 0U);
    Bytes damaged = good_section();
    damaged[section::values_at] ^= 1U;
    const Bytes whole = good_section();
    return {{Sent::missing, Bytes(section::length, std::uint8_t{0xFFU})},
            {Sent::version, sealed(version)},
            {Sent::layout, sealed(layout)},
            {Sent::length, Bytes(whole.begin(), whole.end() - 1)},
            {Sent::checksum, damaged},
            {Sent::value, with_value(0U, -1.0F)}};
}

// Also when it has run with good ones before: nothing of them is left.
TEST(TheEcu, StartedWithARefusedSectionStaysUnavailableAndSaysWhyInEachCycle) {
    for (const Refused& refused : refused_sections()) {
        const char* const name = rsi::can_dbc::RolloverWarning::name_of(refused.sent);
        Bench bench;
        bench.run_until_ready();
        ASSERT_EQ(bench.state(), rsi::can_dbc::RolloverWarning::State::ready);
        EXPECT_EQ(static_cast<int>(bench.start_with(refused.section).refusal),
                  static_cast<int>(refused.sent));
        const std::size_t from = bench.cycles().size();
        bench.run_for(1.0);
        for (std::size_t index = from; index < bench.cycles().size(); ++index) {
            const Cycle& cycle = bench.cycles()[index];
            ASSERT_EQ(cycle.frames.size(), frames_per_cycle) << name;
            ASSERT_EQ(cycle.state(), rsi::can_dbc::RolloverWarning::State::unavailable) << name;
            ASSERT_EQ(cycle.warning.value.parameters_refusal, refused.sent) << name;
            ASSERT_TRUE(cycle.status.value.parameters_invalid) << name;
        }
    }
}

// Its monitoring knows the roll stiffness of the section, not that of before: an accelerometer that is too
// high by little more than it takes is found by the roll angle that the suspension takes under the true
// force.
TEST(TheEcu, StartedWithASectionMonitorsTheVehicleOfThatSection) {
    rsi::Parameters stiffer = large_suv();
    stiffer.roll_stiffness_nmprad *= 2.0F;
    Bench bench{stiffer};
    ASSERT_EQ(bench.parameters_answer().accepted, 1);
    ASSERT_EQ(bench.start_with(good_section()).refusal, ParametersRefusal::none);
    RollPlaneVehicle vehicle{large_suv()};
    bench.drive([&vehicle](double time_s) {
        vehicle.advance(std::min(4.0, 4.0 * time_s));
        Motion motion = vehicle.motion();
        motion.imu.lateral_acceleration_mps2 += (time_s < 3.0) ? 0.0F : 3.3F;
        return motion;
    });
    using Code = rsi::can_dbc::RolloverDiagnosis::Code;
    bench.run_for(3.0);
    ASSERT_EQ(bench.last().diagnosis.value.code, Code::none);
    bench.run_for(2.0);
    EXPECT_EQ(bench.last().diagnosis.value.code, Code::lateral_acceleration_contradicts_yaw_rate);
    EXPECT_EQ(bench.state(), rsi::can_dbc::RolloverWarning::State::unavailable);
}

}  // namespace
}  // namespace testing_application
