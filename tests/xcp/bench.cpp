#include "tests/xcp/bench.hpp"

#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace testing_xcp {

bool CountingRandom::fill(std::uint8_t* bytes, std::size_t length) noexcept {
    ++calls_;
    std::fill_n(bytes, length, calls_);
    return !is_empty;
}

void Bench::restart() {
    access_.emplace(keys_, rsi::hal::KeySlot::calibration, random, attempts_);
    access_->start();
    stored_.emplace(one, other);
    ecu_.emplace(bus_.endpoint(0U), clock_, watchdog_, *access_, reference.data(), reference.size(),
                 has_memory ? &*stored_ : nullptr);
    static_cast<void>(ecu_->init());
}

void Bench::cycle(std::uint32_t missed_cycles) {
    now_ = now_ + rsi::hal::Time::from_milliseconds(10);
    clock_.set(now_);
    const testing_application::Motion motion;
    bus_.endpoint(1U).send(testing_application::frame_of(motion.imu, counter_));
    bus_.endpoint(1U).send(testing_application::frame_of(motion.roll_angle, counter_));
    bus_.endpoint(1U).send(testing_application::frame_of(motion.vehicle_motion, counter_));
    counter_ = (counter_ + 1U) % 15U;
    ecu_->step(missed_cycles);
    answers.clear();
    samples.clear();
    others.clear();
    rsi::hal::CanFrame frame;
    while (bus_.endpoint(2U).receive(frame) == rsi::hal::ReceiveResult::frame) {
        if (frame.identifier == rsi::xcp::default_identifiers.answer) {
            const Bytes bytes{frame.data.begin(), frame.data.begin() + frame.length};
            (bytes.at(0U) >= 0xFCU ? answers : samples).push_back(bytes);
        } else if ((frame.identifier & 0x7F0U) != 0x120U) {
            others.push_back(frame);
        }
    }
    while (bus_.endpoint(1U).receive(frame) == rsi::hal::ReceiveResult::frame) {
    }
}

void Bench::cycles(int count) {
    for (int k = 0; k < count; ++k) {
        cycle();
    }
}

Bytes Bench::command(const Bytes& bytes) {
    rsi::hal::CanFrame frame;
    frame.identifier = rsi::xcp::default_identifiers.command;
    frame.length = static_cast<std::uint8_t>(bytes.size());
    std::copy(bytes.begin(), bytes.end(), frame.data.begin());
    send(frame);
    cycle();
    return answers.empty() ? Bytes{} : answers.front();
}

Bytes Bench::unlock(bool with_good_key) {
    rsi::access::Block seed{};
    std::size_t got = 0U;
    while (got < seed.size()) {
        const Bytes answer = command({0xF8, static_cast<std::uint8_t>(got == 0U ? 0U : 1U), 0x01});
        if (!is_good(answer) || answer.at(1U) != seed.size() - got) {
            return answer;
        }
        std::copy(answer.begin() + 2, answer.end(), seed.begin() + static_cast<std::ptrdiff_t>(got));
        got += answer.size() - 2U;
    }
    rsi::access::Block key{};
    static_cast<void>(keys_.authenticate(rsi::hal::KeySlot::calibration, seed.data(), seed.size(), key));
    key[15] = static_cast<std::uint8_t>(key[15] ^ (with_good_key ? 0U : 1U));
    Bytes answer;
    for (std::size_t at = 0U; at < key.size(); at += 6U) {
        const std::size_t piece = std::min<std::size_t>(6U, key.size() - at);
        Bytes bytes{0xF7, static_cast<std::uint8_t>(key.size() - at)};
        bytes.insert(bytes.end(), key.begin() + static_cast<std::ptrdiff_t>(at),
                     key.begin() + static_cast<std::ptrdiff_t>(at + piece));
        answer = command(bytes);
        if (!is_good(answer)) {
            return answer;
        }
    }
    return answer;
}

void Bench::connect_and_unlock() {
    if (!is_good(connect()) || unlock() != Bytes{0xFF, 0x00}) {
        throw std::runtime_error{"the slave does not unlock"};
    }
}

Bytes Bench::with_word(Bytes bytes, std::uint32_t word) {
    for (unsigned shift = 0U; shift < 32U; shift += 8U) {
        bytes.push_back(static_cast<std::uint8_t>(word >> shift));
    }
    return bytes;
}

Bytes Bench::download(std::uint32_t address, const Bytes& bytes) {
    if (!set_address(address)) {
        throw std::runtime_error{"no answer to SET_MTA"};
    }
    Bytes data{0xF0, static_cast<std::uint8_t>(bytes.size())};
    data.insert(data.end(), bytes.begin(), bytes.end());
    return command(data);
}

Bytes Bench::upload(std::uint32_t address, std::uint8_t count) {
    Bytes answer = command(with_word({0xF4, count, 0, 0}, address));
    if (!is_good(answer)) {
        throw std::runtime_error{"SHORT_UPLOAD was refused"};
    }
    answer.erase(answer.begin());
    return answer;
}

std::uint32_t Bench::word(std::uint32_t address) {
    const Bytes bytes = upload(address, 4U);
    return bytes[0] | (static_cast<std::uint32_t>(bytes[1]) << 8U) |
           (static_cast<std::uint32_t>(bytes[2]) << 16U) | (static_cast<std::uint32_t>(bytes[3]) << 24U);
}

rsi::ParameterField Bench::field_of(const char* name) const {
    for (const rsi::ParameterField& field : rsi::parameter_fields) {
        if (std::strcmp(field.name, name) == 0) {
            return field;
        }
    }
    throw std::runtime_error{name};
}

std::uint32_t Bench::address_of(const char* name) {
    std::uint32_t address = map::parameters_at;
    for (const rsi::ParameterField& field : rsi::parameter_fields) {
        if (std::strcmp(field.name, name) == 0) {
            return address;
        }
        address += 4U;
    }
    for (const rsi::SelectionField& field : rsi::selection_fields) {
        if (std::strcmp(field.name, name) == 0) {
            return address;
        }
        address += 4U;
    }
    throw std::runtime_error{name};
}

bool Bench::write_float(const char* field, float value) {
    std::uint32_t word = 0U;
    std::memcpy(&word, &value, sizeof word);
    return is_good(download(address_of(field), with_word({}, word)));
}

float Bench::read_float(const char* field) {
    const std::uint32_t bits = word(address_of(field));
    float value = 0.0F;
    std::memcpy(&value, &bits, sizeof value);
    return value;
}

}  // namespace testing_xcp
