// Bits that change in the ECU's memory: the study draws all of it, by its seed alone, and counts every flip
// once.
#include "sil/studies/faults/memory_flips.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "rsi/ecu/application/rollover_ecu.hpp"
#include "sil/files/calibration_file.hpp"
#include "sil/world/vehicle/parameter_file.hpp"

namespace {

const std::string source = RSI_SOURCE_DIR;

sil::MemoryFlips run(std::size_t count, std::uint64_t seed) {
    return sil::run_memory_flips(sil::load_vehicle(source + "/sil/vehicles/large_suv.toml"),
                                 sil::load_calibration(source + "/firmware/calibrations/large_suv.toml"),
                                 count, seed);
}

TEST(TheMemoryMap, CoversTheEcuWithoutAGap) {
    std::size_t end = 0U;
    for (const sil::MemoryPart& part : sil::memory_map()) {
        EXPECT_EQ(part.begin, end) << part.name;
        EXPECT_GT(part.length, 0U) << part.name;
        end = part.begin + part.length;
    }
    EXPECT_EQ(end, sizeof(rsi::application::RolloverEcu));
}

TEST(TheMemoryMap, HasTheComponentsParametersWhereTheEcuHasThem) {
    const std::vector<sil::MemoryPart> parts = sil::memory_map();
    const auto parameters = std::find_if(parts.begin(), parts.end(), [](const sil::MemoryPart& part) {
        return std::string{part.name} == "parameters";
    });
    ASSERT_NE(parameters, parts.end());
    EXPECT_EQ(parameters->length / 8U, (sizeof(rsi::Parameters) + 7U) / 8U);  // and what aligns the next
    const sil::MemoryPart component = sil::component_memory();
    EXPECT_EQ(component.begin + component.length, parameters->begin);
}

class TheStudyOfFlips : public ::testing::Test {
 protected:
    static void SetUpTestSuite() { result = run(1500U, 7U); }
    static sil::MemoryFlips result;
};
sil::MemoryFlips TheStudyOfFlips::result{};

TEST_F(TheStudyOfFlips, CountsEachFlipInOnePartAndLeavesAddressesOut) {
    std::size_t sum = 0U;
    for (const sil::MemoryPart& part : result.parts) {
        const std::size_t in_part = sil::total(sil::count_flips(result, part));
        EXPECT_TRUE(!part.is_address || in_part == 0U) << part.name;
        sum += in_part;
    }
    EXPECT_EQ(sum, 1500U);
    EXPECT_EQ(sil::total(sil::count_flips(result)), 1500U);
    const std::size_t in_component = sil::total(sil::count_component_flips(result));
    EXPECT_GT(in_component, 200U);  // nearly a quarter of the memory
    EXPECT_LT(in_component, 500U);
}

TEST_F(TheStudyOfFlips, IsTheSameOfTheSameSeed) {
    const sil::MemoryFlips again = run(100U, 7U);
    const sil::MemoryFlips other = run(100U, 8U);
    std::size_t equal = 0U;
    for (std::size_t number = 0U; number < 100U; ++number) {
        const sil::Flip& flip = again.flips[number];
        EXPECT_EQ(flip.byte, result.flips[number].byte);
        EXPECT_EQ(flip.effect, result.flips[number].effect);
        equal += (flip.byte == other.flips[number].byte && flip.cycle == other.flips[number].cycle) ? 1U : 0U;
    }
    EXPECT_LT(equal, 10U);
}

TEST_F(TheStudyOfFlips, SeesFlipsWithoutAnEffectAndSomeThatAreTold) {
    const sil::FlipCount count = sil::count_flips(result);
    EXPECT_GT(count[static_cast<std::size_t>(sil::FlipEffect::none)], 750U);
    EXPECT_GT(count[static_cast<std::size_t>(sil::FlipEffect::told)],
              20U);  // parameters, what is received, counters
}

// The warning stays as it is; what differs is the code that says so.
TEST_F(TheStudyOfFlips, FindsEveryFlipOfTheComponentRestored) {
    const sil::FlipCount count = sil::count_component_flips(result);
    EXPECT_EQ(count[static_cast<std::size_t>(sil::FlipEffect::in_time)], sil::total(count));
}

TEST_F(TheStudyOfFlips, NamesThePlaceOfEachSilentFlip) {
    sil::MemoryFlips one = result;
    one.flips = {sil::Flip{1U, 250U, sil::component_memory().begin + 5U, 3U, sil::FlipEffect::late}};
    EXPECT_EQ(sil::silent_flips(one),
              "late: byte 1 of component: derived numbers, bit 3, before 2.50 s of the fishhook\n");
    EXPECT_EQ(sil::silent(sil::count_flips(one)), 1U);
    EXPECT_NE(sil::memory_flips_table(one).find("1000.00"), std::string::npos);
}

}  // namespace
