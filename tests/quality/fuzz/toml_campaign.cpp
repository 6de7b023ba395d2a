// Settings of a campaign from any bytes: settings that pass their own check and can be written and read
// again, or an error with the place.
#include <cstdint>
#include <string>
#include <string_view>

#include "sil/studies/campaign/settings.hpp"
#include "sil/world/manoeuvres/catalogue.hpp"
#include "sil/world/manoeuvres/mixed_driving.hpp"
#include "tests/quality/fuzz/support/message.hpp"
#include "tests/quality/fuzz/support/require.hpp"
#include "tests/quality/fuzz/support/toml_text.hpp"

// These stand for the manoeuvres, which need the whole simulated vehicle and are none of the reader's
// business.
sil::Manoeuvre sil::ordinary_driving(std::uint64_t /*seed*/, double /*duration_s*/,
                                     double /*share_of_acceleration*/) {
    return {};
}

sil::Manoeuvre sil::find_manoeuvre(std::string_view name) {
    if (name.empty() ||
        name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") != std::string_view::npos) {
        throw UnknownManoeuvre("unknown manoeuvre");
    }
    return {};
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::set_toml_text({reinterpret_cast<const char*>(data), size});
    sil::CampaignSettings settings;
    try {
        settings = sil::load_campaign(fuzz::toml_path());
    } catch (const sil::InputError& error) {
        fuzz::require_place(error.what(), fuzz::toml_path());
        return 0;
    }
    sil::check_campaign(settings);
    const std::string text = sil::to_toml(settings);
    fuzz::set_toml_text(text);
    fuzz::require(sil::to_toml(sil::load_campaign(fuzz::toml_path())) == text,
                  "what was written reads as the same");
    return 0;
}
