// A parameter section is taken from any holder of the key, and never an older one than before.
#include "rsi/ecu/application/section_authority.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <optional>
#include <vector>

#include "hal/software_keys/software_keys.hpp"
#include "rsi/ecu/access/stored_count.hpp"
#include "rsi/ecu/application/little_endian.hpp"
#include "tests/access/cut_storage.hpp"
#include "tests/application/bench.hpp"

extern "C" const unsigned char rsi_parameter_section[rsi::application::section::length];

namespace testing_application {
namespace {

using rsi::application::ParametersRefusal;
using rsi::application::SealFault;
using rsi::application::SectionAuthority;
using rsi_test::CutStorage;
namespace section = rsi::application::section;
namespace seal = rsi::application::seal;
using Bytes = std::vector<std::uint8_t>;

constexpr rsi::hal::Keys own_keys{{{1U, 2U}, {3U, 4U}, {5U, 6U, 7U}}};

Bytes sealed_section(std::uint32_t version, const rsi::hal::Keys& keys = own_keys) {
    Bytes bytes{rsi_parameter_section, rsi_parameter_section + section::length};
    bytes.resize(seal::sealed_length);
    rsi::hal::SoftwareKeys store{keys};
    EXPECT_TRUE(rsi::application::seal_section(store, version, bytes.data()));
    return bytes;
}

void flip(Bytes& bytes, std::size_t bit) {
    bytes[bit / 8U] = static_cast<std::uint8_t>(bytes[bit / 8U] ^ (1U << (bit % 8U)));
}

// With the check sum that belongs to what is in it now: what an attacker can make without the key.
void repair_checksum(Bytes& bytes) {
    rsi::application::put_u32(bytes.data(), section::checksum_at,
                              rsi::application::crc32(bytes.data(), section::checksum_at));
}

class SilentKeys final : public rsi::hal::KeyStore {
 public:
    bool authenticate(rsi::hal::KeySlot, const std::uint8_t*, std::size_t,
                      rsi::hal::AuthenticationCode& code) noexcept override {
        code.fill(0U);
        return false;
    }
    bool has_test_keys() const noexcept override { return false; }
};

class ASectionAuthority : public ::testing::Test {
 protected:
    ASectionAuthority() { restart(); }

    void restart() {
        authority_.emplace(keys_, storage_);
        authority_->start();
    }
    // The answer; a refusal must leave every byte of the parameters as it was.
    ParametersRefusal refusal_of(const Bytes& bytes) {
        rsi::Parameters parameters{};
        std::memset(&parameters, 0x5A, sizeof parameters);
        const rsi::Parameters before = parameters;
        const rsi::application::ParameterSectionAnswer answer =
            rsi::application::read_parameter_section(bytes.data(), bytes.size(), *authority_, parameters);
        const bool refused = answer.refusal != ParametersRefusal::none;
        EXPECT_EQ(std::memcmp(&parameters, &before, sizeof parameters) == 0, refused);
        EXPECT_EQ(answer.validation.accepted, refused ? 0 : 1);
        return answer.refusal;
    }
    SealFault check(const Bytes& bytes) { return authority_->check(bytes.data(), bytes.size()); }
    bool raise(std::uint32_t version) {
        const Bytes bytes = sealed_section(version);
        return authority_->raise(bytes.data());
    }

