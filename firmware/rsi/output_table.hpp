// Output table: rsi_outputs.h for C++. Values that follow from its rows alone.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "rsi/numeric/bounded.hpp"
#include "rsi/rsi_outputs.h"
#include "rsi/types.hpp"

namespace rsi {

// The words of the table; rsi_outputs.h explains them.
enum class Mirror : std::uint8_t { turns, stays };
enum class Presence : std::uint8_t { always, estimate, sometimes };
enum class Risk : std::uint8_t { statement, detail };
enum class LevelScale : std::uint8_t { same, magnitude, per_ssf, complement, limit_over };
enum class RiskSide : std::uint8_t { own, both, force, acceleration, predicted, roll };

struct CodeOutput {
    const char* name;
    std::int32_t Outputs::* member;
    std::int32_t reset;
    std::int32_t largest;
    Risk risk;
};

struct NumberOutput {
    const char* name;
    const char* unit;
    float Outputs::* member;
    Mirror mirror;
    Presence presence;
    Risk risk;
};

// How an index drives the warning. Its name stands apart, in `indicator_choices`: a controller does not need
// it.
struct IndexOutput {
    rsi_indicator number;
    float Outputs::* member;
    LevelScale scale;
    RiskSide side;
};

// The rows of one kind, by leaving out the others.
#define RSI_NOTHING(...)
#define RSI_CODE(name, reset, largest, risk, meaning) \
    CodeOutput{#name, &Outputs::name, reset, largest, Risk::risk},
#define RSI_NUMBER(name, unit, mirror, presence, risk, meaning) \
    NumberOutput{#name, unit, &Outputs::name, Mirror::mirror, Presence::presence, Risk::risk},
#define RSI_INDEX_NUMBER(name, unit, mirror, CHOICE, number, choice, scale, side, meaning) \
    RSI_NUMBER(name, unit, mirror, always, detail, meaning)
#define RSI_INDEX_LEVEL(name, unit, mirror, CHOICE, number, choice, scale, side, meaning) \
    IndexOutput{RSI_INDICATOR_##CHOICE, &Outputs::name, LevelScale::scale, RiskSide::side},
#define RSI_INDEX_CHOICE(name, unit, mirror, CHOICE, number, choice, scale, side, meaning) #choice,

// Counted, not deduced: gcc 12 puts a table whose type it has deduced into RAM.
#define RSI_ONE(...) +1U
inline constexpr std::size_t code_count = 0U RSI_OUTPUTS(RSI_ONE, RSI_NOTHING, RSI_NOTHING);
inline constexpr std::size_t number_count = 0U RSI_OUTPUTS(RSI_NOTHING, RSI_ONE, RSI_ONE);
inline constexpr std::size_t index_count = 0U RSI_OUTPUTS(RSI_NOTHING, RSI_NOTHING, RSI_ONE);
#undef RSI_ONE
static_assert(sizeof(Outputs) == 4U * (code_count + number_count),
              "rsi.h does not have the rows of rsi_outputs.h: run firmware/rsi/write_outputs");

inline constexpr std::array<CodeOutput, code_count> code_outputs{
    {RSI_OUTPUTS(RSI_CODE, RSI_NOTHING, RSI_NOTHING)}};

// Every float of rsi_outputs, in its order.
inline constexpr std::array<NumberOutput, number_count> number_outputs{
    {RSI_OUTPUTS(RSI_NOTHING, RSI_NUMBER, RSI_INDEX_NUMBER)}};

// By their numbers.
inline constexpr std::array<IndexOutput, index_count> index_outputs{
    {RSI_OUTPUTS(RSI_NOTHING, RSI_NOTHING, RSI_INDEX_LEVEL)}};
inline constexpr std::array<const char*, index_count> indicator_choices{
    {RSI_OUTPUTS(RSI_NOTHING, RSI_NOTHING, RSI_INDEX_CHOICE)}};

#undef RSI_INDEX_CHOICE
#undef RSI_INDEX_LEVEL
#undef RSI_INDEX_NUMBER
#undef RSI_NUMBER
#undef RSI_CODE

constexpr bool index_numbers_count_from_zero() {
    std::size_t in_place = 0U;
    for (std::size_t index = 0U; index < index_outputs.size(); ++index) {
        in_place += static_cast<std::size_t>(static_cast<std::size_t>(index_outputs[index].number) == index);
    }
    return in_place == index_outputs.size();
}
static_assert(index_numbers_count_from_zero(), "an index stands in the place of its number");

// The functions below are written out row by row: a loop over the tables would take their texts into a
// controller.

// Outputs of a component before its first step.
inline Outputs no_outputs() noexcept {
    Outputs outputs{};
#define RSI_CODE(name, reset, ...) outputs.name = reset;
#define RSI_NUMBER(name, ...) outputs.name = not_available;
    RSI_OUTPUTS(RSI_CODE, RSI_NUMBER, RSI_NUMBER)
#undef RSI_NUMBER
#undef RSI_CODE
    return outputs;
}

// Takes back what is said of the risk.
inline void reset_statement(Outputs& outputs) noexcept {
#define RSI_CODE(name, reset, largest, risk, meaning) \
    if constexpr (Risk::risk == Risk::statement) {    \
        outputs.name = reset;                         \
    }
#define RSI_NUMBER(name, unit, mirror, presence, risk, meaning) \
    if constexpr (Risk::risk == Risk::statement) {              \
        outputs.name = not_available;                           \
    }
    RSI_OUTPUTS(RSI_CODE, RSI_NUMBER, RSI_NOTHING)
#undef RSI_NUMBER
#undef RSI_CODE
}

constexpr bool is_known(std::int32_t code, std::int32_t largest) {
    return (code >= 0) && (code <= largest);
}

constexpr bool is_sound(float number, Presence presence) {
    return (presence != Presence::always) || is_finite(number);
}

// Whether every code is one that there is, and every number that is always there is finite. Those of the
// estimate are not looked at: they have a range, which rsi/ecu/monitoring/output_check.hpp knows.
constexpr bool are_codes_known_and_numbers_finite(const Outputs& outputs) noexcept {
#define RSI_CODE(name, reset, largest, risk, meaning) \
    if (!is_known(outputs.name, largest)) {           \
        return false;                                 \
    }
#define RSI_NUMBER(name, unit, mirror, presence, risk, meaning) \
    if (!is_sound(outputs.name, Presence::presence)) {          \
        return false;                                           \
    }
#define RSI_INDEX(name, ...)        \
    if (!is_finite(outputs.name)) { \
        return false;               \
    }
    RSI_OUTPUTS(RSI_CODE, RSI_NUMBER, RSI_INDEX)
    return true;
#undef RSI_INDEX
#undef RSI_NUMBER
#undef RSI_CODE
}

#undef RSI_NOTHING

}  // namespace rsi
