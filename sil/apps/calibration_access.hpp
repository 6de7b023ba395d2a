// Calibration access: what XCP of the firmware needs on a host.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "hal/linux/system_random.hpp"
#include "hal/software_keys/software_keys.hpp"
#include "rsi/ecu/access/seed_and_key.hpp"
#include "rsi/ecu/application/parameter_section.hpp"
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

    const rsi::hal::KeyStore& keys() const { return keys_; }
    rsi::access::SeedAndKey& seed_and_key() { return seed_and_key_; }
    rsi::hal::Storage& stored_section() { return stored_section_; }
    const std::vector<std::uint8_t>& section() const { return section_; }  // the reference page

 private:
    std::vector<std::uint8_t> section_;
    NvFile attempts_;
    NvFile stored_section_;
    rsi::hal::SoftwareKeys keys_{rsi::hal::test_keys};
    rsi::hal::SystemRandom random_{};
    rsi::access::SeedAndKey seed_and_key_{keys_, rsi::hal::KeySlot::calibration, random_, attempts_};
};

}  // namespace sil
