// A calibration from any bytes: parameters that the component accepts and that can be written and read again
// to the same bits, or an error with the place.
#include <cstdint>
#include <cstring>
#include <string>

#include "rsi/parameters.hpp"
#include "sil/files/calibration_file.hpp"
#include "sil/files/parameter_section_file.hpp"
#include "tests/quality/fuzz/support/message.hpp"
#include "tests/quality/fuzz/support/require.hpp"
#include "tests/quality/fuzz/support/toml_text.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::set_toml_text({reinterpret_cast<const char*>(data), size});
    rsi::Parameters parameters{};
    try {
        parameters = sil::load_calibration(fuzz::toml_path());
    } catch (const sil::InputError& error) {
        fuzz::require_place(error.what(), fuzz::toml_path());
        return 0;
    }
    fuzz::require(rsi::validate(parameters).accepted == 1, "the component accepts what was read");
    const std::string text = sil::calibration_toml(parameters);
    fuzz::set_toml_text(text);
    const rsi::Parameters again = sil::load_calibration(fuzz::toml_path());
    fuzz::require(std::memcmp(&again, &parameters, sizeof again) == 0, "what was written reads as the same");
    return 0;
}
