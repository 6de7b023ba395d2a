// ECU loop: the host's main loop around the application, on a tick of 10 ms or in lock-step.
#pragma once

#include <csignal>
#include <string>

#include "rsi/types.hpp"

namespace sil {

struct EcuRequest {
    std::string interface{"can0"};
    bool lock_step{false};
    int fifo_priority{0};  // 0: the scheduling stays as it is
    bool lock_memory{false};
    bool xcp{false};                // XCP on CAN answers
    std::string xcp_storage;        // folder of what XCP stores; empty: nowhere
    bool diagnosis{false};          // UDS on ISO-TP answers, and trouble codes are kept
    std::string diagnosis_storage;  // folder of what is kept; empty: nowhere
    std::string calibration_name;   // for a tester
    std::string key{"test"};        // key file of both, or `test`
    bool receive_everything{
        false};  // no filters in the kernel: foreign frames reach the firmware, which drops them
};

// Runs until `end_requested` is not zero, then prints how punctual the cycle was. Throws std::runtime_error
// with a message for the user when the interface cannot be opened, the real-time settings are refused, or the
// watchdog expires.
void run_ecu(const EcuRequest& request, const rsi::Parameters& parameters,
             const volatile std::sig_atomic_t& end_requested);

}  // namespace sil
