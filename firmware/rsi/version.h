/* The version of the component, a copy of project(rsi VERSION ...); cmake/version.cmake compares them. */
#ifndef RSI_VERSION_H
#define RSI_VERSION_H

#define RSI_VERSION "0.2.0"
#define RSI_VERSION_MAJOR 0
#define RSI_VERSION_MINOR 2
#define RSI_VERSION_PATCH 0

/* Major and minor number in one byte, four bits each. */
#define RSI_VERSION_BYTE 2

#endif
