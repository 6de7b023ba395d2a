#include "sil/studies/faults/memory_map.hpp"

#include <array>

#include "rsi/ecu/application/rollover_ecu.hpp"

namespace sil {
namespace {

struct Member {
    const char* name;
    std::size_t length;
    std::size_t alignment;
    bool is_address{false};
};

template <typename Type>
constexpr Member member(const char* name) {
    return {name, sizeof(Type), alignof(Type)};
}

template <typename Type>
constexpr Member address(const char* name) {
    return {name, sizeof(Type*), alignof(Type*), true};
}

// The members are private. Structures with the same members in the same order lie in memory as they do; a
// member that is added or left out in one place only shows in the size.
constexpr std::array component_members{
    Member{"component: initialised", sizeof(std::uint32_t), alignof(rsi::Derived)},
    member<rsi::Derived>("component: derived numbers"),
    member<std::array<bool, 2>>("component: flags"),
    member<float>("component: extended RSI"),
    member<rsi::MeasurementStage>("component: measurement"),
    member<rsi::RollMotionFilter>("component: motion filter"),
    member<rsi::FixedModelRoll>("component: fixed model"),
    member<rsi::CompensatedModelRoll>("component: compensated model"),
    member<rsi::RollCentreEstimator>("component: estimator"),
    member<rsi::TyreLimit>("component: tyre limit"),
    member<rsi::MomentArmError>("component: moment arm error"),
    member<rsi::LinearForecast>("component: linear forecast"),
    member<rsi::LoadAdaptation>("component: load adaptation"),
    member<rsi::WarningStateMachine>("component: warning")};

constexpr Member platform{"platform", 3U * sizeof(void*), alignof(void*), true};
constexpr std::array ecu_members{
    member<rsi::Parameters>("parameters"),
    Member{"listeners", 2U * sizeof(void*), alignof(void*), true},
    Member{"reception", sizeof(rsi::application::SensorReception) - 2U * sizeof(void*),
           alignof(rsi::application::SensorReception)},
    member<rsi::application::WarningTransmission>("transmission"),
    member<rsi::monitoring::DiagnosticMemory>("diagnostic memory"),
    member<rsi::monitoring::InputMonitor>("input monitor"),
    member<rsi::monitoring::ParameterGuard>("parameter guard"),
    member<rsi::monitoring::MemoryGuard<rsi::Component>>("memory guard"),
    member<rsi::monitoring::ClockCheck>("clock check"),
    address<rsi::hal::Storage>("storage"),
    Member{"load keeper", sizeof(rsi::application::LoadKeeper) - sizeof(void*), alignof(std::uint32_t)},
    member<rsi::application::CalibrationIdentity>("calibration's identity"),
    member<rsi::Inputs>("inputs"),
    member<rsi::Outputs>("outputs"),
    member<rsi::monitoring::CodeSet>("tests of every cycle"),
    member<std::array<std::uint32_t, 8>>("health")};

constexpr std::size_t after(std::size_t end, const Member& next) {
    return (end + next.alignment - 1U) / next.alignment * next.alignment;
}

template <std::size_t count>
constexpr std::size_t end_of(const std::array<Member, count>& members, std::size_t end) {
    for (const Member& one : members) {
        end = after(end, one) + one.length;
    }
    return end;
}

constexpr std::size_t component_end = platform.length + sizeof(rsi::Component);

static_assert(end_of(component_members, 0U) == sizeof(rsi::Component), "as in rsi/component.hpp");
static_assert(after(end_of(ecu_members, component_end), platform) == sizeof(rsi::application::RolloverEcu),
              "as in rsi/ecu/application/rollover_ecu.hpp");

void add(std::vector<MemoryPart>& parts, const Member& next, std::size_t& end) {
    const std::size_t begin = after(end, next);
    if (!parts.empty()) {
        parts.back().length = begin - parts.back().begin;
    }
    end = begin + next.length;
    parts.push_back({next.name, begin, next.length, next.is_address});
}

}  // namespace

std::vector<MemoryPart> memory_map() {
    std::vector<MemoryPart> parts;
    std::size_t end = 0U;
    add(parts, platform, end);
    for (const Member& stage : component_members) {
        add(parts, stage, end);
    }
    for (const Member& one : ecu_members) {
        add(parts, one, end);
    }
    parts.back().length = sizeof(rsi::application::RolloverEcu) - parts.back().begin;
    return parts;
}

MemoryPart component_memory() {
    return {"component", platform.length, sizeof(rsi::Component), false};
}

}  // namespace sil
