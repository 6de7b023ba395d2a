// Replaces the C library's allocator by one that counts and passes on to glibc's own.
#include "tests/rsi/support/counting_allocator.hpp"

#include <atomic>
#include <cerrno>
#include <cstddef>

extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* block, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
void __libc_free(void* block);
}

namespace {

std::atomic<unsigned long> calls{0UL};

}  // namespace

unsigned long rsi_test::heap_calls() {
    return calls.load();
}

extern "C" void* malloc(std::size_t size) noexcept {
    ++calls;
    return __libc_malloc(size);
}

extern "C" void* calloc(std::size_t count, std::size_t size) noexcept {
    ++calls;
    return __libc_calloc(count, size);
}

extern "C" void* realloc(void* block, std::size_t size) noexcept {
    ++calls;
    return __libc_realloc(block, size);
}

extern "C" void* memalign(std::size_t alignment, std::size_t size) noexcept {
    ++calls;
    return __libc_memalign(alignment, size);
}

extern "C" void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
    ++calls;
    return __libc_memalign(alignment, size);
}

extern "C" int posix_memalign(void** block, std::size_t alignment, std::size_t size) noexcept {
    ++calls;
    *block = __libc_memalign(alignment, size);
    return (*block != nullptr) ? 0 : ENOMEM;
}

extern "C" void free(void* block) noexcept {
    ++calls;
    __libc_free(block);
}
