/* Configuration of Mbed TLS (MBEDTLS_CONFIG_FILE): AES alone. Its lookup tables are constants (ROM_TABLES)
 * instead of computed in RAM at the first use, and each of them once instead of rotated four times
 * (FEWER_TABLES), which saves 6 KiB of ROM and costs speed. Its CMAC is left out, because it allocates from
 * the heap: cmac.hpp. Table lookups take a time that depends on the key where there is a data cache:
 * docs/security.md. */
#ifndef HAL_SOFTWARE_KEYS_MBEDTLS_CONFIG_H
#define HAL_SOFTWARE_KEYS_MBEDTLS_CONFIG_H

#define MBEDTLS_AES_C
#define MBEDTLS_AES_ROM_TABLES
#define MBEDTLS_AES_FEWER_TABLES

#endif
