#include "hal/software_keys/cmac.hpp"

#include <mbedtls/aes.h>

#include "mbedtls/platform_util.h"

namespace rsi::hal {
namespace {

constexpr std::size_t block_length = 16U;
using Block = std::array<std::uint8_t, block_length>;

class Aes {
 public:
    explicit Aes(const Key& key) noexcept {
        mbedtls_aes_init(&context_);
        is_good_ = (mbedtls_aes_setkey_enc(&context_, key.data(), 128U) == 0);
    }
    Aes(const Aes&) = delete;
    Aes& operator=(const Aes&) = delete;
    ~Aes() { mbedtls_aes_free(&context_); }  // overwrites the round keys

    void encrypt(Block& block) noexcept {
        Block encrypted{};
        is_good_ = is_good_ && (mbedtls_aes_crypt_ecb(&context_, MBEDTLS_AES_ENCRYPT, block.data(),
                                                      encrypted.data()) == 0);
        block = encrypted;
    }

    bool is_good() const noexcept { return is_good_; }

 private:
    mbedtls_aes_context context_{};
    bool is_good_{false};
};

// Times x in the field of 2^128 elements (RFC 4493, 2.3), in a time that does not depend on the bits.
Block doubled(const Block& block) {
    Block result{};
    std::uint32_t carry = 0U;
    for (std::size_t byte = block_length; byte > 0U; --byte) {
        const std::uint32_t shifted = (static_cast<std::uint32_t>(block[byte - 1U]) << 1U) | carry;
        result[byte - 1U] = static_cast<std::uint8_t>(shifted & 0xFFU);
        carry = shifted >> 8U;
    }
    result[block_length - 1U] = static_cast<std::uint8_t>(result[block_length - 1U] ^ (carry * 0x87U));
    return result;
}

void add(Block& sum, const std::uint8_t* bytes, std::size_t length) {
    for (std::size_t byte = 0U; byte < length; ++byte) {
        sum[byte] = static_cast<std::uint8_t>(sum[byte] ^ bytes[byte]);
    }
}

}  // namespace

bool cmac(const Key& key, const std::uint8_t* bytes, std::size_t length, AuthenticationCode& code) noexcept {
    Aes aes{key};
    Block mask{};
    aes.encrypt(mask);
    mask = doubled(mask);  // K1, for a last block that is full

    Block sum{};
    std::size_t place = 0U;
    for (; (length - place) > block_length; place += block_length) {
        add(sum, bytes + place, block_length);
        aes.encrypt(sum);
    }
    const std::size_t rest = length - place;
    add(sum, bytes + place, rest);
    if (rest < block_length) {
        sum[rest] = static_cast<std::uint8_t>(sum[rest] ^ 0x80U);
        mask = doubled(mask);  // K2
    }
    add(sum, mask.data(), block_length);
    aes.encrypt(sum);
    mbedtls_platform_zeroize(mask.data(), mask.size());  // K2 or K1 forge codes
    if (aes.is_good()) {
        code = sum;
    }
    return aes.is_good();
}

}  // namespace rsi::hal
