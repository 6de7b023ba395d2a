// Tool access: what XCP and diagnosis of the firmware need on a host. Keys are those of a key file, or the
// public test keys.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "hal/linux/file_storage.hpp"
#include "hal/linux/system_random.hpp"
#include "hal/memory/memory_storage.hpp"
#include "hal/software_keys/software_keys.hpp"
#include "rsi/ecu/access/seed_and_key.hpp"
#include "rsi/ecu/application/section_record.hpp"
#include "rsi/ecu/diagnosis/diagnosis.hpp"
#include "rsi/ecu/diagnosis/section_store.hpp"
#include "rsi/types.hpp"

namespace sil {

// Storage of the firmware on a host: a file, or memory that lasts as long as this.
class NvFile final : public rsi::hal::Storage {
 public:
    // Without a folder in memory.
    NvFile(const std::filesystem::path& folder, const char* name) {
        if (!folder.empty()) {
            file_.emplace((folder / name).string());
        }
    }

    rsi::hal::Reading read(std::uint8_t* bytes, std::size_t length) noexcept override {
        return file_ ? file_->read(bytes, length) : memory_.read(bytes, length);
    }
    bool write(const std::uint8_t* bytes, std::size_t length) noexcept override {
        return file_ ? file_->write(bytes, length) : memory_.write(bytes, length);
    }

 private:
    static constexpr std::size_t longest = 2048U;
    static_assert(sizeof(rsi::diagnosis::KeptPayload) + 64U <= longest, "and what a record has besides");

    std::optional<rsi::hal::FileStorage> file_;
    rsi::hal::MemoryStorage<longest> memory_;
};

// For XCP. `key`: a key file, or test_key_name; InputError for one that cannot be used.
class CalibrationAccess {
 public:
    // `folder`: where the stored section and the count of wrong keys are kept; empty: in memory only.
    CalibrationAccess(const rsi::Parameters& parameters, const std::string& name,
                      const std::filesystem::path& folder, const std::filesystem::path& key);
    CalibrationAccess(const CalibrationAccess&) = delete;
    CalibrationAccess& operator=(const CalibrationAccess&) = delete;

    const rsi::hal::KeyStore& keys() const { return keys_; }
    rsi::access::SeedAndKey& seed_and_key() { return seed_and_key_; }
    rsi::application::SectionRecord& stored_section() { return stored_section_; }
    const std::vector<std::uint8_t>& section() const { return section_; }  // the reference page

 private:
    std::vector<std::uint8_t> section_;
    NvFile attempts_;
    NvFile one_;
    NvFile other_;
    rsi::application::SectionRecord stored_section_{one_, other_};
    rsi::hal::SoftwareKeys keys_;
    rsi::hal::SystemRandom random_{};
    rsi::access::SeedAndKey seed_and_key_{keys_, rsi::hal::KeySlot::calibration, random_, attempts_};
};

// For a workshop's tester.
class DiagnosisAccess {
 public:
    // `folder`: where trouble codes, identification, the downloaded section and the count of wrong keys are
    // kept; empty: in memory only. `section`: where XCP stores its section, if it does, and then a download
    // too.
    DiagnosisAccess(const std::string& calibration_name, const std::filesystem::path& folder,
                    rsi::application::SectionRecord* section, const std::filesystem::path& key);
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
    NvFile section_one_;
    NvFile section_other_;
    rsi::application::SectionRecord own_section_{section_one_, section_other_};
    rsi::diagnosis::SectionStore store_;
    rsi::hal::SoftwareKeys keys_;
    rsi::hal::SystemRandom random_{};
    rsi::access::SeedAndKey seed_and_key_{keys_, rsi::hal::KeySlot::diagnosis, random_, attempts_};
    rsi::diagnosis::Identification identification_{};
};

}  // namespace sil
