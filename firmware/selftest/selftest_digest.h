/* Made by tests/targets/integration/renew; do not edit. */
#define RSI_SELFTEST_EXPECTED_DIGEST 0x8C543EA4U
