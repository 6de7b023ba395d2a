// Kept record: a storage of the firmware on a host.
#pragma once

#include <filesystem>
#include <optional>

#include "hal/linux/file_storage.hpp"
#include "hal/memory/memory_storage.hpp"

namespace sil {

// A file, or memory that lasts as long as this.
class NvFile final : public rsi::hal::Storage {
 public:
    // Without a folder in memory.
    NvFile(const std::filesystem::path& folder, const char* name) {
        if (!folder.empty()) {
            file_.emplace((folder / name).string());
        }
    }

    bool read(std::uint8_t* bytes, std::size_t length) noexcept override {
        return file_ ? file_->read(bytes, length) : memory_.read(bytes, length);
    }
    bool write(const std::uint8_t* bytes, std::size_t length) noexcept override {
        return file_ ? file_->write(bytes, length) : memory_.write(bytes, length);
    }

 private:
    static constexpr std::size_t longest = 512U;

    std::optional<rsi::hal::FileStorage> file_;
    rsi::hal::MemoryStorage<longest> memory_;
};

}  // namespace sil
