// The end-to-end receiver over any sequence of frames, against a second one that is written from the
// profile's description: bit by bit, with an expectation of the next counter in place of a difference.
#include <array>
#include <cstdint>
#include <optional>

#include "rsi/can_dbc/e2e/profile_11.hpp"
#include "tests/application/end_to_end.hpp"
#include "tests/quality/fuzz/support/byte_reader.hpp"
#include "tests/quality/fuzz/support/require.hpp"

namespace {

using fuzz::ByteReader;
using fuzz::require;
using rsi::can_dbc::e2e::CheckError;
using rsi::can_dbc::e2e::CheckResult;
using rsi::can_dbc::e2e::CheckStatus;

using Payload = std::array<std::uint8_t, 64>;

struct Setting {
    std::uint16_t data_id;
    std::size_t length;
    std::uint8_t largest_step;
};

class Reference {
 public:
    explicit Reference(const Setting& setting) : setting_{setting} {}

    CheckResult check(const Payload& payload, std::size_t length) {
        if (length != setting_.length || length < 2U) {
            return {CheckStatus::error, CheckError::length};
        }
        if (crc_of(payload, length) != payload[0]) {
            return {CheckStatus::error, CheckError::crc};
        }
        if (payload[1] / 16U != setting_.data_id / 256U) {
            return {CheckStatus::error, CheckError::data_id};
        }
        if (payload[1] % 16U == 15U) {
            return {CheckStatus::error, CheckError::counter};
        }
        return follow(payload[1] % 16U);
    }

 private:
    std::uint8_t crc_of(const Payload& payload, std::size_t length) const {
        std::array<std::uint8_t, 65> covered{static_cast<std::uint8_t>(setting_.data_id % 256U), 0U};
        for (std::size_t index = 1U; index < length; ++index) {
            covered[index + 1U] = payload[index];
        }
        return testing_application::crc8_bit_by_bit(0U, covered.data(), length + 1U);
    }

    CheckResult follow(unsigned counter) {
        const std::optional<unsigned> before = latest_;
        latest_ = counter;
        if (!before) {
            return {CheckStatus::ok};
        }
        if (*before == counter) {
            return {CheckStatus::repeated};
        }
        unsigned expected = *before;
        std::uint8_t lost = 0U;
        for (;; ++lost) {
            expected = expected == 14U ? 0U : expected + 1U;
            if (expected == counter) {
                break;
            }
        }
        if (lost == 0U) {
            return {CheckStatus::ok};
        }
        const bool tolerated = lost < setting_.largest_step;
        return {tolerated ? CheckStatus::ok_some_lost : CheckStatus::wrong_sequence, CheckError::none, lost};
    }

    Setting setting_;
    std::optional<unsigned> latest_{};
};

// Received frames: any bytes; a good frame, with any counter; a good one with one change.
class Channel {
 public:
    Channel(const Setting& setting, ByteReader& bytes) : setting_{setting}, bytes_{bytes} {}

    void next() {
        const unsigned kind = bytes_.below(8U);
        length = setting_.length;
        switch (kind) {
            case 0U:  // any bytes of any length
                length = bytes_.below(66U);
                bytes_.take_into(payload.data(), setting_.length);
                break;
            case 1U:  // the frame before, once more
                break;
            default:
                good_frame(kind);
        }
        if (kind == 2U) {  // one bit changed on the way
            const unsigned bit = bytes_.below(static_cast<unsigned>(8U * setting_.length));
            payload[bit / 8U] = static_cast<std::uint8_t>(payload[bit / 8U] ^ (1U << (bit % 8U)));
        } else if (kind == 3U) {
            length = bytes_.below(66U);
        }
    }

    Payload payload{};
    std::size_t length{0U};

 private:
    // With the right check sum; the counter goes on as it should, or, for one kind, anywhere.
    void good_frame(unsigned kind) {
        rsi::hal::CanFrame frame{};
        frame.length = static_cast<std::uint8_t>(setting_.length);
        frame.data[2] = bytes_.take<std::uint8_t>();
        counter_ = kind == 4U ? bytes_.below(16U) : (counter_ + 1U) % 15U;
        const std::uint16_t data_id = kind == 5U ? bytes_.take<std::uint16_t>() & 0x0FFFU : setting_.data_id;
        testing_application::protect(frame, data_id, counter_);
        payload = frame.data;
    }

    Setting setting_;
    ByteReader& bytes_;
    unsigned counter_{0U};
};

bool same(const CheckResult& a, const CheckResult& b) {
    return a.status == b.status && a.error == b.error && a.lost_frames == b.lost_frames;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    ByteReader bytes{data, size};
    Setting setting{};
    setting.data_id = bytes.take<std::uint16_t>() & 0x0FFFU;
    setting.length = 2U + bytes.below(63U);
    setting.largest_step = static_cast<std::uint8_t>(1U + bytes.below(14U));
    rsi::can_dbc::e2e::Profile11Receiver receiver{setting.data_id, setting.length, setting.largest_step};
    Reference reference{setting};
    Channel channel{setting, bytes};
    while (!bytes.empty()) {
        channel.next();
        const CheckResult result = receiver.check(channel.payload, channel.length);
        require(same(result, reference.check(channel.payload, channel.length)),
                "the receiver judges as the profile's description says");
        const bool usable = rsi::can_dbc::e2e::is_usable(result.status);
        require((result.error != CheckError::none) == (result.status == CheckStatus::error),
                "an error has a reason, and nothing else has one");
        require(!usable || result.lost_frames < setting.largest_step,
                "not usable after more lost frames than tolerated");
        rsi::hal::CanFrame frame{};
        frame.data = channel.payload;
        frame.length = static_cast<std::uint8_t>(channel.length);
        require(
            !usable || (channel.length <= 64U && testing_application::is_profile_11(frame, setting.data_id)),
            "never usable with a wrong CRC, length or data identifier");
        require(receiver.no_frame().status == CheckStatus::no_new_data, "no frame is no data");
    }
    return 0;
}
