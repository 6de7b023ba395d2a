// The heap that the textbook's least squares needs: newlib's malloc on a fixed piece of memory. Part of no
// image but the comparison.
#include <stddef.h>

namespace {

alignas(8) char heap[65536];
size_t used = 0U;

}  // namespace

extern "C" void* _sbrk(ptrdiff_t more) {
    const size_t wanted = used + static_cast<size_t>(more);
    if (wanted > sizeof(heap)) {
        return reinterpret_cast<void*>(-1);
    }
    void* const before = heap + used;
    used = wanted;
    return before;
}
