// What a mutated source is made of: every place that can be mutated asks here which mutant is active.
// Included before everything else of a mutated build, and of no other.
//
// Each `site` is the number of the site's first mutant; its others follow. What the compiler evaluates is
// never mutated, so that constexpr functions stay usable where a constant is needed.
#pragma once

#include <type_traits>

namespace mutation {

extern int active;               // the mutant that is alive; 0: none
extern unsigned char* executed;  // a byte for each mutant: its place was executed

template <int mutant>
constexpr bool on() {
    if (__builtin_is_constant_evaluated()) {
        return false;
    }
    executed[mutant] = 1U;
    return active == mutant;
}

enum class Swap { plus, minus, times, over, rest, left, right, bit_and, bit_or, bit_xor };

template <int site, Swap operation, typename A, typename B>
constexpr auto arithmetic(A a, B b) {
    if constexpr (operation == Swap::plus) {
        return on<site>() ? a - b : a + b;
    } else if constexpr (operation == Swap::minus) {
        return on<site>() ? a + b : a - b;
    } else if constexpr (operation == Swap::times) {
        return on<site>() ? a / b : a * b;
    } else if constexpr (operation == Swap::over) {
        return on<site>() ? a * b : a / b;
    } else if constexpr (operation == Swap::rest) {
        return on<site>() ? a * b : a % b;
    } else if constexpr (operation == Swap::left) {
        return on<site>() ? a >> b : a << b;
    } else if constexpr (operation == Swap::right) {
        return on<site>() ? a << b : a >> b;
    } else if constexpr (operation == Swap::bit_and) {
        return on<site>() ? a | b : a & b;
    } else if constexpr (operation == Swap::bit_or) {
        return on<site>() ? a & b : a | b;
    } else {
        return on<site>() ? a & b : a ^ b;
    }
}

template <int site, Swap operation, typename A, typename B>
constexpr A& compound(A& a, B b) {
    a = static_cast<A>(arithmetic<site, operation>(a, b));
    return a;
}

enum class Relation { less, less_equal, greater, greater_equal, equal, unequal };

// First mutant of the ordering ones: the bound changes sides; second: the opposite, which for NaN is true.
template <int site, Relation relation, typename A, typename B>
constexpr bool compare(const A& a, const B& b) {
    if constexpr (relation == Relation::less) {
        return on<site>() ? a <= b : (on<site + 1>() ? !(a < b) : a < b);
    } else if constexpr (relation == Relation::less_equal) {
        return on<site>() ? a < b : (on<site + 1>() ? !(a <= b) : a <= b);
    } else if constexpr (relation == Relation::greater) {
        return on<site>() ? a >= b : (on<site + 1>() ? !(a > b) : a > b);
    } else if constexpr (relation == Relation::greater_equal) {
        return on<site>() ? a > b : (on<site + 1>() ? !(a >= b) : a >= b);
    } else if constexpr (relation == Relation::equal) {
        return on<site>() ? !(a == b) : a == b;
    } else {
        return on<site>() ? !(a != b) : a != b;
    }
}

// The same for a class that has no operator but <.
template <int site, typename A>
constexpr bool class_less(const A& a, const A& b) {
    return on<site>() ? !(b < a) : (on<site + 1>() ? !(a < b) : a < b);
}

template <int site>
constexpr bool negated(bool condition) {
    return condition != on<site>();
}

template <int site, typename T>
constexpr auto minus(T value) {
    return on<site>() ? value : -value;
}

template <int site, typename T>
constexpr T integer(T value) {
    if (on<site>()) {
        return static_cast<T>(value + T{1});
    }
    if (on<site + 1>()) {
        return static_cast<T>(value - T{1});
    }
    return on<site + 2>() ? T{} : value;
}

template <int site, typename T>
constexpr T real(T value) {
    const T step = (value == T{}) ? T{1} : value / T{10};
    return on<site>() ? value + step : (on<site + 1>() ? value - step : value);
}

template <int site, typename T>
constexpr T returned(T value) {
    if constexpr (std::is_same_v<T, bool>) {
        return value != on<site>();
    } else if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T>) {
        return on<site>() ? T{} : value;
    } else {
        return value;
    }
}

// First mutant: the first argument; second: the second one.
template <int site>
struct Smaller {
    constexpr float operator()(float a, float b) const {
        return on<site>() ? a : (on<site + 1>() ? b : ((a < b) ? a : b));
    }
};
template <int site>
struct Larger {
    constexpr float operator()(float a, float b) const {
        return on<site>() ? a : (on<site + 1>() ? b : ((a < b) ? b : a));
    }
};
// First mutant: no lower bound; second: no upper one.
template <int site>
struct Clamp {
    constexpr float operator()(float value, float minimum, float maximum) const {
        if ((value < minimum) && !on<site>()) {
            return minimum;
        }
        return ((value > maximum) && !on<site + 1>()) ? maximum : value;
    }
};
template <int site>
struct ClampMagnitude {
    constexpr float operator()(float value, float limit) const {
        if (on<site>()) {
            return value;
        }
        return (__builtin_fabsf(value) > limit) ? ((value < 0.0F) ? -limit : limit) : value;
    }
};
template <int site>
struct Absolute {
    constexpr float operator()(float value) const { return on<site>() ? value : __builtin_fabsf(value); }
};

}  // namespace mutation
