// Standard streams: that closed ones do no harm, and that lost output is no success.
#pragma once

#include <string_view>

namespace sil {

// To be called first. A stream that the caller has closed leaves its number to the next file that is opened,
// which would then get what is printed; so the number is taken by something that can be neither read nor
// written.
void occupy_closed_streams();

// To be called last. Zero, or after a sentence on stderr one if not all that was printed has reached stdout.
int finish_output(std::string_view program);

}  // namespace sil
