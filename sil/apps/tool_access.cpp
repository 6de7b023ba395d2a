#include "sil/apps/tool_access.hpp"

#include "sil/files/parameter_section_file.hpp"

namespace sil {

CalibrationAccess::CalibrationAccess(const rsi::Parameters& parameters, const std::string& name,
                                     const std::filesystem::path& folder)
    : section_{parameter_section(parameters, name)},
      attempts_{folder, "xcp_attempts.bin"},
      one_{folder, "xcp_parameters_1.bin"},
      other_{folder, "xcp_parameters_2.bin"} {
    seed_and_key_.start();
}

}  // namespace sil
