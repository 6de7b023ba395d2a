// Download of a parameter section: whole and good, or all is as it was.
#include "rsi/ecu/diagnosis/section_download.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/diagnosis/tester.hpp"

extern "C" const unsigned char rsi_parameter_section[rsi::application::section::length];

namespace testing_diagnosis {
namespace {

using rsi::application::ParametersRefusal;

constexpr std::size_t section_length = rsi::application::section::length;

Bytes good_section() {
    return {rsi_parameter_section, rsi_parameter_section + section_length};
}

class Download : public ::testing::Test {
 protected:
    Download() { tester_.unlock(0x02U); }

    Bytes ask(const Bytes& request) { return tester_.ask(request); }
    Bytes request_download(std::size_t size = section_length) {
        return ask({0x34U, 0x00U, 0x24U, 0U, 0U, 0U, 0U, static_cast<std::uint8_t>(size >> 8U),
                    static_cast<std::uint8_t>(size & 0xFFU)});
    }
    Bytes block(unsigned number, const Bytes& data) {
        return ask(Bytes{0x36U, static_cast<std::uint8_t>(number)} + data);
    }
    // All of it in blocks of that many bytes, to the end.
    void transfer(const Bytes& section, std::size_t size = 128U) {
        ASSERT_EQ(request_download(), (Bytes{0x74U, 0x20U, 0x00U, 0x82U}));
        unsigned number = 1U;
        for (std::size_t at = 0U; at < section.size(); at += size) {
            const std::size_t end = std::min(at + size, section.size());
            const Bytes answer = block(number, Bytes(section.begin() + static_cast<std::ptrdiff_t>(at),
                                                     section.begin() + static_cast<std::ptrdiff_t>(end)));
            ASSERT_EQ(answer, (Bytes{0x76U, static_cast<std::uint8_t>(number & 0xFFU)}));
            ++number;
        }
        ASSERT_EQ(ask({0x37U}), (Bytes{0x77U}));
    }
    Bytes check() { return ask({0x31U, 0x01U, 0xFFU, 0x01U}); }
    static Bytes result(rsi::application::ParametersRefusal refusal) {
        return {0x71U, 0x01U, 0xFFU, 0x01U, static_cast<std::uint8_t>(refusal)};
    }
    // As the next start finds it; empty: nothing.
    Bytes stored() {
        rsi::application::SectionRecord record{memories_.section_one, memories_.section_other};
        rsi::application::SectionBytes bytes{};
        record.read(bytes);
        const bool is_there = (bytes != rsi::application::SectionBytes{});
        return is_there ? Bytes(bytes.begin(), bytes.begin() + section_length) : Bytes{};
    }
    void forget() {
        memories_.section_one.record().clear();
        memories_.section_other.record().clear();
    }
    void refuse(bool refuses) {
        memories_.section_one.refuse(refuses);
        memories_.section_other.refuse(refuses);
    }

    void begin_to_store_in_a_busy_memory() {
        transfer(good_section());
        refuse(true);
        tester_.send({0x31U, 0x01U, 0xFFU, 0x01U});
        EXPECT_EQ(tester_.receive(5), no(0x31U, 0x78U));
    }

