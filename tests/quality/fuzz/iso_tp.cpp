// ISO-TP over any frames, answers and cycles, against a second reassembly that knows no times: what waits is
// what came, whole; what goes out is padded, of one identifier and bounded; silence ends everything.
#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "rsi/ecu/diagnosis/iso_tp.hpp"
#include "tests/quality/fuzz/support/byte_reader.hpp"
#include "tests/quality/fuzz/support/require.hpp"

namespace {

using fuzz::ByteReader;
using fuzz::require;

constexpr rsi::diagnosis::Addresses addresses{};

class Bus final : public rsi::hal::CanBus {
 public:
    rsi::hal::ReceiveResult receive(rsi::hal::CanFrame&) noexcept override {
        return rsi::hal::ReceiveResult::empty;
    }
    rsi::hal::SendResult send(const rsi::hal::CanFrame& frame) noexcept override {
        require(frame.identifier == addresses.response && !frame.extended && frame.length == 8U,
                "its frames");
        if (room == 0U) {
            return rsi::hal::SendResult::full;
        }
        --room;
        ++sent;
        return rsi::hal::SendResult::sent;
    }
    rsi::hal::BusState state() const noexcept override { return rsi::hal::BusState::error_active; }
    rsi::hal::BusStatistics statistics() const noexcept override { return {}; }

    unsigned room{8U};
    unsigned sent{0U};
};

// A segmented request if no time had run out: the last first frame and those that followed.
class Reassembly {
 public:
    // Nothing new is taken while a request waits or an answer goes out.
    void take(const rsi::hal::CanFrame& frame, bool was_waiting, bool was_sending) {
        const unsigned kind = frame.data[0] >> 4U;
        if (frame.length == 0U || was_waiting || (was_sending && kind != 2U)) {
            return;
        }
        const unsigned length =
            (kind == 1U) ? ((frame.data[0] & 0x0FU) << 8U) | frame.data[1] : frame.data[0] & 0x0FU;
        if ((kind == 1U && length >= 1U && length <= 7U) ||
            (kind == 0U && (length == 0U || length >= frame.length))) {
            return;  // no good frame: as if it had not come
        }
        if (kind == 1U && frame.length == 8U) {
            bytes_.assign(frame.data.begin() + 2, frame.data.begin() + 8);
        } else if (kind == 2U) {
            bytes_.insert(bytes_.end(), frame.data.begin() + 1, frame.data.begin() + 8);
        } else if (kind == 0U) {
            bytes_.assign(frame.data.begin() + 1, frame.data.begin() + 8);
        }
    }
    bool begins_with(const rsi::diagnosis::Request& request) const {
        bool same = request.length() <= bytes_.size();
        for (std::size_t place = 0U; same && place < request.length(); ++place) {
            same = (request.byte(place) == bytes_[place]);
        }
        return same;
    }

 private:
    std::vector<std::uint8_t> bytes_;
};

rsi::hal::CanFrame frame_from(ByteReader& reader) {
    constexpr std::array<std::uint32_t, 4> identifiers{addresses.physical_request, addresses.physical_request,
                                                       addresses.functional_request, 0x120U};
    rsi::hal::CanFrame frame{};
    frame.identifier = identifiers[reader.below(4U)];
    frame.length = static_cast<std::uint8_t>(reader.one_in(8U) ? reader.below(65U) : 8U);
    frame.extended = reader.one_in(32U);
    reader.take_into(frame.data.data(), 8U);
    return frame;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    ByteReader reader{bytes, size};
    Bus bus;
    rsi::diagnosis::IsoTp transport{bus, addresses};
    Reassembly reassembly;
    rsi::diagnosis::Response response;
    while (!reader.empty()) {
        switch (reader.below(8U)) {
            case 0U: {
                bus.room = reader.one_in(4U) ? reader.below(4U) : 8U;
                bus.sent = 0U;
                transport.end_cycle();
                require(bus.sent <= 5U, "frames of a cycle");
                break;
            }
            case 1U:
                if (!transport.is_sending()) {
                    response.begin(0U);
                    for (unsigned more = reader.below(256U); more > 0U; --more) {
                        response.put(static_cast<std::uint8_t>(more));
                    }
                    transport.send(response);
                }
                break;
            case 2U: {
                const rsi::diagnosis::Request request = transport.request();
                if (request.length() != 0U) {
                    transport.finish(request);
                }
                break;
            }
            default: {
                const rsi::hal::CanFrame frame = frame_from(reader);
                const bool was_waiting = transport.request().length() != 0U;
                const bool was_sending = transport.is_sending();
                transport.take(frame);
                if (frame.identifier == addresses.physical_request && !frame.extended && frame.length <= 8U) {
                    reassembly.take(frame, was_waiting, was_sending);
                }
                if (transport.request().is_functional()) {  // at once, so that the other one is seen
                    require(transport.request().length() <= 7U, "length of a functional request");
                    transport.finish(transport.request());
                }
                const rsi::diagnosis::Request request = transport.request();
                require(request.length() <= rsi::diagnosis::IsoTp::longest_request, "length of a request");
                if (!was_waiting && request.length() != 0U && !request.is_functional()) {
                    require(reassembly.begins_with(request), "bytes of a request");
                }
            }
        }
    }
    bus.room = 1000U;
    for (int cycle = 0; cycle < 102; ++cycle) {
        transport.end_cycle();
    }
    if (transport.is_sending()) {  // its last frames may have gone out within that time
        for (int cycle = 0; cycle < 102; ++cycle) {
            transport.end_cycle();
        }
    }
    require(!transport.is_receiving(), "it waits for ever for a frame");
    return 0;
}
