// Live server: the page of a live drive on this machine's own address, and the drive's clock.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>

#include "sil/live/live_session.hpp"

namespace sil {

// Serves until `stop` is true. It listens on 127.0.0.1 alone, on `port` or, when that is 0, on a free one,
// and calls `listening` with the port. In real time, the session's cycle is called every 10 ms; what a busy
// machine could not keep up with for a quarter of a second is left out, and the drive is that much slower.
//
// Answered is who names this machine as its host; a drive is for a page that came from here. The last page
// that came drives. A request's head may have 8 KiB, a message 1 KiB; a client silent for five seconds is
// disconnected, as are more than 32 at once.
//
// Throws InputError when the port cannot be had, and what the session throws.
void serve_live(LiveSession& session, std::uint16_t port, const std::atomic<bool>& stop,
                const std::function<void(std::uint16_t)>& listening);

// The same for one page that needs nothing else, such as that of a finished run.
void serve_page(const std::string& page, std::uint16_t port, const std::atomic<bool>& stop,
                const std::function<void(std::uint16_t)>& listening);

}  // namespace sil