    Memories memories_{};
    Tester tester_{memories_};
};

TEST_F(Download, AGoodSectionIsStoredForTheNextStart) {
    EXPECT_FALSE(tester_.store().restore());
    transfer(good_section());
    EXPECT_TRUE(stored().empty()) << "not before it has been checked";
    EXPECT_FALSE(tester_.store().restore());
    EXPECT_EQ(check(), result(rsi::application::ParametersRefusal::none));
    EXPECT_EQ(stored(), good_section());
    rsi::application::SectionRecord record{memories_.section_one, memories_.section_other};
    rsi::diagnosis::SectionStore store{record};
    EXPECT_TRUE(store.restore());
    EXPECT_EQ(store.refusal(), ParametersRefusal::none);
    EXPECT_TRUE(std::equal(rsi_parameter_section, rsi_parameter_section + section_length, store.section()));
}

TEST_F(Download, BlocksMayHaveAnyLength) {
    for (const std::size_t size : {std::size_t{1U}, std::size_t{7U}, std::size_t{128U}}) {
        forget();
        transfer(good_section(), size);
        EXPECT_EQ(check(), result(rsi::application::ParametersRefusal::none));
        EXPECT_EQ(stored(), good_section());
    }
}

TEST_F(Download, ABadSectionIsRefusedWithItsReasonAndTheOldOneStays) {
    transfer(good_section());
    check();
    const auto refused = [&](std::size_t byte, rsi::application::ParametersRefusal reason) {
        Bytes section = good_section();
        section[byte] ^= 0x01U;
        transfer(section);
        EXPECT_EQ(check(), result(reason));
        EXPECT_EQ(stored(), good_section());
    };
    refused(0U, rsi::application::ParametersRefusal::missing);
    refused(4U, rsi::application::ParametersRefusal::version);
    refused(8U, rsi::application::ParametersRefusal::layout);
    refused(12U, rsi::application::ParametersRefusal::length);
    refused(100U, rsi::application::ParametersRefusal::checksum);

    Bytes section = good_section();
    std::fill_n(section.begin() + 64, 4, std::uint8_t{0U});  // no sprung mass
    rsi::application::put_u32(section.data(), section_length - 4U,
                              rsi::application::crc32(section.data(), section_length - 4U));
    transfer(section);
    EXPECT_EQ(check(), result(rsi::application::ParametersRefusal::value));
    EXPECT_EQ(stored(), good_section());
}

// Interrupted at every byte: by the end of the session, another request, or silence.
TEST_F(Download, NothingOfAnInterruptedOneIsStored) {
    transfer(good_section());
    check();
    Bytes other = good_section();
    other[16] = 'X';  // its name
    rsi::application::put_u32(other.data(), section_length - 4U,
                              rsi::application::crc32(other.data(), section_length - 4U));
    for (std::size_t sent = 0U; sent < section_length; ++sent) {
        if (sent % 40U == 0U) {  // a start takes a limited number of downloads and keys
            tester_.~Tester();
            new (&tester_) Tester{memories_};
        }
        tester_.unlock(0x02U);
        ASSERT_EQ(request_download()[0], 0x74U);
        unsigned number = 1U;
        for (std::size_t at = 0U; at < sent; at += 128U) {
            const std::size_t end = std::min(at + 128U, sent);
            ASSERT_EQ(block(number, Bytes(other.begin() + static_cast<std::ptrdiff_t>(at),
                                          other.begin() + static_cast<std::ptrdiff_t>(end)))[0],
                      0x76U);
            ++number;
        }
        if (sent % 3U == 0U) {
            EXPECT_EQ(ask({0x37U}), no(0x37U, 0x24U));
            EXPECT_EQ(check(), no(0x31U, 0x24U));
        } else if (sent % 3U == 1U) {
            tester_.unlock(0x02U);
            EXPECT_EQ(ask({0x37U}), no(0x37U, 0x24U));
            EXPECT_EQ(block(number, {1U}), no(0x36U, 0x24U));
        } else {
            EXPECT_EQ(check(), no(0x31U, 0x24U));
        }
        ASSERT_EQ(stored(), good_section());
    }
}

TEST_F(Download, ACheckEndsTheDownload) {
    transfer(good_section());
    check();
    EXPECT_EQ(check(), no(0x31U, 0x24U));
    EXPECT_EQ(ask({0x37U}), no(0x37U, 0x24U));
}

TEST_F(Download, TheRequestIsChecked) {
    EXPECT_EQ(ask({0x34U, 0x00U}), no(0x34U, 0x13U));
    EXPECT_EQ(ask({0x34U, 0x00U, 0x11U, 0U}), no(0x34U, 0x13U));
    EXPECT_EQ(ask({0x34U, 0x00U, 0x11U, 0U, 1U, 1U}), no(0x34U, 0x13U));
    EXPECT_EQ(ask({0x34U, 0x10U, 0x24U, 0U, 0U, 0U, 0U, 0x01U, 0x5CU}), no(0x34U, 0x31U)) << "compressed";
    EXPECT_EQ(ask({0x34U, 0x00U, 0x10U, 1U}), no(0x34U, 0x31U)) << "no address";
    EXPECT_EQ(ask({0x34U, 0x00U, 0x01U, 1U}), no(0x34U, 0x31U)) << "no section_length";
    EXPECT_EQ(ask({0x34U, 0x00U, 0x15U, 0U, 0U, 0U, 0U, 0U, 1U}), no(0x34U, 0x31U));
    EXPECT_EQ(ask({0x34U, 0x00U, 0x51U, 0U, 0U, 0U, 0U, 0U, 1U}), no(0x34U, 0x31U));
    EXPECT_EQ(ask({0x34U, 0x00U, 0x00U}), no(0x34U, 0x31U)) << "neither";
    EXPECT_EQ(ask({0x34U, 0x00U, 0x20U, 0x01U, 0x5CU}), no(0x34U, 0x31U)) << "no address, the right length";
    EXPECT_EQ(ask({0x34U, 0x00U, 0x25U, 0U, 0U, 0U, 0U, 0U, 0x01U, 0x5CU}), no(0x34U, 0x31U));
    EXPECT_EQ(ask({0x34U, 0x00U, 0x51U, 0U, 0U, 0U, 0U, 0x01U, 0x5CU}), no(0x34U, 0x31U));
    EXPECT_EQ(ask({0x34U, 0x00U, 0x24U, 0U, 0U, 0U, 1U, 0x01U, 0x5CU}), no(0x34U, 0x31U))
        << "another address";
    EXPECT_EQ(request_download(section_length - 1U), no(0x34U, 0x31U));
    EXPECT_EQ(request_download(section_length + 1U), no(0x34U, 0x31U));
    EXPECT_EQ(ask({0x34U, 0x00U, 0x44U, 0U, 0U, 0U, 0U, 0U, 0U, 0x01U, 0x5CU})[0], 0x74U);
    static_assert(section_length == 0x15CU);
    tester_.inputs.speed_mps = 3.0F;
    EXPECT_EQ(request_download(), no(0x34U, 0x22U));
    EXPECT_EQ(ask({0x34U, 0x00U}), no(0x34U, 0x13U)) << "the request before the conditions";
    EXPECT_EQ(request_download(section_length + 1U), no(0x34U, 0x31U));
}

TEST_F(Download, ThatIsOnItsWayIsNotBegunAnew) {
    ASSERT_EQ(request_download()[0], 0x74U);
    ASSERT_EQ(request_download()[0], 0x74U) << "its answer may have been lost";
    ASSERT_EQ(block(1U, {1U})[0], 0x76U);
    EXPECT_EQ(request_download(), no(0x34U, 0x22U));
    EXPECT_EQ(block(2U, {1U})[0], 0x76U) << "it goes on";
    tester_.unlock(0x02U);
    transfer(good_section());
    transfer(good_section());
    EXPECT_EQ(check(), result(rsi::application::ParametersRefusal::none)) << "a whole one is not on its way";
}

// With the key, and begun at rest.
TEST_F(Download, GoesOnAtRestOnly) {
    const auto drive = [&](float speed_mps) { tester_.inputs.speed_mps = speed_mps; };
    ASSERT_EQ(request_download()[0], 0x74U);
    drive(20.0F);
    EXPECT_EQ(block(1U, {1U}), no(0x36U, 0x22U));
    drive(0.0F);
    tester_.unlock(0x02U);
    transfer(good_section());
    drive(20.0F);
    EXPECT_EQ(ask({0x37U}), no(0x37U, 0x22U));
    EXPECT_EQ(check(), no(0x31U, 0x22U));
    EXPECT_TRUE(stored().empty());
    drive(0.0F);
    EXPECT_EQ(check(), result(rsi::application::ParametersRefusal::none));
}

// While the memory is busy the vehicle starts.
TEST_F(Download, IsNotStoredOnceTheVehicleMoves) {
    begin_to_store_in_a_busy_memory();
    tester_.inputs.speed_mps = 20.0F;
    refuse(false);
    EXPECT_EQ(tester_.receive(5), no(0x31U, 0x22U));
    EXPECT_TRUE(stored().empty());
}

// Each may be stored: no more than a memory lasts for.
TEST_F(Download, IsTakenAHundredTimesInAnOperationCycle) {
    for (int time = 0; time < 100; ++time) {
        ASSERT_EQ(request_download()[0], 0x74U) << time;
    }
    EXPECT_EQ(request_download(), no(0x34U, 0x22U));
}

TEST_F(Download, BlocksAreCounted) {
    EXPECT_EQ(block(1U, {1U}), no(0x36U, 0x24U)) << "nothing was requested";
    EXPECT_EQ(block(1U, {}), no(0x36U, 0x24U)) << "whatever the block has";
    request_download();
    EXPECT_EQ(ask({0x36U}), no(0x36U, 0x13U));
    EXPECT_EQ(block(0U, {1U}), no(0x36U, 0x73U)) << "no block has been, so none is repeated";
    EXPECT_EQ(block(2U, {1U}), no(0x36U, 0x73U));
    EXPECT_EQ(block(1U, {}), no(0x36U, 0x13U));
    EXPECT_EQ(block(1U, Bytes(100U, 1U)), (Bytes{0x76U, 0x01U}));
    EXPECT_EQ(block(1U, Bytes(100U, 1U)), (Bytes{0x76U, 0x01U})) << "repeated: taken once";
    EXPECT_EQ(block(2U, Bytes(128U, 1U)), (Bytes{0x76U, 0x02U}));
    EXPECT_EQ(block(3U, Bytes(121U, 1U)), no(0x36U, 0x71U)) << "a byte too many";
    EXPECT_EQ(ask({0x37U}), no(0x37U, 0x24U));
    EXPECT_EQ(block(3U, Bytes(120U, 1U)), (Bytes{0x76U, 0x03U}));
    EXPECT_EQ(block(4U, {1U}), no(0x36U, 0x71U));
    EXPECT_EQ(ask({0x37U, 0x00U}), no(0x37U, 0x13U));
    EXPECT_EQ(ask({0x37U}), (Bytes{0x77U}));
    EXPECT_EQ(block(4U, {1U}), no(0x36U, 0x24U));
}

TEST_F(Download, AMemoryThatIsBusyIsWaitedFor) {
    transfer(good_section());
    refuse(true);
    tester_.send({0x31U, 0x01U, 0xFFU, 0x01U});
    EXPECT_EQ(tester_.receive(20), no(0x31U, 0x78U));
    tester_.cycles(100);
    refuse(false);
    EXPECT_EQ(tester_.receive(100), result(rsi::application::ParametersRefusal::none));
    EXPECT_EQ(stored(), good_section());
}

TEST_F(Download, AMemoryThatNeverTakesItIsSaid) {
    transfer(good_section());
    refuse(true);
    tester_.send({0x31U, 0x01U, 0xFFU, 0x01U});
    EXPECT_EQ(tester_.receive(5), no(0x31U, 0x78U)) << "within P2";
    EXPECT_EQ(tester_.receive(500), no(0x31U, 0x72U)) << "within P2*";
    EXPECT_EQ(memories_.section_one.tries(), 11) << "not in every cycle";
    EXPECT_EQ(check(), no(0x31U, 0x24U)) << "each check takes a download, of which a start has a limit";
}

TEST_F(Download, AMemoryThatNeverTakesItIsReportedUntilItDoes) {
    transfer(good_section());
    EXPECT_FALSE(tester_.diagnosis().is_storage_failing());
    refuse(true);
    EXPECT_EQ(check(), no(0x31U, 0x72U));
    EXPECT_TRUE(tester_.diagnosis().is_storage_failing());
    tester_.unlock(0x02U);
    tester_.fail(DiagnosticCode::imu_lost);
    tester_.cycles(110);
    EXPECT_TRUE(tester_.diagnosis().is_storage_failing()) << "though the other memory takes records";
    transfer(good_section());
    refuse(false);
    EXPECT_EQ(check(), result(ParametersRefusal::none));
    EXPECT_FALSE(tester_.diagnosis().is_storage_failing());
}

// However long it has refused: the next check tries within a second.
TEST_F(Download, AMemoryThatHasRefusedForLongIsTriedByTheNextCheck) {
    refuse(true);
    for (int time = 0; time < 3; ++time) {
        tester_.unlock(0x02U);
        transfer(good_section());
        EXPECT_EQ(check(), no(0x31U, 0x72U));
    }
    tester_.unlock(0x02U);
    transfer(good_section());
    refuse(false);
    tester_.send({0x31U, 0x01U, 0xFFU, 0x01U});
    Bytes answer = tester_.receive(5);
    if (answer == no(0x31U, 0x78U)) {
        answer = tester_.receive(100);
    }
    EXPECT_EQ(answer, result(ParametersRefusal::none));
}

// A check that has waited is over, whatever ends the wait.
TEST_F(Download, ACheckThatHasWaitedEndsTheDownload) {
    begin_to_store_in_a_busy_memory();
    tester_.inputs.speed_mps = 20.0F;
    EXPECT_EQ(tester_.receive(5), no(0x31U, 0x22U));
    tester_.inputs.speed_mps = 0.0F;
    EXPECT_EQ(check(), no(0x31U, 0x24U));
}

// At whichever moment the memory takes it: what the tester hears is what has been done.
TEST_F(Download, TheReportOfASlowMemoryIsTrue) {
    int stored_in_time = 0;
    constexpr int tries = 20;
    for (int late = 0; late < tries; ++late) {
        transfer(good_section());
        forget();
        refuse(true);
        tester_.send({0x31U, 0x01U, 0xFFU, 0x01U});
        EXPECT_EQ(tester_.receive(5), no(0x31U, 0x78U)) << "within P2";
        tester_.cycles(400 + 3 * late);  // the memory is tried once a second
        refuse(false);
        const bool is_good = (tester_.receive(60) == result(rsi::application::ParametersRefusal::none));
        EXPECT_EQ(is_good, stored() == good_section()) << late;
        stored_in_time += is_good ? 1 : 0;
    }
    EXPECT_GT(stored_in_time, 0);
    EXPECT_LT(stored_in_time, tries);
}

// The section as the next start finds it in the memories, and the fault that it finds.
struct Start {
    explicit Start(Memories& memories) : record{memories.section_one, memories.section_other} {
        is_good = store.restore();
    }
    std::uint8_t letter() const { return store.section()[rsi::application::section::name_at]; }

