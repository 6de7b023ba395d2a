// A question for the type at run time.
// Caught by: clang compile-error, clang-diagnostic-error, g++ compile-error, run-time-type
#include "tests/quality/coding_rules/planted/planted.hpp"

namespace planted {

namespace {

class Square final : public Shape {
 public:
    explicit Square(std::uint32_t corners) : corners_{corners} {}
    std::uint32_t corners() const override { return corners_; }

 private:
    std::uint32_t corners_;
};

}  // namespace

std::uint32_t corners_of(const Shape& shape) {
    const auto* const square = dynamic_cast<const Square*>(&shape);
    return (square != nullptr) ? square->corners() : Square{3U}.corners();
}

}  // namespace planted
