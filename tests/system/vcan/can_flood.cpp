// can_flood: foreign traffic on a CAN interface at a given rate.
// Use: can_flood INTERFACE FRAMES_PER_SECOND SECONDS
// Sends by absolute time, a batch each millisecond, and catches up when it was held up. Prints how many
// frames it sent in what time; fails when the interface takes none.
#include <linux/can.h>
#include <linux/can/raw.h>
#include <net/if.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "hal/linux/steady_clock.hpp"

namespace {

// None of these is a frame of this project's database; 0x300 and up do not win against the ECU's on a real
// bus either.
constexpr canid_t first_identifier{0x300U};
constexpr std::uint32_t identifier_count{256U};
constexpr std::uint32_t largest_batch{64U};

[[noreturn]] void give_up(const char* action) {
    std::fprintf(stderr, "can_flood: %s: %s\n", action, std::strerror(errno));
    std::exit(1);
}

class Sender {
 public:
    explicit Sender(const char* interface) : descriptor_{socket(PF_CAN, SOCK_RAW, CAN_RAW)} {
        setsockopt(descriptor_, SOL_CAN_RAW, CAN_RAW_FILTER, nullptr, 0);  // hears nothing
        sockaddr_can address{};
        address.can_family = AF_CAN;
        address.can_ifindex = static_cast<int>(if_nametoindex(interface));
        if (address.can_ifindex == 0 ||
            bind(descriptor_, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) != 0) {
            give_up(interface);
        }
    }
    ~Sender() { close(descriptor_); }
    Sender(const Sender&) = delete;
    Sender& operator=(const Sender&) = delete;

    void send(std::uint32_t count) {
        for (std::uint32_t i = 0U; i < count; ++i) {
            can_frame& frame = frames_[i];
            frame.can_id = first_identifier + (sent_ + i) % identifier_count;
            frame.can_dlc = 8U;
            const std::uint32_t number = sent_ + i;
            std::memcpy(frame.data, &number, sizeof(number));
            parts_[i] = {&frame, sizeof(frame)};
            messages_[i].msg_hdr.msg_iov = &parts_[i];
            messages_[i].msg_hdr.msg_iovlen = 1U;
        }
        const int taken = sendmmsg(descriptor_, messages_.data(), count, 0);
        if (taken < 0) {
            give_up("sending");
        }
        sent_ += static_cast<std::uint32_t>(taken);
    }
    std::uint32_t sent() const { return sent_; }

 private:
    int descriptor_;
    std::uint32_t sent_{0U};
    std::array<can_frame, largest_batch> frames_{};
    std::array<iovec, largest_batch> parts_{};
    std::array<mmsghdr, largest_batch> messages_{};
};

std::int64_t due(std::int64_t rate, rsi::hal::Time elapsed) {
    return rate * (elapsed.nanoseconds / 1000) / 1'000'000;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 4) {
        std::fputs("Use: can_flood INTERFACE FRAMES_PER_SECOND SECONDS\n", stderr);
        return 2;
    }
    const std::int64_t rate = std::atoll(argv[2]);
    const rsi::hal::Time duration = rsi::hal::Time::from_milliseconds(1000 * std::atoll(argv[3]));
    Sender sender{argv[1]};
    const rsi::hal::SteadyClock clock;
    const rsi::hal::Time start = clock.now();
    rsi::hal::Time elapsed{};
    for (rsi::hal::Time next = start; elapsed < duration;
         next = next + rsi::hal::Time::from_milliseconds(1)) {
        clock.wait_until(next);
        elapsed = clock.now() - start;
        const std::int64_t end = due(rate, elapsed < duration ? elapsed : duration);
        while (sender.sent() < end) {
            const std::int64_t left = end - sender.sent();
            sender.send(left < largest_batch ? static_cast<std::uint32_t>(left) : largest_batch);
        }
    }
    const double seconds = static_cast<double>((clock.now() - start).nanoseconds) * 1.0e-9;
    std::printf("%u frames in %.3f s\n", sender.sent(), seconds);
    return 0;
}
