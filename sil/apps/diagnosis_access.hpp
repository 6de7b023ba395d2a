// Diagnosis access: what a workshop's way into the firmware needs on a host.
#pragma once

#include <filesystem>
#include <string>

#include "hal/linux/system_random.hpp"
#include "hal/software_keys/software_keys.hpp"
#include "rsi/ecu/access/seed_and_key.hpp"
#include "rsi/ecu/diagnosis/diagnosis.hpp"
#include "rsi/ecu/diagnosis/section_store.hpp"
#include "rsi/version.h"
#include "sil/apps/nv_file.hpp"

namespace sil {

// The key is the test key, which is public.
class DiagnosisAccess {
 public:
    // `folder`: where trouble codes, identification, the downloaded section and the count of wrong keys are
    // kept; empty: in memory only. `section`: where XCP stores its section, if it does, and then a download
    // too.
    DiagnosisAccess(const std::string& calibration_name, const std::filesystem::path& folder,
                    rsi::hal::Storage* section)
        : one_{folder, "diagnosis_1.bin"},
          other_{folder, "diagnosis_2.bin"},
          attempts_{folder, "diagnosis_attempts.bin"},
          own_section_{folder, "parameters.bin"},
          store_{(section != nullptr) ? *section : own_section_} {
        seed_and_key_.start();
        identification_.software_version = rsi::diagnosis::text_of<rsi::diagnosis::ShortText>(RSI_VERSION);
        identification_.hardware = rsi::diagnosis::text_of<rsi::diagnosis::ShortText>("Linux host");
        calibration_name.copy(identification_.calibration_name.data(),
                              identification_.calibration_name.size());
    }
    DiagnosisAccess(const DiagnosisAccess&) = delete;
    DiagnosisAccess& operator=(const DiagnosisAccess&) = delete;

    rsi::diagnosis::SectionStore& store() { return store_; }
    rsi::access::SeedAndKey& seed_and_key() { return seed_and_key_; }
    const rsi::diagnosis::Identification& identification() const { return identification_; }
    const rsi::hal::KeyStore& keys() const { return keys_; }
    rsi::hal::Storage& one() { return one_; }
    rsi::hal::Storage& other() { return other_; }

 private:
    NvFile one_;
    NvFile other_;
    NvFile attempts_;
    NvFile own_section_;
    rsi::diagnosis::SectionStore store_;
    rsi::hal::SoftwareKeys keys_{rsi::hal::test_keys};
    rsi::hal::SystemRandom random_{};
    rsi::access::SeedAndKey seed_and_key_{keys_, rsi::hal::KeySlot::diagnosis, random_, attempts_};
    rsi::diagnosis::Identification identification_{};
};

}  // namespace sil
