// Calibration access: what XCP of the firmware needs on a host.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "access/seed_and_key.hpp"
#include "application/parameter_section.hpp"
#include "hal/linux/system_random.hpp"
#include "hal/software_keys/software_keys.hpp"
#include "rsi/types.hpp"
#include "sil/apps/nv_file.hpp"

namespace sil {

// The key is the test key, which is public.
class CalibrationAccess {
 public:
    // `folder`: where the stored section and the count of wrong keys are kept; empty: in memory only.
    CalibrationAccess(const rsi::Parameters& parameters, const std::filesystem::path& folder);
    CalibrationAccess(const CalibrationAccess&) = delete;
    CalibrationAccess& operator=(const CalibrationAccess&) = delete;

    const hal::KeyStore& keys() const { return keys_; }
    access_control::SeedAndKey& seed_and_key() { return seed_and_key_; }
    hal::Storage& stored_section() { return stored_section_; }
    const std::vector<std::uint8_t>& section() const { return section_; }  // the reference page

 private:
    std::vector<std::uint8_t> section_;
    NvFile attempts_;
    NvFile stored_section_;
    hal::SoftwareKeys keys_{hal::test_keys};
    hal::SystemRandom random_{};
    access_control::SeedAndKey seed_and_key_{keys_, hal::KeySlot::calibration, random_, attempts_};
};

}  // namespace sil
