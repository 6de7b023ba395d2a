// Building blocks of a mutated source: every place that can be mutated asks here which mutant is active.
// Included before everything else of a mutated build, and of no other.
//
// Each `site` is the number of the site's first mutant; its others follow. Code that the compiler evaluates
// is never mutated, so that constexpr functions stay usable where a constant is needed.
#pragma once

#include <type_traits>

namespace mutation {

extern int active;             // the mutant that is alive; 0: none
extern bool recording;         // executed in a run without a mutant
extern unsigned char* record;  // a byte for each mutant

enum Recorded : unsigned char {
    executed = 1U,   // its place was executed
    differing = 3U,  // and what it makes there was not what is made without it
};

// A statement or a connector: what it changes shows only when it is alive.
template <int mutant>
constexpr bool on() {
    if (__builtin_is_constant_evaluated()) {
        return false;
    }
    if (recording) {
        record[mutant] = differing;
    }
    return active == mutant;
}

template <typename T>
bool is_same(const T& a, const T& b) {
    if constexpr (std::is_floating_point_v<T>) {
        return __builtin_memcmp(&a, &b, sizeof a) == 0;
    } else {
        return a == b;
    }
}

template <int mutant, typename T>
constexpr T either(T original, T mutated) {
    if (__builtin_is_constant_evaluated()) {
        return original;
    }
    if (recording) {
        record[mutant] |= is_same(original, mutated) ? executed : differing;
    }
    return (active == mutant) ? mutated : original;
}

enum class Swap { plus, minus, times, over, rest, left, right, bit_and, bit_or, bit_xor };

constexpr Swap swapped(Swap operation) {
    switch (operation) {
        case Swap::plus:
            return Swap::minus;
        case Swap::minus:
            return Swap::plus;
        case Swap::times:
            return Swap::over;
        case Swap::over:
        case Swap::rest:
            return Swap::times;
        case Swap::left:
            return Swap::right;
        case Swap::right:
            return Swap::left;
        case Swap::bit_and:
            return Swap::bit_or;
        default:
            return Swap::bit_and;
    }
}

template <Swap operation, typename A, typename B>
constexpr auto operate(A a, B b) {
    if constexpr (operation == Swap::plus) {
        return a + b;
    } else if constexpr (operation == Swap::minus) {
        return a - b;
    } else if constexpr (operation == Swap::times) {
        return a * b;
    } else if constexpr (operation == Swap::over) {
        return a / b;
    } else if constexpr (operation == Swap::rest) {
        return a % b;
    } else if constexpr (operation == Swap::left) {
        return a << b;
    } else if constexpr (operation == Swap::right) {
        return a >> b;
    } else if constexpr (operation == Swap::bit_and) {
        return a & b;
    } else if constexpr (operation == Swap::bit_or) {
        return a | b;
    } else {
        return a ^ b;
    }
}

template <int site, Swap operation, typename A, typename B>
constexpr auto arithmetic(A a, B b) {
    if (__builtin_is_constant_evaluated()) {
        return operate<operation>(a, b);
    }
    constexpr Swap other = swapped(operation);
    if constexpr ((other == Swap::over) && std::is_integral_v<B>) {
        if (b == B{}) {  // the mutant crashes
            if (on<site>()) {
                __builtin_trap();
            }
            return operate<operation>(a, b);
        }
    }
    return either<site>(operate<operation>(a, b), operate<other>(a, b));
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
    if constexpr ((relation == Relation::less) && std::is_class_v<A>) {  // which may have no operator but <
        return either<site + 1>(either<site>(a < b, !(b < a)), !(a < b));
    } else if constexpr (relation == Relation::less) {
        return either<site + 1>(either<site>(a < b, a <= b), !(a < b));
    } else if constexpr (relation == Relation::less_equal) {
        return either<site + 1>(either<site>(a <= b, a < b), !(a <= b));
    } else if constexpr (relation == Relation::greater) {
        return either<site + 1>(either<site>(a > b, a >= b), !(a > b));
    } else if constexpr (relation == Relation::greater_equal) {
        return either<site + 1>(either<site>(a >= b, a > b), !(a >= b));
    } else if constexpr (relation == Relation::equal) {
        return either<site>(a == b, !(a == b));
    } else {
        return either<site>(a != b, !(a != b));
    }
}

template <int site, typename T>
constexpr bool negated(const T& condition) {
    return either<site>(static_cast<bool>(condition), !static_cast<bool>(condition));
}

// Never refused.
template <int site, typename T>
constexpr bool never(const T& condition) {
    return either<site>(static_cast<bool>(condition), false);
}

template <int site, typename T>
constexpr auto minus(T value) {
    return either<site>(-value, +value);
}

// An integer by one up, one down, and to zero; one that is 0 or 1 only up and down.
template <int site, typename T>
constexpr T small_integer(T value) {
    if (__builtin_is_constant_evaluated()) {
        return value;
    }
    return either<site + 1>(either<site>(value, static_cast<T>(value + T{1})), static_cast<T>(value - T{1}));
}
template <int site, typename T>
constexpr T integer(T value) {
    return either<site + 2>(small_integer<site>(value), T{});
}

template <int site, typename T>
constexpr T real(T value) {
    if (__builtin_is_constant_evaluated()) {
        return value;
    }
    const T step = (value == T{}) ? T{1} : value / T{10};
    return either<site + 1>(either<site>(value, value + step), value - step);
}

template <int site, typename T>
constexpr T returned(T value) {
    if constexpr (std::is_same_v<T, bool>) {
        return either<site>(value, !value);
    } else if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T>) {
        return either<site>(value, T{});
    } else {
        return value;
    }
}

// First mutant: the first argument; second: the second one.
template <int site>
struct Smaller {
    constexpr float operator()(float a, float b) const {
        return either<site + 1>(either<site>((a < b) ? a : b, a), b);
    }
};
template <int site>
struct Larger {
    constexpr float operator()(float a, float b) const {
        return either<site + 1>(either<site>((a > b) ? a : b, a), b);
    }
};
template <int site>
struct Least {
    template <typename T>
    constexpr T operator()(const T& a, const T& b) const {
        return either<site + 1>(either<site>((b < a) ? b : a, a), b);
    }
};
template <int site>
struct Greatest {
    template <typename T>
    constexpr T operator()(const T& a, const T& b) const {
        return either<site + 1>(either<site>((a < b) ? b : a, a), b);
    }
};
// First mutant: no lower bound; second: no upper one.
template <int site>
struct Clamp {
    template <typename... Numbers>
    constexpr auto operator()(Numbers... numbers) const {
        return bounded<std::common_type_t<Numbers...>>(numbers...);
    }

 private:
    template <typename T>
    static constexpr T bounded(T value, T minimum, T maximum) {
        const T below = (value > maximum) ? maximum : value;
        const T above = (value < minimum) ? minimum : value;
        return either<site + 1>(either<site>((value < minimum) ? minimum : below, below), above);
    }
};
template <int site>
struct ClampMagnitude {
    constexpr float operator()(float value, float limit) const {
        const float bounded = (__builtin_fabsf(value) > limit) ? ((value < 0.0F) ? -limit : limit) : value;
        return either<site>(bounded, value);
    }
};
template <int site>
struct Absolute {
    constexpr float operator()(float value) const { return either<site>(__builtin_fabsf(value), value); }
};

}  // namespace mutation
