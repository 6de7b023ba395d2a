// Diagnosis access: what a workshop's way into the firmware needs on a host.
#pragma once

#include <filesystem>
#include <string>

#include "access/seed_and_key.hpp"
#include "diagnosis/diagnosis.hpp"
#include "diagnosis/section_store.hpp"
#include "hal/linux/system_random.hpp"
#include "hal/software_keys/software_keys.hpp"
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
                    hal::Storage* section)
        : one_{folder, "diagnosis_1.bin"},
          other_{folder, "diagnosis_2.bin"},
          attempts_{folder, "diagnosis_attempts.bin"},
          own_section_{folder, "parameters.bin"},
          store_{(section != nullptr) ? *section : own_section_} {
        seed_and_key_.start();
        identification_.software_version = diagnosis::text_of<diagnosis::ShortText>(RSI_VERSION);
        identification_.hardware = diagnosis::text_of<diagnosis::ShortText>("Linux host");
        calibration_name.copy(identification_.calibration_name.data(),
                              identification_.calibration_name.size());
    }
    DiagnosisAccess(const DiagnosisAccess&) = delete;
    DiagnosisAccess& operator=(const DiagnosisAccess&) = delete;

    diagnosis::SectionStore& store() { return store_; }
    access_control::SeedAndKey& seed_and_key() { return seed_and_key_; }
    const diagnosis::Identification& identification() const { return identification_; }
    const hal::KeyStore& keys() const { return keys_; }
    hal::Storage& one() { return one_; }
    hal::Storage& other() { return other_; }

 private:
    NvFile one_;
    NvFile other_;
    NvFile attempts_;
    NvFile own_section_;
    diagnosis::SectionStore store_;
    hal::SoftwareKeys keys_{hal::test_keys};
    hal::SystemRandom random_{};
    access_control::SeedAndKey seed_and_key_{keys_, hal::KeySlot::diagnosis, random_, attempts_};
    diagnosis::Identification identification_{};
};

}  // namespace sil
