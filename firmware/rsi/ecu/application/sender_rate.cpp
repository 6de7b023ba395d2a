#include "rsi/ecu/application/sender_rate.hpp"

namespace rsi::application {
namespace {

constexpr std::int32_t cycle_ms = 10;          // taken from the surplus
constexpr std::int32_t frame_ms = 9;           // added: below 10, so that clock tolerances do not add up
constexpr std::int32_t most_frames = 4;        // counted in one cycle; more are a burst
constexpr std::int32_t most_usual_frames = 2;  // without a burst
constexpr std::int32_t usual_least_ms = -30;   // lower end while frames arrive as usual
constexpr std::int32_t most_ms = 60;           // upper end, at which the rate counts as doubled

constexpr std::int32_t bounded(std::int32_t value, std::int32_t least, std::int32_t most) {
    const std::int32_t at_most = (value < most) ? value : most;
    return (at_most > least) ? at_most : least;
}

}  // namespace

void SenderRate::update() noexcept {
    const std::int32_t frames = bounded(frames_, 0, most_frames);
    const bool pausing = (frames == 0);
    const bool usual = !pausing && !paused_ && (frames <= most_usual_frames);
    const std::int32_t surplus_ms =
        bounded(surplus_ms_ + frames * frame_ms - cycle_ms, usual ? usual_least_ms : least_ms, most_ms);
    const bool settled = (surplus_ms == surplus_ms_) && (pausing == paused_);
    settled_frames_ = settled ? frames_ : none;
    surplus_ms_ = static_cast<std::int16_t>(surplus_ms);
    doubled_ = (surplus_ms == most_ms) || (doubled_ && (surplus_ms > 0));
    paused_ = pausing;
}

void SenderRate::miss(std::uint32_t cycles) noexcept {
    constexpr auto most_cycles = static_cast<std::uint32_t>((most_ms - least_ms) / cycle_ms);
    const auto missed_ms =
        static_cast<std::int32_t>((cycles < most_cycles) ? cycles : most_cycles) * cycle_ms;
    surplus_ms_ = static_cast<std::int16_t>(bounded(surplus_ms_ - missed_ms, least_ms, most_ms));
    settled_frames_ = none;
    paused_ = true;
}

}  // namespace rsi::application
