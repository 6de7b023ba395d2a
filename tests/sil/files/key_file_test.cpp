// Key files: the right key or a message that says what to do, and never the key.
#include "sil/files/key_file.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <string>

#include "hal/software_keys/software_keys.hpp"
#include "sil/input_error.hpp"

namespace testing_key_file {
namespace {

class KeyFile : public ::testing::Test {
 protected:
    ~KeyFile() override { std::remove(path_.c_str()); }

    void write(const std::string& text) { std::ofstream{path_} << text; }
    std::string refusal() {
        try {
            sil::load_key(path_, rsi::hal::KeySlot::parameters);
        } catch (const sil::InputError& error) {
            return error.what();
        }
        return "none";
    }

    std::string path_{testing::TempDir() + "/keys_" + std::to_string(getpid()) + ".toml"};
};

TEST_F(KeyFile, GivesTheKeyOfTheSlot) {
    write(
        "diagnosis = \"000102030405060708090a0b0c0d0e0f\"\n"
        "parameters = \"F0E1D2C3B4A5968778695a4b3c2d1e0f\"\n");
    EXPECT_EQ(sil::load_key(path_, rsi::hal::KeySlot::diagnosis),
              (rsi::hal::Key{0U, 1U, 2U, 3U, 4U, 5U, 6U, 7U, 8U, 9U, 10U, 11U, 12U, 13U, 14U, 15U}));
    EXPECT_EQ(sil::load_key(path_, rsi::hal::KeySlot::parameters),
              (rsi::hal::Key{0xF0U, 0xE1U, 0xD2U, 0xC3U, 0xB4U, 0xA5U, 0x96U, 0x87U, 0x78U, 0x69U, 0x5AU,
                             0x4BU, 0x3CU, 0x2DU, 0x1EU, 0x0FU}));
    EXPECT_THROW(sil::load_key(path_, rsi::hal::KeySlot::calibration), sil::InputError);
}

TEST_F(KeyFile, NeedNotBeThereForTheTestKey) {
    EXPECT_EQ(sil::load_key("test", rsi::hal::KeySlot::calibration), rsi::hal::test_keys[0]);
    EXPECT_EQ(sil::load_key("test", rsi::hal::KeySlot::parameters), rsi::hal::test_keys[2]);
}

TEST_F(KeyFile, IsRefusedWithItsLineAndWithoutTheKey) {
    for (const char* const key : {"", "00112233445566778899aabbccddeef", "00112233445566778899aabbccddeeff0",
                                  "0g112233445566778899aabbccddeeff", "00112233445566778899aabbccddee/f",
                                  "00112233445566778899aabbccddee:f", "00112233445566778899aabbccddee@f",
                                  "00112233445566778899aabbccddee`f"}) {
        write(std::string{"parameters = \""} + key + "\"\n");
        const std::string said = refusal();
        EXPECT_NE(said.find(path_ + ":1: \"parameters\" is no key of AES-128: write 32 hexadecimal digits"),
                  std::string::npos)
            << said;
        EXPECT_EQ(said.find("112233"), std::string::npos) << said;
    }
    write("parameter = \"00112233445566778899aabbccddeeff\"\n");
    EXPECT_NE(refusal().find("\"parameter\" is not known here"), std::string::npos);
    write("diagnosis = \"00112233445566778899aabbccddeeff\"\n");
    EXPECT_NE(refusal().find("parameters"), std::string::npos);
}

}  // namespace
}  // namespace testing_key_file
