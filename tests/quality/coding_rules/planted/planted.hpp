// Declarations of the planted violations, so that a missing declaration is no second violation.
#pragma once

#include <cstdint>

namespace planted {

std::uint32_t violation(std::uint32_t value);
std::int32_t signed_violation(std::int32_t value);
float float_violation(float value);
bool is_violation(std::uint32_t value);
const std::uint32_t* pointer_violation(const std::uint32_t* value);
void use(std::uint32_t value);

enum class Colour : std::uint8_t { red, green, blue };
std::uint32_t colour_violation(Colour colour);

// Declarations for single files.
std::uint32_t bits_of(const float& value);
void clear(const std::uint32_t& value);
bool is_null(const std::uint32_t* value);
std::uint32_t sum(std::uint32_t count, ...);
std::uint8_t low_byte(std::uint32_t value);
bool is_small(float value);
bool is_level(float value);
std::uint32_t one(std::uint32_t value);
std::uint32_t read(std::uint32_t* value);
std::uint32_t start();
void use_all(const std::uint32_t* values);
[[nodiscard]] bool has_started(std::uint32_t value);
extern const std::uint32_t shared_table[2];
extern std::uint32_t total;

class Shape {
 public:
    Shape(const Shape&) = delete;
    Shape& operator=(const Shape&) = delete;
    virtual std::uint32_t corners() const = 0;

 protected:
    Shape() = default;
    ~Shape() = default;
};
std::uint32_t corners_of(const Shape& shape);

}  // namespace planted
