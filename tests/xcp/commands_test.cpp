// Each command's answer, byte for byte, and what is said to commands that are wrong.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <string>

#include "tests/xcp/bench.hpp"

namespace testing_xcp {
namespace {

constexpr std::uint8_t low(std::uint32_t value) {
    return static_cast<std::uint8_t>(value);
}

struct Exchange {
    const char* what;
    Bytes command;
    Bytes answer;
};

TEST(Slave, HearsNothingButConnectWithoutAConnection) {
    Bench bench;
    EXPECT_EQ(bench.command({0xFD}), Bytes{});
    EXPECT_EQ(bench.command({0xFC}), Bytes{});
    EXPECT_FALSE(bench.ecu().slave().is_connected());
    EXPECT_EQ(bench.command({0xFF, 0x01}), Bytes{});
    EXPECT_EQ(bench.command({0xFF}), (Bytes{0xFF, 0x05, 0x80, 8, 8, 0, 1, 1}));
    EXPECT_TRUE(bench.ecu().slave().is_connected());
    EXPECT_EQ(bench.command({0xFE}), Bytes{0xFF});
    EXPECT_FALSE(bench.ecu().slave().is_connected());
    EXPECT_EQ(bench.command({0xFD}), Bytes{});
}

TEST(Slave, TakesItsOwnFramesOnly) {
    Bench bench;
    rsi::hal::CanFrame frame;
    frame.identifier = rsi::xcp::default_identifiers.command;
    frame.length = 2U;
    frame.data[0] = 0xFFU;
    const auto is_answered = [&](const rsi::hal::CanFrame& sent) {
        bench.send(sent);
        bench.cycle();
        return !bench.answers.empty();
    };
    rsi::hal::CanFrame other = frame;
    other.extended = true;
    EXPECT_FALSE(is_answered(other));
    other = frame;
    other.flexible_data_rate = true;
    EXPECT_FALSE(is_answered(other));
    other = frame;
    other.identifier = rsi::xcp::default_identifiers.answer;
    EXPECT_FALSE(is_answered(other));
    other = frame;
    other.length = 0U;
    EXPECT_FALSE(is_answered(other));
    EXPECT_TRUE(is_answered(frame));
    // A frame without a byte is no command in a session either, and takes the place of none.
    EXPECT_FALSE(is_answered(other));
    bench.send(frame);
    EXPECT_TRUE(is_answered(other));
}

TEST(Slave, LeavesTheEcusFramesAlone) {
    Bench bench;
    bench.connect();
    EXPECT_EQ(bench.others.size(), testing_application::frames_per_cycle);
    EXPECT_EQ(bench.others.front().identifier, rsi::can_dbc::RolloverWarning::identifier);
}

// The frames come together with the cycle, which should be a little behind them.
TEST(Slave, LeavesTheCycleToTheFramesOfTheImu) {
    Bench bench;
    bench.cycle();
    EXPECT_EQ(bench.ecu().cycle_shift(), rsi::application::CyclePhase::largest_shift);
}

// Each in turn, in one session.
TEST(Slave, AnswersByTheBook) {
    Bench bench;
    bench.connect_and_unlock();
    const std::uint32_t length = map::parameters_length;
    const Exchange exchanges[]{
        {"GET_STATUS", {0xFD}, {0xFF, 0x00, 0x00, 0x00, 0x00, 0x00}},
        {"SYNCH", {0xFC}, {0xFE, 0x00}},
        {"GET_COMM_MODE_INFO", {0xFB}, {0xFF, 0, 0, 0, 0, 0, 0, 1}},
        {"GET_ID, text", {0xFA, 0}, {0xFF, 0, 0, 0, 7, 0, 0, 0}},
        {"UPLOAD of it", {0xF5, 7}, {0xFF, 'r', 's', 'i', '-', 'e', 'c', 'u'}},
        {"GET_ID, name of the A2L", {0xFA, 1}, {0xFF, 0, 0, 0, 7, 0, 0, 0}},
        {"UPLOAD of it", {0xF5, 3}, {0xFF, 'r', 's', 'i'}},
        {"UPLOAD of what follows", {0xF5, 4}, {0xFF, '-', 'e', 'c', 'u'}},
        {"UPLOAD beyond its end", {0xF5, 1}, {0xFE, 0x24}},
        {"GET_ID, path", {0xFA, 2}, {0xFF, 0, 0, 0, 0, 0, 0, 0}},
        {"UPLOAD of nothing", {0xF5, 0}, {0xFE, 0x22}},
        {"UPLOAD of too much", {0xF5, 8}, {0xFE, 0x22}},
        {"SET_MTA with an extension", {0xF6, 0, 0, 1, 0, 0, 1, 0}, {0xFE, 0x22}},
        {"SHORT_UPLOAD of the EPK", {0xF4, 4, 0, 0, 0, 0, 4, 0}, {0xFF, 'r', 's', 'i', ' '}},
        {"SHORT_UPLOAD with an extension", {0xF4, 4, 0, 1, 0, 0, 4, 0}, {0xFE, 0x22}},
        {"SHORT_UPLOAD of nowhere", {0xF4, 4, 0, 0, 0, 0, 9, 0}, {0xFE, 0x24}},
        {"GET_PAG_PROCESSOR_INFO", {0xE9}, {0xFF, 1, 1}},
        {"GET_SEGMENT_INFO, address", {0xE8, 0, 0, 0, 0}, {0xFF, 0, 0, 0, 0, 0, 1, 0}},
        {"GET_SEGMENT_INFO, length",
         {0xE8, 0, 0, 1, 0},
         {0xFF, 0, 0, 0, low(length), low(length >> 8U), 0, 0}},
        {"GET_SEGMENT_INFO, what is not", {0xE8, 0, 0, 2, 0}, {0xFE, 0x22}},
        {"GET_SEGMENT_INFO, pages", {0xE8, 1, 0, 0, 0}, {0xFF, 2, 0, 0, 0, 0}},
        {"GET_SEGMENT_INFO, mapping", {0xE8, 2, 0, 0, 0}, {0xFE, 0x22}},
        {"GET_SEGMENT_INFO, another", {0xE8, 0, 1, 0, 0}, {0xFE, 0x28}},
        {"GET_PAGE_INFO, working", {0xE7, 0, 0, 0}, {0xFF, 0x3F, 0}},
        {"GET_PAGE_INFO, reference", {0xE7, 0, 0, 1}, {0xFF, 0x0F, 0}},
        {"GET_PAGE_INFO, another", {0xE7, 0, 0, 2}, {0xFE, 0x26}},
        {"GET_PAGE_INFO, another segment", {0xE7, 0, 1, 0}, {0xFE, 0x28}},
        {"GET_SEGMENT_MODE", {0xE5, 0, 0}, {0xFF, 0, 0}},
        {"SET_SEGMENT_MODE, freeze", {0xE6, 1, 0}, {0xFF}},
        {"GET_SEGMENT_MODE", {0xE5, 0, 0}, {0xFF, 0, 1}},
        {"SET_SEGMENT_MODE, another", {0xE6, 1, 1}, {0xFE, 0x28}},
        {"GET_SEGMENT_MODE, another", {0xE5, 0, 1}, {0xFE, 0x28}},
        {"SET_SEGMENT_MODE, not", {0xE6, 0, 0}, {0xFF}},
        {"GET_SEGMENT_MODE", {0xE5, 0, 0}, {0xFF, 0, 0}},
        {"GET_CAL_PAGE, ECU", {0xEA, 1, 0}, {0xFF, 0, 0, 0}},
        {"GET_CAL_PAGE, XCP", {0xEA, 2, 0}, {0xFF, 0, 0, 0}},
        {"GET_CAL_PAGE, both", {0xEA, 3, 0}, {0xFE, 0x27}},
        {"GET_CAL_PAGE, another segment", {0xEA, 1, 1}, {0xFE, 0x28}},
        {"SET_CAL_PAGE, nobody's", {0xEB, 0, 0, 0}, {0xFE, 0x27}},
        {"SET_CAL_PAGE, another", {0xEB, 3, 0, 2}, {0xFE, 0x26}},
        {"SET_CAL_PAGE, another segment", {0xEB, 3, 1, 1}, {0xFE, 0x28}},
        {"SET_CAL_PAGE, all segments", {0xEB, 0x83, 1, 1}, {0xFF}},
        {"GET_CAL_PAGE, ECU", {0xEA, 1, 0}, {0xFF, 0, 0, 1}},
        {"GET_CAL_PAGE, XCP", {0xEA, 2, 0}, {0xFF, 0, 0, 1}},
        {"SET_CAL_PAGE, XCP", {0xEB, 2, 0, 0}, {0xFF}},
        {"GET_CAL_PAGE, ECU", {0xEA, 1, 0}, {0xFF, 0, 0, 1}},
        {"GET_CAL_PAGE, XCP", {0xEA, 2, 0}, {0xFF, 0, 0, 0}},
        {"COPY_CAL_PAGE", {0xE4, 0, 1, 0, 0}, {0xFF}},
        {"COPY_CAL_PAGE to itself", {0xE4, 0, 0, 0, 0}, {0xFF}},
        {"COPY_CAL_PAGE to the reference", {0xE4, 0, 0, 0, 1}, {0xFE, 0x23}},
        {"COPY_CAL_PAGE of another", {0xE4, 0, 2, 0, 0}, {0xFE, 0x26}},
        {"COPY_CAL_PAGE to another", {0xE4, 0, 0, 0, 2}, {0xFE, 0x26}},
        {"COPY_CAL_PAGE of another segment", {0xE4, 1, 0, 0, 0}, {0xFE, 0x28}},
        {"COPY_CAL_PAGE to another segment", {0xE4, 0, 0, 1, 0}, {0xFE, 0x28}},
        {"SET_REQUEST, lists", {0xF9, 0x04}, {0xFE, 0x22}},
        {"GET_DAQ_PROCESSOR_INFO", {0xDA}, {0xFF, 0x93, 0, 0, 2, 0, 0, 0}},
        {"GET_DAQ_RESOLUTION_INFO", {0xD9}, {0xFF, 1, 7, 0, 0, 0x52, 1, 0}},
        {"GET_DAQ_EVENT_INFO, 10 ms", {0xD7, 0, 0, 0}, {0xFF, 4, 4, 0, 10, 6, 1}},
        {"GET_DAQ_EVENT_INFO, 100 ms", {0xD7, 0, 1, 0}, {0xFF, 4, 4, 0, 100, 6, 0}},
        {"GET_DAQ_EVENT_INFO, another", {0xD7, 0, 2, 0}, {0xFE, 0x22}},
        {"PROGRAM_START", {0xD2}, {0xFE, 0x20}},
        {"MODIFY_BITS", {0xEC, 0, 0, 0, 0, 0}, {0xFE, 0x20}},
        {"USER_CMD", {0xF1, 0}, {0xFE, 0x20}},
        {"no command", {0x00}, {0xFE, 0x20}},
    };
    for (const Exchange& exchange : exchanges) {
        EXPECT_EQ(bench.command(exchange.command), exchange.answer) << exchange.what;
    }
}

// One byte less than a command has is a fault of its syntax, for every command that has more than its code.
TEST(Slave, RefusesCommandsThatAreTooShort) {
    const std::vector<std::pair<int, int>> lengths{
        {0xFA, 2}, {0xF9, 2}, {0xF8, 3}, {0xF7, 3}, {0xF6, 8}, {0xF5, 2}, {0xF4, 8}, {0xF3, 8}, {0xF0, 2},
        {0xEB, 4}, {0xEA, 3}, {0xE8, 5}, {0xE7, 4}, {0xE6, 3}, {0xE5, 3}, {0xE4, 5}, {0xE3, 4}, {0xE2, 6},
        {0xE1, 8}, {0xE0, 8}, {0xDF, 4}, {0xDE, 4}, {0xDD, 2}, {0xD7, 4}, {0xD5, 4}, {0xD4, 5}, {0xD3, 6}};
    Bench bench;
    bench.connect_and_unlock();
    for (const auto& [code, length] : lengths) {
        Bytes bytes(static_cast<std::size_t>(length - 1), 0U);
        bytes[0] = static_cast<std::uint8_t>(code);
        EXPECT_EQ(bench.command(bytes), (Bytes{0xFE, 0x21})) << std::hex << code;
        bytes.push_back(0U);
        EXPECT_NE(bench.command(bytes), (Bytes{0xFE, 0x21})) << std::hex << code;
    }
    EXPECT_EQ(bench.command({0xF0, 4, 1, 2, 3}), (Bytes{0xFE, 0x21}));
}

TEST(Slave, ChecksumsAreThoseOfZipAndMoveOn) {
    Bench bench;
    bench.connect_and_unlock();
    ASSERT_TRUE(bench.set_address(map::parameters_at));
    const std::uint8_t* const values = rsi_parameter_section + rsi::application::section::values_at;
    const Bytes first = bench.command(Bench::with_word({0xF3, 0, 0, 0}, 8U));
    EXPECT_EQ(first, Bench::with_word({0xFF, 0x09, 0, 0}, rsi::application::crc32(values, 8U)));
    const std::uint32_t rest = map::parameters_length - 8U;
    EXPECT_EQ(bench.command(Bench::with_word({0xF3, 0, 0, 0}, rest)),
              Bench::with_word({0xFF, 0x09, 0, 0}, rsi::application::crc32(values + 8U, rest)));
    EXPECT_EQ(bench.command(Bench::with_word({0xF3, 0, 0, 0}, 1U)), (Bytes{0xFE, 0x24}));
    ASSERT_TRUE(bench.set_address(map::parameters_at));
    EXPECT_EQ(bench.command(Bench::with_word({0xF3, 0, 0, 0}, 0xFFFFFFFFU)), (Bytes{0xFE, 0x24}));
}

TEST(Slave, TellsTheTimeInUnitsOf100Microseconds) {
    Bench bench;
    bench.connect();
    const auto ticks = [&] {
        const Bytes answer = bench.command({0xDC});
        EXPECT_EQ(answer.size(), 8U);
        return answer[4] + 256U * answer[5] + 65536U * answer[6];
    };
    const std::uint32_t before = ticks();
    EXPECT_EQ(ticks() - before, 100U);
    bench.cycles(2000);
    EXPECT_EQ(ticks() - before, 200200U);  // neither gains nor loses
}

TEST(Slave, ReadsEveryOutputAndNothingBesideIt) {
    Bench bench;
    bench.connect();
    bench.cycles(200);
    const rsi::Outputs& outputs = bench.ecu().ecu().outputs();
    std::uint32_t address = map::outputs_at;
    for (const rsi::CodeOutput& code : rsi::code_outputs) {
        EXPECT_EQ(static_cast<std::int32_t>(bench.word(address)), outputs.*code.member) << code.name;
        address += 4U;
    }
    for (const rsi::NumberOutput& number : rsi::number_outputs) {
        const std::uint32_t bits = bench.word(address);
        float value = 0.0F;
        std::memcpy(&value, &bits, sizeof value);
        EXPECT_EQ(std::memcmp(&value, &(outputs.*number.member), sizeof value), 0) << number.name;
        address += 4U;
    }
    EXPECT_EQ(address, map::outputs_at + map::outputs_length);
    for (const std::uint32_t outside :
         {map::outputs_at - 1U, address, address - 3U, map::parameters_at - 1U, 0xFFFFFFFEU, 0U}) {
        EXPECT_EQ(bench.command(Bench::with_word({0xF4, 4, 0, 0}, outside)), (Bytes{0xFE, 0x24})) << outside;
    }
}

TEST(Slave, ReadsEveryInputAndNothingBesideIt) {
    Bench bench;
    bench.connect();
    bench.cycles(200);
    const rsi::Inputs& inputs = bench.ecu().ecu().inputs();
    EXPECT_FALSE(std::isnan(inputs.lateral_specific_force_mps2));
    EXPECT_FALSE(std::isnan(inputs.speed_mps));
    std::array<float, map::inputs_length / 4U> expected{};
    std::memcpy(expected.data(), &inputs, sizeof expected);
    for (std::size_t place = 0U; place < expected.size(); ++place) {
        const std::uint32_t bits = bench.word(map::inputs_at + 4U * static_cast<std::uint32_t>(place));
        EXPECT_EQ(std::memcmp(&bits, &expected[place], sizeof bits), 0) << place;
    }
    const std::uint32_t behind = map::inputs_at + map::inputs_length;
    for (const std::uint32_t outside : {map::inputs_at - 1U, behind, behind - 3U}) {
        EXPECT_EQ(bench.command(Bench::with_word({0xF4, 4, 0, 0}, outside)), (Bytes{0xFE, 0x24})) << outside;
    }
}

TEST(Slave, ReadsTheCodesThatAreSetAndThoseThatAreConfirmed) {
    Bench bench;
    bench.connect();
    bench.cycles(200);
    const auto set_at = [&](std::uint32_t address) {
        return bench.word(address) | (std::uint64_t{bench.word(address + 4U)} << 32U);
    };
    const rsi::monitoring::DiagnosticMemory& memory = bench.ecu().ecu().diagnostic_memory();
    EXPECT_EQ(set_at(map::codes_at), 0U);
    EXPECT_EQ(set_at(map::codes_at + 8U), 0U);
    bench.cycle(9U);  // too late a cycle
    EXPECT_NE(memory.active_codes(), 0U);
    EXPECT_EQ(set_at(map::codes_at), memory.active_codes());
    EXPECT_EQ(set_at(map::codes_at + 8U), memory.confirmed_codes());
    const std::uint32_t behind = map::codes_at + map::codes_length;
    for (const std::uint32_t outside : {map::codes_at - 1U, behind, behind - 3U}) {
        EXPECT_EQ(bench.command(Bench::with_word({0xF4, 4, 0, 0}, outside)), (Bytes{0xFE, 0x24})) << outside;
    }
}

}  // namespace
}  // namespace testing_xcp
