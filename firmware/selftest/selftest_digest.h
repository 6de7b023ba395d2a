/* Made by tests/targets/integration/renew; do not edit. */
#define RSI_SELFTEST_EXPECTED_DIGEST 0x8A6DDDC7U
