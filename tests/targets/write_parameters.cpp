// A calibration in the form that replay_frames reads: write_parameters TOML OUT.
#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <exception>
#include <fstream>
#include <stdexcept>

#include "sil/files/calibration_file.hpp"

namespace {

void write(const char* toml, const char* out) {
    const rsi::Parameters parameters = sil::load_calibration(toml);
    std::array<std::uint32_t, sizeof(parameters) / sizeof(std::uint32_t)> words{};
    std::memcpy(words.data(), &parameters, sizeof(parameters));
    std::ofstream file{out};
    for (const std::uint32_t word : words) {
        file << fmt::format("{:08X}\n", word);
    }
    file.close();
    if (!file) {
        throw std::runtime_error{fmt::format("{}: cannot be written", out)};
    }
}

}  // namespace

int main(int argc, char** argv) {
    try {
        if (argc != 3) {
            throw std::runtime_error{"want TOML OUT"};
        }
        write(argv[1], argv[2]);
        return 0;
    } catch (const std::exception& error) {
        fmt::print(stderr, "write_parameters: {}\n", error.what());
        return 1;
    }
}
