// The key store in software, and the random numbers of the kernel.
#include "hal/software_keys/software_keys.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "hal/linux/system_random.hpp"
#include "hal/software_keys/cmac.hpp"

namespace testing_software_keys {
namespace {

std::vector<std::uint8_t> bytes_of(const std::string& hex) {
    std::vector<std::uint8_t> bytes;
    for (std::size_t at = 0U; at < hex.size(); at += 2U) {
        bytes.push_back(static_cast<std::uint8_t>(std::stoul(hex.substr(at, 2U), nullptr, 16)));
    }
    return bytes;
}

template <typename Array>
Array array_of(const std::string& hex) {
    Array array{};
    const std::vector<std::uint8_t> bytes = bytes_of(hex);
    EXPECT_EQ(bytes.size(), array.size());
    std::copy(bytes.begin(), bytes.end(), array.begin());
    return array;
}

// RFC 4493, section 4.
const std::string message =
    "6bc1bee22e409f96e93d7e117393172aae2d8a571e03ac9c9eb76fac45af8e51"
    "30c81c46a35ce411e5fbc1191a0a52eff69f2445df4f9b17ad2b417be66c3710";

TEST(Cmac, GivesTheAnswersOfRfc4493) {
    const auto key = array_of<rsi::hal::Key>("2b7e151628aed2a6abf7158809cf4f3c");
    const std::vector<std::pair<std::size_t, std::string>> examples{
        {0U, "bb1d6929e95937287fa37d129b756746"},
        {16U, "070a16b46b4d4144f79bdd9dd04a287c"},
        {40U, "dfa66747de9ae63030ca32611497c827"},
        {64U, "51f0bebf7e3b9d92fc49741779363cfe"}};
    for (const auto& [length, expected] : examples) {
        rsi::hal::AuthenticationCode code{};
        // Memory of exactly that size, so that a sanitizer sees a read beyond it.
        const std::vector<std::uint8_t> bytes = bytes_of(message.substr(0U, 2U * length));
        ASSERT_TRUE(rsi::hal::cmac(key, bytes.data(), bytes.size(), code));
        EXPECT_EQ(code, array_of<rsi::hal::AuthenticationCode>(expected)) << length;
    }
}

TEST(Cmac, IsAnotherForEachLengthAndKey) {
    const std::vector<std::uint8_t> bytes(50U, std::uint8_t{0x80U});
    std::set<rsi::hal::AuthenticationCode> codes;
    for (const rsi::hal::Key& key : rsi::hal::test_keys) {
        for (std::size_t length = 0U; length <= bytes.size(); ++length) {
            rsi::hal::AuthenticationCode code{};
            ASSERT_TRUE(rsi::hal::cmac(key, bytes.data(), length, code));
            codes.insert(code);
        }
    }
    EXPECT_EQ(codes.size(), 3U * 51U);
}

TEST(SoftwareKeys, UseTheKeyOfTheSlot) {
    rsi::hal::SoftwareKeys keys{rsi::hal::test_keys};
    const std::vector<std::uint8_t> bytes{1U, 2U, 3U};
    for (std::size_t slot = 0U; slot < rsi::hal::key_slots; ++slot) {
        rsi::hal::AuthenticationCode code{};
        rsi::hal::AuthenticationCode expected{};
        ASSERT_TRUE(
            keys.authenticate(static_cast<rsi::hal::KeySlot>(slot), bytes.data(), bytes.size(), code));
        ASSERT_TRUE(rsi::hal::cmac(rsi::hal::test_keys[slot], bytes.data(), bytes.size(), expected));
        EXPECT_EQ(code, expected);
    }
    rsi::hal::AuthenticationCode code{};
    EXPECT_FALSE(keys.authenticate(static_cast<rsi::hal::KeySlot>(rsi::hal::key_slots), bytes.data(),
                                   bytes.size(), code));
    EXPECT_EQ(code, rsi::hal::AuthenticationCode{});
}

TEST(SoftwareKeys, AreTestKeysWhenAnyOfThemIs) {
    const rsi::hal::Keys own{{{1U}, {2U}, {3U}}};
    EXPECT_FALSE(rsi::hal::SoftwareKeys{own}.has_test_keys());
    EXPECT_TRUE(rsi::hal::SoftwareKeys{rsi::hal::test_keys}.has_test_keys());
    for (std::size_t slot = 0U; slot < rsi::hal::key_slots; ++slot) {
        for (const rsi::hal::Key& test_key : rsi::hal::test_keys) {
            rsi::hal::Keys mixed = own;
            mixed[slot] = test_key;
            EXPECT_TRUE(rsi::hal::SoftwareKeys{mixed}.has_test_keys());
        }
    }
}

TEST(SystemRandom, GivesOtherNumbersEachTime) {
    rsi::hal::SystemRandom random;
    std::set<std::vector<std::uint8_t>> seen;
    for (int call = 0; call < 100; ++call) {
        std::vector<std::uint8_t> bytes(16U);
        ASSERT_TRUE(random.fill(bytes.data(), bytes.size()));
        seen.insert(bytes);
    }
    EXPECT_EQ(seen.size(), 100U);
}

}  // namespace
}  // namespace testing_software_keys
