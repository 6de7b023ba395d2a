// Violations in the component, one each: the checks of this folder are shown to notice it.
#include <stddef.h>

extern "C" void* malloc(size_t size);
extern "C" float sinf(float angle);
extern "C" int printf(const char* format, ...);

#ifdef PLANT_HEAP
void* planted_heap() {
    return malloc(16U);
}
#endif

#ifdef PLANT_MATHEMATICS
float planted_mathematics(float angle) {
    return sinf(angle);
}
#endif

#ifdef PLANT_EXCEPTION
void planted_exception() {
    throw 1;
}
#endif

#ifdef PLANT_OUTPUT
int planted_output(int value) {
    return printf("%d", value);
}
#endif

#ifdef PLANT_DOUBLE
float planted_double(float value) {
    return static_cast<float>(static_cast<double>(value) * 0.1);
}
#endif
