// Allocation: a step of the vehicle takes no memory from the heap.
#include <gtest/gtest.h>
#include <cstdlib>
#include <new>

#include "scenario.hpp"
#include "sil/world/manoeuvres/catalogue.hpp"

namespace {

std::size_t allocations = 0;

}  // namespace

// Not inlined, or the compiler takes malloc and delete for a mismatched pair.
[[gnu::noinline]] void* operator new(std::size_t size) {
    ++allocations;
    if (void* memory = std::malloc(size == 0U ? 1U : size)) {
        return memory;
    }
    throw std::bad_alloc{};
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
    std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}

namespace {

TEST(Allocation, AStepTakesNoMemoryFromTheHeapEvenWhileRollingOver) {
    sil::ManoeuvreRun run{scenario::large_suv(), sil::find_manoeuvre("j-turn-110")};
    const std::size_t before = allocations;
    ASSERT_GT(before, 0U) << "the counter does not count";
    while (!run.finished()) {
        run.step();
    }
    EXPECT_EQ(allocations, before);
}

TEST(Allocation, AStepOfAnyManoeuvreTakesNoMemoryFromTheHeap) {
    for (const sil::Manoeuvre& manoeuvre : sil::all_manoeuvres()) {
        sil::RunOptions options;
        options.duration_s = 4.0;
        sil::ManoeuvreRun run{scenario::large_suv(), manoeuvre, options};
        const std::size_t before = allocations;
        while (!run.finished()) {
            run.step();
        }
        EXPECT_EQ(allocations, before) << manoeuvre.name;
    }
}

}  // namespace
