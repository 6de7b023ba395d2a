#include "sil/apps/calibration_access.hpp"

#include "sil/files/parameter_section_file.hpp"

namespace sil {

CalibrationAccess::Record::Record(const std::filesystem::path& folder, const char* name) {
    if (!folder.empty()) {
        file_.emplace((folder / name).string());
    }
}

bool CalibrationAccess::Record::read(std::uint8_t* bytes, std::size_t length) noexcept {
    return file_ ? file_->read(bytes, length) : memory_.read(bytes, length);
}

bool CalibrationAccess::Record::write(const std::uint8_t* bytes, std::size_t length) noexcept {
    return file_ ? file_->write(bytes, length) : memory_.write(bytes, length);
}

CalibrationAccess::CalibrationAccess(const rsi::Parameters& parameters, const std::filesystem::path& folder)
    : section_{parameter_section(parameters, "rsi-ecu")},
      attempts_{folder, "xcp_attempts.bin"},
      stored_section_{folder, "xcp_parameters.bin"} {
    seed_and_key_.start();
}

}  // namespace sil
