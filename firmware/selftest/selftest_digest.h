/* Made by tests/targets/integration/renew; do not edit. */
#define RSI_SELFTEST_EXPECTED_DIGEST 0xDF59DF66U
