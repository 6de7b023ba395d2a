#include "sil/apps/tool_access.hpp"

#include "rsi/version.h"
#include "sil/files/key_file.hpp"
#include "sil/files/parameter_section_file.hpp"

namespace sil {
namespace {

// Zeros for the other slots, which nothing uses.
rsi::hal::Keys keys_with(rsi::hal::KeySlot slot, const std::filesystem::path& file) {
    rsi::hal::Keys keys{};
    keys[static_cast<std::size_t>(slot)] = load_key(file, slot);
    return keys;
}

}  // namespace

CalibrationAccess::CalibrationAccess(const rsi::Parameters& parameters, const std::string& name,
                                     const std::filesystem::path& folder, const std::filesystem::path& key)
    : section_{parameter_section(parameters, name)},
      attempts_{folder, "xcp_attempts.bin"},
      one_{folder, "xcp_parameters_1.bin"},
      other_{folder, "xcp_parameters_2.bin"},
      keys_{keys_with(rsi::hal::KeySlot::calibration, key)} {
    seed_and_key_.start();
}

DiagnosisAccess::DiagnosisAccess(const std::string& calibration_name, const std::filesystem::path& folder,
                                 rsi::application::SectionRecord* section, const std::filesystem::path& key)
    : one_{folder, "diagnosis_1.bin"},
      other_{folder, "diagnosis_2.bin"},
      attempts_{folder, "diagnosis_attempts.bin"},
      section_one_{folder, "parameters_1.bin"},
      section_other_{folder, "parameters_2.bin"},
      store_{(section != nullptr) ? *section : own_section_},
      keys_{keys_with(rsi::hal::KeySlot::diagnosis, key)} {
    seed_and_key_.start();
    identification_.software_version = rsi::diagnosis::text_of<rsi::diagnosis::ShortText>(RSI_VERSION);
    identification_.hardware = rsi::diagnosis::text_of<rsi::diagnosis::ShortText>("Linux host");
    calibration_name.copy(identification_.calibration_name.data(), identification_.calibration_name.size());
}

}  // namespace sil
