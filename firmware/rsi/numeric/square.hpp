// A number times itself.
#pragma once

namespace rsi {

constexpr float square(float x) {
    return x * x;
}

}  // namespace rsi
