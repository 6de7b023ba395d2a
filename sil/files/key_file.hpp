// Key file: the keys of a control unit, as TOML. Each is 32 hexadecimal digits: `calibration` (XCP),
// `diagnosis` (UDS), `parameters` (the seal of a parameter section). A file may have only those that its
// reader needs.
#pragma once

#include <filesystem>

#include "hal/software_keys/cmac.hpp"
#include "rsi/hal/key_store.hpp"

namespace sil {

// In place of a file: the public test key.
inline constexpr const char* test_key_name = "test";

// The file's key for `slot`. Throws InputError that names the file and what is wrong, and never what is in
// it.
rsi::hal::Key load_key(const std::filesystem::path& path, rsi::hal::KeySlot slot);

}  // namespace sil
