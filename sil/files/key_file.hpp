// Key file: the keys of a control unit, as TOML. Each is 32 hexadecimal digits: `calibration` (XCP),
// `diagnosis` (UDS), `parameters` (the seal of a parameter section). A file may have only those that its
// reader needs.
#pragma once

#include <filesystem>

#include "hal/interface/key_store.hpp"
#include "hal/software_keys/cmac.hpp"

namespace sil {

// In place of a file: the public test key.
inline constexpr const char* test_key_name = "test";

// The file's key for `slot`. Throws InputError that names the file and what is wrong, and never what is in
// it.
hal::Key load_key(const std::filesystem::path& path, hal::KeySlot slot);

}  // namespace sil