    rsi::application::SectionRecord record;
    rsi::diagnosis::SectionStore store{record};
    bool is_good{false};
};

Bytes with_checksum(Bytes section) {
    rsi::application::section::put_checksum(section.data());
    return section;
}

// Sections that differ in the first letter of their names.
Bytes named(char letter) {
    Bytes section = good_section();
    section[rsi::application::section::name_at] = static_cast<std::uint8_t>(letter);
    return with_checksum(section);
}

void put(rsi::diagnosis::SectionStore& store, const Bytes& section) {
    for (std::size_t place = 0U; place < section.size(); ++place) {
        store.put(place, section[place]);
    }
}

rsi::diagnosis::SectionAnswer store_in(Start& start, const Bytes& section) {
    put(start.store, section);
    std::uint8_t reason = 0U;
    return start.store.store(reason);
}

// At every byte of every write: the old section or the new one.
TEST(StoredSection, OutlivesALossOfPowerAtAnyByteOfAnyWrite) {
    constexpr std::size_t length = rsi::application::SectionRecord::length;
    for (std::size_t bytes = 0U; bytes <= length; ++bytes) {
        for (const char newest : {'B', 'C'}) {  // the second goes to the other place
            Memories memories;
            for (char letter = 'A'; letter < newest; ++letter) {
                Start start{memories};
                ASSERT_EQ(store_in(start, named(letter)), rsi::diagnosis::SectionAnswer::stored);
            }
            memories.section_one.cut_power_at({1, bytes});
            memories.section_other.cut_power_at({1, bytes});
            Start before{memories};
            store_in(before, named(newest));
            const Start after{memories};
            ASSERT_TRUE(after.is_good) << bytes;
            const bool is_new = (bytes == length);
            ASSERT_EQ(after.letter(), is_new ? newest : newest - 1) << bytes;
            ASSERT_TRUE(!is_new || (after.store.refusal() == ParametersRefusal::none)) << bytes;
        }
    }
}

TEST(StoredSection, TornBeforeThereWasOneIsReported) {
    Memories memories;
    memories.section_one.cut_power_at({1, 200U});
    Start before{memories};
    EXPECT_EQ(before.store.refusal(), ParametersRefusal::none) << "a new control unit";
    store_in(before, named('A'));
    const Start after{memories};
    EXPECT_FALSE(after.is_good);
    EXPECT_EQ(after.store.refusal(), ParametersRefusal::checksum);
}

TEST(StoredSection, FlippedGivesWayToTheOneBeforeAndIsReported) {
    Memories memories;
    for (const char letter : {'A', 'B'}) {
        Start start{memories};
        store_in(start, named(letter));
    }
    for (std::size_t byte = 0U; byte < rsi::application::SectionRecord::length; ++byte) {
        Memories damaged;
        damaged.section_one.record() = memories.section_one.record();
        damaged.section_other.record() = memories.section_other.record();
        damaged.section_other.record()[byte] ^= 0x10U;
        const Start older{damaged};
        ASSERT_TRUE(older.is_good) << byte;
        ASSERT_EQ(older.letter(), 'A') << byte;
        ASSERT_EQ(older.store.refusal(), ParametersRefusal::checksum) << byte;
        damaged.section_one.record()[byte] ^= 0x01U;
        const Start none{damaged};
        ASSERT_FALSE(none.is_good) << byte;
        ASSERT_EQ(none.store.refusal(), ParametersRefusal::checksum) << byte;
    }
}

TEST(StoredSection, CutOrUnreadableIsReported) {
    for (const std::size_t length :
         {std::size_t{1U}, section_length, rsi::application::SectionRecord::length + 1U}) {
        Memories memories;
        memories.section_one.record() = Bytes(length, 0x5AU);
        const Start start{memories};
        EXPECT_FALSE(start.is_good) << length;
        EXPECT_EQ(start.store.refusal(), ParametersRefusal::checksum) << length;
    }
    Memories memories;
    memories.section_other.set_unreadable(true);
    const Start start{memories};
    EXPECT_FALSE(start.is_good);
    EXPECT_EQ(start.store.refusal(), ParametersRefusal::checksum);
}

// A whole record, of other software.
TEST(StoredSection, ThatTheFirmwareRefusesIsReportedWithTheReason) {
    const auto refusal = [](std::size_t byte, std::uint8_t bit) {
        Bytes section = good_section();
        section[byte] ^= bit;
        rsi::application::SectionBytes bytes{};
        section = with_checksum(section);
        std::copy(section.begin(), section.end(), bytes.begin());
        Memories memories;
        rsi::application::SectionRecord record{memories.section_one, memories.section_other};
        EXPECT_TRUE(record.write(bytes));
        const Start start{memories};
        EXPECT_FALSE(start.is_good);
        return start.store.refusal();
    };
    EXPECT_EQ(refusal(0U, 1U), ParametersRefusal::missing);
    EXPECT_EQ(refusal(rsi::application::section::version_at, 1U), ParametersRefusal::version);
    EXPECT_EQ(refusal(rsi::application::section::layout_at, 1U), ParametersRefusal::layout);
    EXPECT_EQ(refusal(rsi::application::section::length_at, 1U), ParametersRefusal::length);
    EXPECT_EQ(refusal(rsi::application::section::values_at + 3U, 0x80U), ParametersRefusal::value);
}

TEST(SectionDownload, IsNotAcceptedWithoutATarget) {
    rsi::diagnosis::SectionDownload download;
    rsi::diagnosis::Response response;
    const Bytes request{0x34U, 0x00U, 0x11U, 0U, 1U};
    EXPECT_EQ(download.begin({request.data(), request.size(), false}, true, true, response),
              Nrc::download_not_accepted);
    EXPECT_EQ(download.begin({request.data(), request.size(), false}, false, true, response),
              Nrc::security_access_denied);
}

// A target that does what its interface says and no more.
class CountingTarget final : public rsi::diagnosis::SectionTarget {
 public:
    std::size_t length() const noexcept override { return 10U; }
    void put(std::size_t place, std::uint8_t byte) noexcept override {
        puts.push_back(static_cast<std::uint8_t>(place));
        puts.push_back(byte);
    }
    rsi::diagnosis::SectionAnswer store(std::uint8_t&) noexcept override {
        return rsi::diagnosis::SectionAnswer::stored;
    }
    bool is_failing() const noexcept override { return false; }

