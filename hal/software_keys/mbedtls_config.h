/* Used part of Mbed TLS: the block cipher, with its tables in read-only memory. */
#ifndef HAL_SOFTWARE_KEYS_MBEDTLS_CONFIG_H
#define HAL_SOFTWARE_KEYS_MBEDTLS_CONFIG_H

#define MBEDTLS_AES_C
#define MBEDTLS_AES_ROM_TABLES
#define MBEDTLS_AES_FEWER_TABLES

#endif
