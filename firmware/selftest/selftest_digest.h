/* Made by tests/targets/integration/renew; do not edit. */
#define RSI_SELFTEST_EXPECTED_DIGEST 0xBA5AF5A4U