    CutStorage storage_;
    rsi::hal::SoftwareKeys keys_{own_keys};
    std::optional<SectionAuthority> authority_;
};

TEST_F(ASectionAuthority, TakesASectionWithTheSealOfItsKey) {
    const Bytes bytes = sealed_section(7U);
    EXPECT_EQ(check(bytes), SealFault::none);
    EXPECT_EQ(refusal_of(bytes), ParametersRefusal::none);
    EXPECT_EQ(storage_.writes(), 0);  // looking at it raises nothing
}

TEST_F(ASectionAuthority, FindsTheSealWhereThePageSaysItIs) {
    const Bytes bytes = sealed_section(0x04030201U);
    ASSERT_EQ(bytes.size(), 372U);
    const Bytes head{bytes.begin() + 348, bytes.begin() + 356};
    EXPECT_EQ(head, (Bytes{'R', 'S', 'I', 'A', 1U, 2U, 3U, 4U}));
    rsi::hal::AuthenticationCode code{};
    ASSERT_TRUE(rsi::hal::cmac(own_keys[2], bytes.data(), 356U, code));
    EXPECT_TRUE(std::equal(code.begin(), code.end(), bytes.begin() + 356));
}

// A firmware without authority.
TEST_F(ASectionAuthority, IsNotNeededToReadASealedSection) {
    rsi::Parameters parameters{};
    const Bytes bytes = sealed_section(1U);
    EXPECT_EQ(rsi::application::read_parameter_section(bytes.data(), bytes.size(), parameters).refusal,
              ParametersRefusal::none);
}

TEST_F(ASectionAuthority, RefusesEveryFlippedBit) {
    for (std::size_t bit = 0U; bit < 8U * seal::sealed_length; ++bit) {
        Bytes bytes = sealed_section(7U);
        flip(bytes, bit);
        const ParametersRefusal refusal = refusal_of(bytes);
        ASSERT_NE(refusal, ParametersRefusal::none) << bit;
        if (bit >= 8U * section::length) {
            ASSERT_EQ(refusal, ParametersRefusal::unauthentic) << bit;
        }
    }
}

// In the values, where another number would be taken if it had the right check sum.
TEST_F(ASectionAuthority, RefusesEveryFlippedBitAlsoWithARepairedChecksum) {
    std::size_t forged = 0U;
    for (std::size_t bit = 8U * section::name_at; bit < 8U * section::checksum_at; ++bit) {
        Bytes bytes = sealed_section(7U);
        flip(bytes, bit);
        repair_checksum(bytes);
        const ParametersRefusal refusal = refusal_of(bytes);
        ASSERT_NE(refusal, ParametersRefusal::none) << bit;
        ASSERT_EQ(check(bytes), SealFault::forged) << bit;
        forged += refusal == ParametersRefusal::unauthentic ? 1U : 0U;
    }
    EXPECT_GT(forged, 1000U);  // the others are values out of range
}

TEST_F(ASectionAuthority, RefusesTheSealOfAnotherKey) {
    for (std::size_t bit = 0U; bit < 128U; ++bit) {
        rsi::hal::Keys others = own_keys;
        others[2][bit / 8U] = static_cast<std::uint8_t>(others[2][bit / 8U] ^ (1U << (bit % 8U)));
        EXPECT_EQ(check(sealed_section(7U, others)), SealFault::forged) << bit;
    }
    rsi::hal::Keys swapped = own_keys;
    std::swap(swapped[1], swapped[2]);
    EXPECT_EQ(check(sealed_section(7U, swapped)), SealFault::forged);
    EXPECT_EQ(refusal_of(sealed_section(7U, rsi::hal::test_keys)), ParametersRefusal::unauthentic);
}

// Memory of exactly that size, so that a sanitizer sees a read beyond it.
TEST_F(ASectionAuthority, RefusesASectionWithoutASealOrWithPartOfOne) {
    const Bytes whole = sealed_section(7U);
    for (std::size_t length = section::length; length < seal::sealed_length; ++length) {
        const Bytes part{whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length)};
        ASSERT_EQ(check(part), SealFault::missing) << length;
        ASSERT_EQ(refusal_of(part), ParametersRefusal::unauthentic) << length;
    }
    Bytes erased_behind{rsi_parameter_section, rsi_parameter_section + section::length};
    erased_behind.resize(4096U, std::uint8_t{0xFFU});
    EXPECT_EQ(check(erased_behind), SealFault::missing);
    for (std::size_t byte = 0U; byte < seal::magic.size(); ++byte) {
        Bytes bytes = whole;
        bytes[seal::magic_at + byte] ^= 1U;
        EXPECT_EQ(check(bytes), SealFault::missing) << byte;
    }
    EXPECT_EQ(refusal_of(erased_behind), ParametersRefusal::unauthentic);
}

TEST_F(ASectionAuthority, SaysFirstWhatElseIsWrong) {
    Bytes bytes = sealed_section(7U);
    bytes[section::values_at] ^= 1U;
    EXPECT_EQ(refusal_of(bytes), ParametersRefusal::checksum);
    EXPECT_EQ(refusal_of(Bytes(seal::sealed_length, std::uint8_t{0xFFU})), ParametersRefusal::missing);
}

TEST_F(ASectionAuthority, RefusesAllWhenTheKeyStoreDoesNotAnswer) {
    SilentKeys silent;
    SectionAuthority authority{silent, storage_};
    authority.start();
    Bytes bytes = sealed_section(7U);
    std::fill(bytes.begin() + seal::code_at, bytes.end(), std::uint8_t{0U});  // the result of a silent store
    EXPECT_EQ(authority.check(bytes.data(), bytes.size()), SealFault::forged);
    EXPECT_FALSE(rsi::application::seal_section(silent, 7U, bytes.data()));
    EXPECT_EQ(check(bytes), SealFault::missing);
    EXPECT_EQ(rsi::application::u32_at(bytes.data(), seal::magic_at), 0U);
}

TEST_F(ASectionAuthority, IsStartedAnewWithNothingOfBefore) {
    EXPECT_TRUE(raise(7U));
    storage_.record().clear();  // another memory
    authority_->start();
    EXPECT_EQ(authority_->version(), 0U);
}

TEST_F(ASectionAuthority, NeverGoesBackToAnOlderVersion) {
    EXPECT_EQ(authority_->version(), 0U);
    EXPECT_TRUE(raise(7U));
    for (const bool after_a_restart : {false, true}) {
        if (after_a_restart) {
            restart();
        }
        EXPECT_EQ(authority_->version(), 7U);
        for (const std::uint32_t older : {0U, 1U, 6U}) {
            EXPECT_EQ(check(sealed_section(older)), SealFault::outdated) << older;
            EXPECT_EQ(refusal_of(sealed_section(older)), ParametersRefusal::unauthentic) << older;
        }
        for (const std::uint32_t newer : {7U, 8U, 0xFFFFFFFFU}) {
            EXPECT_EQ(check(sealed_section(newer)), SealFault::none) << newer;
        }
    }
}

TEST_F(ASectionAuthority, StoresAVersionOnce) {
    EXPECT_TRUE(raise(7U));
    EXPECT_TRUE(raise(7U));
    EXPECT_EQ(storage_.writes(), 1);
    EXPECT_TRUE(raise(9U));
    EXPECT_EQ(storage_.writes(), 2);
}

TEST_F(ASectionAuthority, StaysWhereItWasWhenTheStorageDoesNotTakeTheVersion) {
    EXPECT_TRUE(raise(7U));
    storage_.refuse(true);
    EXPECT_FALSE(raise(9U));
    EXPECT_EQ(authority_->version(), 7U);
    EXPECT_EQ(check(sealed_section(8U)), SealFault::none);
}

// After any part of the write, a version that was stored before stays the least.
TEST_F(ASectionAuthority, NeverGoesBackWhenThePowerGoesAtAnyByteOfTheWrite) {
    for (std::size_t bytes = 0U; bytes <= rsi::access::stored_count_length; ++bytes) {
        storage_.cut_power_at({0, 0U});
        storage_.record().clear();
        restart();
        ASSERT_TRUE(raise(0x0607U));
        storage_.cut_power_at({1, bytes});
        raise(0x1908U);
        ASSERT_FALSE(storage_.has_power());
        restart();
        ASSERT_NE(check(sealed_section(0x0606U)), SealFault::none) << bytes;
        const SealFault newest = check(sealed_section(0x1908U));
        ASSERT_EQ(newest == SealFault::none || newest == SealFault::version_lost, true) << bytes;
    }
}

TEST_F(ASectionAuthority, RefusesAllWhenItsRecordIsDamaged) {
    EXPECT_TRUE(raise(7U));
    storage_.record()[4] ^= 1U;
    restart();
    EXPECT_EQ(check(sealed_section(0xFFFFFFFFU)), SealFault::version_lost);
    EXPECT_EQ(refusal_of(sealed_section(0xFFFFFFFFU)), ParametersRefusal::unauthentic);
}

TEST_F(ASectionAuthority, RefusesAllWhenItsRecordCannotBeRead) {
    EXPECT_TRUE(raise(7U));
    storage_.record().pop_back();
    restart();
    EXPECT_EQ(check(sealed_section(0xFFFFFFFFU)), SealFault::version_lost);
}

TEST_F(ASectionAuthority, RefusesAllBeforeItsStart) {
    SectionAuthority fresh{keys_, storage_};
    const Bytes bytes = sealed_section(7U);
    EXPECT_EQ(fresh.check(bytes.data(), bytes.size()), SealFault::version_lost);
}

rsi::can_dbc::RollObserver::Protection protection_of(const Cycle& cycle) {
    for (const rsi::hal::CanFrame& frame : cycle.frames) {
        if (frame.identifier == rsi::can_dbc::RollObserver::identifier) {
            return rsi::can_dbc::decode<rsi::can_dbc::RollObserver>(frame.data).value.protection;
        }
    }
    ADD_FAILURE() << "no RollObserver";
    return {};
}

using Sent = rsi::can_dbc::RolloverWarning::ParametersRefusal;
using SentProtection = rsi::can_dbc::RollObserver::Protection;

TEST_F(ASectionAuthority, LetsTheEcuRunOnASealedSectionAndRaisesTheVersion) {
    Bench bench;
    EXPECT_EQ(bench.start_with(sealed_section(7U), *authority_).refusal, ParametersRefusal::none);
    EXPECT_EQ(authority_->version(), 7U);
    bench.run_until_ready();
    EXPECT_EQ(bench.state(), rsi::can_dbc::RolloverWarning::State::ready);
    EXPECT_EQ(bench.last().warning.value.parameters_refusal, Sent::none);
    EXPECT_EQ(protection_of(bench.last()), SentProtection::sealed);
}

// Also when it has run with good ones before: nothing of them is left.
TEST_F(ASectionAuthority, KeepsTheEcuUnavailableOnAnyOtherAndTheBusIsTold) {
    ASSERT_TRUE(raise(7U));
    Bytes changed = sealed_section(7U);
    changed[section::name_at] ^= 1U;
    repair_checksum(changed);
    const Bytes unsealed{rsi_parameter_section, rsi_parameter_section + section::length};
    for (const Bytes& bytes :
         {changed, unsealed, sealed_section(6U), sealed_section(8U, rsi::hal::test_keys)}) {
        Bench bench;
        bench.run_until_ready();
        ASSERT_EQ(bench.state(), rsi::can_dbc::RolloverWarning::State::ready);
        EXPECT_EQ(bench.start_with(bytes, *authority_).refusal, ParametersRefusal::unauthentic);
        EXPECT_EQ(authority_->version(), 7U);
        const std::size_t from = bench.cycles().size();
        bench.run_for(1.0);
        for (std::size_t index = from; index < bench.cycles().size(); ++index) {
            const Cycle& cycle = bench.cycles()[index];
            ASSERT_EQ(cycle.state(), rsi::can_dbc::RolloverWarning::State::unavailable);
            ASSERT_EQ(cycle.warning.value.parameters_refusal, Sent::unauthentic);
            ASSERT_TRUE(cycle.status.value.parameters_invalid);
            ASSERT_EQ(protection_of(cycle), SentProtection::sealed);
        }
        EXPECT_EQ(bench.last().diagnosis.value.code,
                  rsi::can_dbc::RolloverDiagnosis::Code::parameters_refused);
    }
}

TEST_F(ASectionAuthority, HasTheBusToldOfTestKeysAndOfSectionsThatNeedNoSeal) {
    const auto reported_by = [](Bench& bench) {
        bench.run_cycles(1);
        return protection_of(bench.last());
    };
    const Bytes unsealed{rsi_parameter_section, rsi_parameter_section + section::length};
    rsi::hal::SoftwareKeys everybodys{rsi::hal::test_keys};
    {
        Bench bench;
        EXPECT_EQ(reported_by(bench), SentProtection::unsealed);
        bench.start_with(unsealed);
        EXPECT_EQ(reported_by(bench), SentProtection::unsealed);
        bench.report_test_keys(keys_);
        bench.start_with(unsealed);
        EXPECT_EQ(reported_by(bench), SentProtection::unsealed);
        bench.report_test_keys(everybodys);
        bench.start_with(unsealed);
        EXPECT_EQ(reported_by(bench), SentProtection::unsealed_test_keys);
        bench.start_with(large_suv());
        EXPECT_EQ(reported_by(bench), SentProtection::unsealed_test_keys);
    }
    Bench bench;
    SectionAuthority authority{everybodys, storage_};
    authority.start();
    EXPECT_EQ(bench.start_with(sealed_section(1U, rsi::hal::test_keys), authority).refusal,
              ParametersRefusal::none);
    EXPECT_EQ(reported_by(bench), SentProtection::sealed_test_keys);
    bench.start_with(large_suv());
    EXPECT_EQ(reported_by(bench), SentProtection::unsealed);
}

}  // namespace
}  // namespace testing_application
