/* Made by tests/targets/integration/renew; do not edit. */
#define RSI_SELFTEST_EXPECTED_DIGEST 0x393D5A9BU
