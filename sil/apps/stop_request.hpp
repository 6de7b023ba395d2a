// Stop request: long work ends early and keeps what is done when its user, or the system, asks for it.
#pragma once

#include <atomic>

namespace sil {

// True from the first SIGINT or SIGTERM on. To be called before the work begins.
const std::atomic<bool>& stop_on_signals();

}  // namespace sil
