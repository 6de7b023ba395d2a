// rsi-ecu-r5f-faults: the same firmware with a way to break it, to test what it does then. For the emulator;
// never flashed.
//
// A frame with the identifier 0x7F0 provokes the fault that its first byte names.
#include <cstdint>

#include "images/zynqmp_r5/ecu_image.hpp"
#include "images/zynqmp_r5/warning_recorder.hpp"

namespace {

constexpr std::uint32_t fault_identifier = 0x7F0U;

enum class Provocation : std::uint8_t {
    read_nowhere = 1,           // data abort: no region
    write_code = 2,             // data abort: permission
    undefined_instruction = 3,  // undefined instruction
    supervisor_call = 4,        // supervisor call
    execute_data = 5,           // prefetch abort: permission
    stack_overflow = 6,         // data abort in the guard of the stack
    hang = 7,                   // watchdog
    call_null = 8,              // start without reset
};

void (*volatile null_function)() = nullptr;
volatile std::uint32_t word = 0xE12F'FF1EU;  // bx lr, should it ever be executed

[[gnu::noinline]] std::uint32_t descend(std::uint32_t depth) {
    volatile std::uint32_t frame[16];
    frame[depth % 16U] = depth;
    return depth == 0U ? 0U : descend(depth - 1U) + frame[depth % 16U];
}

void provoke(Provocation provocation) {
    switch (provocation) {
        case Provocation::read_nowhere:
            word = *reinterpret_cast<volatile std::uint32_t*>(0x4000'0000U);
            break;
        case Provocation::write_code:
            *reinterpret_cast<volatile std::uint32_t*>(RSI_CODE_START) = word;
            break;
        case Provocation::undefined_instruction:
            asm volatile("udf #0");
            break;
        case Provocation::supervisor_call:
            asm volatile("svc #0" : : : "lr");
            break;
        case Provocation::execute_data:
            reinterpret_cast<void (*)()>(reinterpret_cast<std::uintptr_t>(&word))();
            break;
        case Provocation::stack_overflow:
            word = descend(1000U);
            break;
        case Provocation::hang:
            for (;;) {
                word = word + 1U;
            }
        case Provocation::call_null:
            null_function();
            break;
        default:
            break;
    }
}

class FaultyBus final : public rsi::hal::CanBus {
 public:
    FaultyBus(rsi::hal::CanBus& bus, rsi::image::LastWarning& last) noexcept : bus_{bus, last} {}

    rsi::hal::ReceiveResult receive(rsi::hal::CanFrame& frame) noexcept override {
        const rsi::hal::ReceiveResult result = bus_.receive(frame);
        if (result == rsi::hal::ReceiveResult::frame && frame.identifier == fault_identifier) {
            provoke(static_cast<Provocation>(frame.data[0]));
        }
        return result;
    }
    rsi::hal::SendResult send(const rsi::hal::CanFrame& frame) noexcept override { return bus_.send(frame); }
    rsi::hal::BusState state() const noexcept override { return bus_.state(); }
    rsi::hal::BusStatistics statistics() const noexcept override { return bus_.statistics(); }

 private:
    rsi::image::WarningRecorder bus_;
};

rsi::image::EcuImage<FaultyBus> ecu;

}  // namespace

int main() {
    ecu.run(rsi::image::unfiltered_can_settings());
}
