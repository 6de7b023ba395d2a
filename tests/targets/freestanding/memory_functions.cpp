// The three functions that a compiler may call of its own accord to copy and clear objects; nothing else is
// supplied.
#include <stddef.h>

extern "C" void* memcpy(void* to, const void* from, size_t size) {
    for (size_t i = 0; i < size; ++i) {
        static_cast<unsigned char*>(to)[i] = static_cast<const unsigned char*>(from)[i];
    }
    return to;
}

extern "C" void* memset(void* to, int value, size_t size) {
    for (size_t i = 0; i < size; ++i) {
        static_cast<unsigned char*>(to)[i] = static_cast<unsigned char>(value);
    }
    return to;
}

extern "C" void* memmove(void* to, const void* from, size_t size) {
    unsigned char* const target = static_cast<unsigned char*>(to);
    const unsigned char* const source = static_cast<const unsigned char*>(from);
    if (target < source) {
        return memcpy(to, from, size);
    }
    for (size_t i = size; i > 0U; --i) {
        target[i - 1U] = source[i - 1U];
    }
    return to;
}
