// The component never touches the heap, neither in init nor in step; and the count would show it if it did.
#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>
#include <vector>

#include "rsi/component.hpp"
#include "tests/rsi/support/counting_allocator.hpp"
#include "tests/rsi/support/nominal.hpp"
#include "tests/rsi/support/random_manoeuvre.hpp"

namespace {

using rsi_test::heap_calls;

constexpr int samples = 20000;

std::vector<rsi_inputs> manoeuvre() {
    rsi_test::RandomManoeuvre drive(rsi_test::large_suv(), 67U, true);
    std::vector<rsi_inputs> inputs;
    for (int k = 0; k < samples; ++k) {
        inputs.push_back(drive.next());
    }
    return inputs;
}

// Out of the compiler's sight, so that it keeps every allocation.
void* volatile kept = nullptr;

template <typename Use>
unsigned long calls_during(Use use) {
    const unsigned long before = heap_calls();
    use();
    return heap_calls() - before;
}

TEST(HeapUse, InitAndStepOfTheCppFaceUseNone) {
    const std::vector<rsi_inputs> inputs = manoeuvre();
    const rsi_parameters parameters = rsi_test::large_suv();
    rsi_parameters refused = parameters;
    refused.track_width_m = 0.0F;
    int warnings = 0;
    const unsigned long calls = calls_during([&] {
        rsi::Component component;
        component.init(refused);
        component.init(parameters);
        for (const rsi_inputs& input : inputs) {
            rsi_outputs outputs;
            component.step(input, outputs);
            warnings += (outputs.state == RSI_STATE_WARNING) ? 1 : 0;
        }
    });
    EXPECT_EQ(calls, 0UL);
    EXPECT_GT(warnings, 100);
}

TEST(HeapUse, InitAndStepOfTheCFaceUseNone) {
    const std::vector<rsi_inputs> inputs = manoeuvre();
    const rsi_parameters parameters = rsi_test::large_suv();
    const unsigned long calls = calls_during([&] {
        rsi_component component;
        rsi_init(&component, &parameters);
        for (const rsi_inputs& input : inputs) {
            rsi_outputs outputs;
            rsi_step(&component, &input, &outputs);
        }
    });
    EXPECT_EQ(calls, 0UL);
}

TEST(HeapUse, TheCountSeesEveryKindOfAllocation) {
    EXPECT_EQ(calls_during([] { kept = std::malloc(16); }), 1UL);
    EXPECT_EQ(calls_during([] { kept = std::realloc(kept, 1024); }), 1UL);
    EXPECT_EQ(calls_during([] { std::free(kept); }), 1UL);
    EXPECT_EQ(calls_during([] { kept = std::calloc(4, 4); }), 1UL);
    EXPECT_EQ(calls_during([] { std::free(kept); }), 1UL);
    EXPECT_EQ(calls_during([] { kept = std::aligned_alloc(64, 64); }), 1UL);
    EXPECT_EQ(calls_during([] { std::free(kept); }), 1UL);
    EXPECT_EQ(calls_during([] { kept = ::operator new(8); }), 1UL);
    EXPECT_EQ(calls_during([] { ::operator delete(kept); }), 1UL);
}

// The same loop as above with one allocation planted in it.
TEST(HeapUse, APlantedAllocationInTheStepIsCounted) {
    const std::vector<rsi_inputs> inputs = manoeuvre();
    const unsigned long calls = calls_during([&] {
        rsi::Component component;
        component.init(rsi_test::large_suv());
        for (const rsi_inputs& input : inputs) {
            const std::unique_ptr<rsi_outputs> outputs = std::make_unique<rsi_outputs>();
            kept = outputs.get();
            component.step(input, *outputs);
        }
    });
    EXPECT_EQ(calls, 2UL * samples);
}

}  // namespace
