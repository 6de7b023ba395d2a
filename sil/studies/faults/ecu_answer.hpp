// ECU answer: what the ECU's frames of one cycle said, and whether all of them were there and sound.
#pragma once

#include <bitset>
#include <cstddef>
#include <string>
#include <vector>

#include "rsi/can_dbc/generated/rollover_warning.hpp"
#include "rsi/hal/can_bus.hpp"
#include "sil/results/ecu_output.hpp"

namespace sil {

// Remaining abilities of the component.
using Degradation = rsi::can_dbc::RolloverDiagnosis::Degradation;

// A set, one bit each: the flags of RolloverStatus, the observer's contradiction of the roll sensor, and the
// codes of RolloverDiagnosis that are confirmed. A bit that it has no room for is an exception.
using DiagnosticCodes = std::bitset<128U>;

// The name of a bit.
std::string diagnostic_name(std::size_t bit);

// The names of all in the set, the lowest first.
std::vector<std::string> diagnostic_names(DiagnosticCodes codes);

struct EcuAnswer {
    bool complete{false};  // each frame of the ECU once, protected as it must be
    bool defined{true};    // no code that the DBC file does not define
    std::size_t frames{0U};
    WarningState state{WarningState::unavailable};
    WarningSide side{WarningSide::none};
    RollSource roll_source{RollSource::none};
    Degradation degradation{Degradation::unavailable};
    DiagnosticCodes codes{};
};

// Reads the ECU's frames from the bus, cycle by cycle. A cycle carries one diagnostic code only, so a
// confirmed code counts until a later cycle carries it as healed, or none at all.
class EcuAnswerReader {
 public:
    // Reads what waits on the world's end of the bus.
    EcuAnswer read(rsi::hal::CanBus& world);

 private:
    template <typename Message>
    void take(const rsi::hal::CanFrame& frame, EcuAnswer& answer);
    void keep(const rsi::can_dbc::RolloverWarning& message, EcuAnswer& answer) const;
    void keep(const rsi::can_dbc::RollObserver& message, EcuAnswer& answer) const;
    void keep(const rsi::can_dbc::RolloverStatus& message, EcuAnswer& answer) const;
    void keep(const rsi::can_dbc::RolloverDiagnosis& message, EcuAnswer& answer);
    template <typename Message>
    void keep(const Message&, EcuAnswer&) const {}

    DiagnosticCodes confirmed_{};
};

}  // namespace sil
