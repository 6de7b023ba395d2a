// A calibration from any bytes: parameters that the component accepts and that can be written and read again
// to the same bits, or an error with the place.
#include <cstdint>
#include <cstring>
#include <string>

#include "rsi/parameters.hpp"
#include "sil/calibration/calibration_file.hpp"
#include "sil/calibration/parameter_section_file.hpp"
#include "tests/fuzz/support/memory_file.hpp"
#include "tests/fuzz/support/message.hpp"
#include "tests/fuzz/support/require.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static fuzz::MemoryFile file;
    file.write(data, size);
    rsi::Parameters parameters{};
    try {
        parameters = sil::load_calibration(file.path());
    } catch (const sil::CalibrationError& error) {
        fuzz::require_place(error.what(), file.path());
        return 0;
    }
    fuzz::require(rsi::validate(parameters).accepted == 1, "the component accepts what was read");
    const std::string text = sil::calibration_toml(parameters);
    file.write(text.data(), text.size());
    const rsi::Parameters again = sil::load_calibration(file.path());
    fuzz::require(std::memcmp(&again, &parameters, sizeof again) == 0, "what was written reads as the same");
    return 0;
}
