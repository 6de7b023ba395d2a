// EcuOutput: what the ECU's frames said, decoded: the latest message of each kind.
#pragma once

#include <limits>
#include <tuple>

#include "rsi/can_dbc/generated/rollover_warning.hpp"
#include "sil/judge/warning.hpp"

namespace sil {

using RollSource = rsi::can_dbc::RollObserver::RollSource;  // of the roll angle in use

template <typename List>
class LatestOf;

template <typename... Messages>
class LatestOf<rsi::can_dbc::MessageList<Messages...>> {
 public:
    template <typename Message>
    Message& of() {
        return std::get<Message>(messages_);
    }
    template <typename Message>
    const Message& of() const {
        return std::get<Message>(messages_);
    }

 private:
    std::tuple<Messages...> messages_{};
};

// A value that the frame called "not available", or that has never been received, is NaN.
class EcuOutput : public LatestOf<rsi::can_dbc::MessagesFromRolloverEcu> {
 public:
    static constexpr double not_available = std::numeric_limits<double>::quiet_NaN();

    rsi::can_dbc::RolloverWarning& warning() { return of<rsi::can_dbc::RolloverWarning>(); }
    const rsi::can_dbc::RolloverWarning& warning() const { return of<rsi::can_dbc::RolloverWarning>(); }
    WarningState state() const { return warning().state; }
    WarningSide side() const { return warning().side; }
};

}  // namespace sil