    Bytes puts{};
};

TEST(SectionDownload, PutsEachByteOnceAndNoneBehindTheLast) {
    CountingTarget target;
    rsi::diagnosis::SectionDownload download;
    download.use(target);
    rsi::diagnosis::Response response;
    const auto ask = [](const Bytes& request) {
        return rsi::diagnosis::Request{request.data(), request.size(), false};
    };
    const Bytes request{0x34U, 0x00U, 0x11U, 0U, 10U};
    const Bytes first{0x36U, 1U, 10U, 11U, 12U, 13U, 14U, 15U};
    const Bytes second{0x36U, 2U, 16U, 17U, 18U, 19U};
    const Bytes exit{0x37U};
    ASSERT_EQ(download.begin(ask(request), true, true, response), Nrc::none);
    EXPECT_EQ(download.transfer(ask(first), response), Nrc::none);
    EXPECT_EQ(download.transfer(ask(second), response), Nrc::none);
    EXPECT_EQ(download.end(ask(exit)), Nrc::none);
    EXPECT_EQ(target.puts, (Bytes{0U, 10U, 1U, 11U, 2U, 12U, 3U, 13U, 4U, 14U,
                                  5U, 15U, 6U, 16U, 7U, 17U, 8U, 18U, 9U, 19U}));
    std::uint8_t refusal = 7U;
    EXPECT_EQ(download.check_and_store(refusal), Nrc::none);
    EXPECT_EQ(refusal, 0U) << "where nothing is refused the target says nothing";
}

// With an authority a section needs its seal.
TEST(SectionStore, TakesSealedSectionsOnlyWhereTheBuildWantsThem) {
    rsi::hal::SoftwareKeys keys{rsi::hal::test_keys};
    rsi_test::CutStorage newest;
    rsi::application::SectionAuthority authority{keys, newest};
    authority.start();
    rsi_test::CutStorage one;
    rsi_test::CutStorage other;
    rsi::application::SectionRecord record{one, other};
    rsi::diagnosis::SectionStore store{record, &authority};
    ASSERT_EQ(store.length(), rsi::application::seal::sealed_length);
    Bytes section = good_section();
    section.resize(store.length());
    std::uint8_t reason = 0U;
    put(store, section);
    EXPECT_EQ(store.store(reason), rsi::diagnosis::SectionAnswer::refused);
    EXPECT_EQ(reason, static_cast<std::uint8_t>(rsi::application::ParametersRefusal::unauthentic));
    ASSERT_TRUE(rsi::application::seal_section(keys, 1U, section.data()));
    put(store, section);
    EXPECT_EQ(store.store(reason), rsi::diagnosis::SectionAnswer::stored);
    EXPECT_EQ(reason, 0U);
    rsi::application::SectionRecord next{one, other};
    rsi::diagnosis::SectionStore again{next, &authority};
    EXPECT_TRUE(again.restore());

    section[350] ^= 1U;  // its seal
    rsi::application::SectionBytes bytes{};
    std::copy(section.begin(), section.end(), bytes.begin());
    ASSERT_TRUE(next.write(bytes));
    EXPECT_FALSE(again.restore());
    EXPECT_EQ(again.refusal(), ParametersRefusal::unauthentic);
}

}  // namespace
}  // namespace testing_diagnosis
