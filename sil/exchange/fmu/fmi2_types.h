/* Requirements of FMI 2.0 on a co-simulation FMU, as far as fmi2.cpp needs it: the types of the standard, in
 * words of our own, so that a build needs no foreign headers. If the standard's headers are on the include
 * path they are taken instead, and the compiler compares every function with them. */
#ifndef RSI_FMI2_TYPES_H
#define RSI_FMI2_TYPES_H

#if __has_include("fmi2Functions.h")

#include "fmi2Functions.h"
#define RSI_FMI2_EXPORT extern "C" FMI2_Export

#else

#include <cstddef>

using fmi2Component = void*;
using fmi2ComponentEnvironment = void*;
using fmi2FMUstate = void*;
using fmi2ValueReference = unsigned int;
using fmi2Real = double;
using fmi2Integer = int;
using fmi2Boolean = int;
using fmi2Char = char;
using fmi2String = const fmi2Char*;
using fmi2Byte = char;

enum fmi2Status { fmi2OK, fmi2Warning, fmi2Discard, fmi2Error, fmi2Fatal, fmi2Pending };
enum fmi2Type { fmi2ModelExchange, fmi2CoSimulation };
enum fmi2StatusKind { fmi2DoStepStatus, fmi2PendingStatus, fmi2LastSuccessfulTime, fmi2Terminated };

using fmi2CallbackLogger = void (*)(fmi2ComponentEnvironment, fmi2String instance_name, fmi2Status,
                                    fmi2String category, fmi2String message, ...);

struct fmi2CallbackFunctions {
    fmi2CallbackLogger logger;
    void* (*allocateMemory)(std::size_t count, std::size_t size);
    void (*freeMemory)(void*);
    void (*stepFinished)(fmi2ComponentEnvironment, fmi2Status);
    fmi2ComponentEnvironment componentEnvironment;
};

#define RSI_FMI2_EXPORT extern "C" __attribute__((visibility("default")))

#endif

#endif
