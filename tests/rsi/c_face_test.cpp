// The C interface, called from C, against the C++ interface: the same bits.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <vector>

#include "rsi/component.hpp"
#include "tests/rsi/c_face_run.h"
#include "tests/rsi/support/nominal.hpp"
#include "tests/rsi/support/output_fields.hpp"
#include "tests/rsi/support/random_manoeuvre.hpp"

namespace c_face_test {
namespace {

TEST(CFace, GivesTheBitsOfTheCppFace) {
    const rsi_parameters parameters = rsi_test::large_suv();
    rsi_test::RandomManoeuvre drive(parameters, 61U, true);
    std::vector<rsi_inputs> inputs;
    for (int k = 0; k < 5000; ++k) {
        inputs.push_back(drive.next());
    }
    std::vector<rsi_outputs> from_c(inputs.size());
    const rsi_validation answer =
        c_face_run(&parameters, inputs.data(), from_c.data(), static_cast<unsigned>(inputs.size()));
    EXPECT_EQ(answer.accepted, 1);

    rsi::Component component;
    ASSERT_EQ(component.init(parameters).accepted, 1);
    for (std::size_t k = 0; k < inputs.size(); ++k) {
        rsi_outputs outputs{};
        component.step(inputs[k], outputs);
        ASSERT_TRUE(rsi_test::identical(outputs, from_c[k])) << k;
    }
}

TEST(CFace, KnowsWhetherAnOptimiserMadeTheLibrary) {
    EXPECT_EQ(rsi_is_optimised(), RSI_LIBRARY_IS_OPTIMISED);
}

TEST(CFace, NamesTheRefusedFieldAndStaysSafeToStep) {
    rsi_parameters parameters = rsi_test::large_suv();
    parameters.forgetting_factor = 1.5F;
    std::vector<rsi_inputs> inputs(10, rsi_test::at_rest());
    std::vector<rsi_outputs> outputs(10);
    const rsi_validation answer = c_face_run(&parameters, inputs.data(), outputs.data(), 10U);
    EXPECT_EQ(answer.accepted, 0);
    EXPECT_STREQ(answer.field, "forgetting_factor");
    EXPECT_STREQ(answer.reason, "is above its range");
    for (const rsi_outputs& output : outputs) {
        EXPECT_EQ(output.state, RSI_STATE_UNAVAILABLE);
    }
}

TEST(CFace, KeepsAndRestoresTheLoadThatWasLearnt) {
    const rsi_parameters parameters = rsi_test::large_suv();
    rsi_component component;
    ASSERT_EQ(rsi_init(&component, &parameters).accepted, 1);
    EXPECT_EQ(rsi_get_learnt_load(&component).excess, 0.0F);
    const rsi_learnt_load kept{0.4F, 0.02F, 0.1F};
    EXPECT_EQ(rsi_restore_learnt_load(&component, &kept, 0), 1);
    EXPECT_EQ(rsi_get_learnt_load(&component).excess, 0.4F);
    EXPECT_EQ(rsi_get_learnt_load(&component).excess_deviation, 0.02F);
    EXPECT_EQ(rsi_get_learnt_load(&component).offset_mps2, 0.1F);
    EXPECT_EQ(rsi_restore_learnt_load(&component, &kept, 1), 1);
    EXPECT_EQ(rsi_get_learnt_load(&component).excess, 0.2F);
    const rsi_learnt_load none{2.0F, 0.02F, 0.1F};
    EXPECT_EQ(rsi_restore_learnt_load(&component, &none, 0), 0);
    EXPECT_EQ(rsi_get_learnt_load(&component).excess, 0.2F);
}

// As c_face_change, with the C++ interface.
unsigned cpp_face_change(const rsi_parameters& parameters, const rsi_parameters& others,
                         const std::vector<rsi_inputs>& inputs, std::vector<rsi_outputs>& outputs) {
    rsi::Component component;
    component.init(parameters);
    rsi::ParameterChange change;
    bool is_prepared = false;
    unsigned preparations = 0U;
    for (std::size_t k = 0; k < inputs.size(); ++k) {
        if (k == 100U) {
            is_prepared = change.begin(parameters, others).accepted != 0;
        }
        if (is_prepared) {
            ++preparations;
            if (change.prepare()) {
                component.change(change);
                is_prepared = false;
            }
        }
        if (k == 700U) {
            component.reset(preparations > 0U ? others : parameters);
        }
        component.step(inputs[k], outputs[k]);
    }
    return preparations;
}

// Changes, in C and in C++; both must give the same bits. Returns how often the change was prepared.
unsigned prepared_in_both(const rsi_parameters& others) {
    const rsi_parameters parameters = rsi_test::large_suv();
    rsi_test::RandomManoeuvre drive(parameters, 62U, true);
    std::vector<rsi_inputs> inputs;
    for (int k = 0; k < 1000; ++k) {
        inputs.push_back(drive.next());
    }
    std::vector<rsi_outputs> from_c(inputs.size());
    std::vector<rsi_outputs> from_cpp(inputs.size());
    const unsigned preparations = c_face_change(&parameters, &others, inputs.data(), from_c.data(),
                                                static_cast<unsigned>(inputs.size()));
    EXPECT_EQ(preparations, cpp_face_change(parameters, others, inputs, from_cpp));
    std::size_t different = 0U;
    for (std::size_t k = 0; k < inputs.size(); ++k) {
        different += rsi_test::identical(from_c[k], from_cpp[k]) ? 0U : 1U;
    }
    EXPECT_EQ(different, 0U);
    // The reset starts anew: the state waits for recovery_s.
    EXPECT_NE(from_c[699].state, RSI_STATE_UNAVAILABLE);
    EXPECT_EQ(from_c[700].state, RSI_STATE_UNAVAILABLE);
    return preparations;
}

TEST(CFace, ChangesAndResetsToTheBitsOfTheCppFace) {
    rsi_parameters others = rsi_test::large_suv();
    others.warning_on *= 0.9F;
    EXPECT_EQ(prepared_in_both(others), 1U);
    others.roll_stiffness_nmprad *= 1.1F;
    EXPECT_EQ(prepared_in_both(others), 200U);
}

TEST(CFace, RefusesAChangeByTheFieldsName) {
    const rsi_parameters parameters = rsi_test::large_suv();
    rsi_parameters others = parameters;
    others.track_width_m = 0.0F;
    EXPECT_EQ(prepared_in_both(others), 0U);
    rsi_parameter_change change;
    EXPECT_STREQ(rsi_begin_change(&change, &parameters, &others).field, "track_width_m");
}

TEST(CFace, NeitherResetNorChangeStartsARefusedComponent) {
    const rsi_parameters parameters = rsi_test::large_suv();
    rsi_parameters refused = parameters;
    refused.track_width_m = 0.0F;
    rsi_component component;
    ASSERT_EQ(rsi_init(&component, &refused).accepted, 0);
    rsi_reset(&component, &parameters);
    rsi_parameter_change change;
    ASSERT_EQ(rsi_begin_change(&change, &parameters, &parameters).accepted, 1);
    ASSERT_EQ(rsi_prepare_change(&change), 1);
    rsi_change(&component, &change);
    const rsi_inputs inputs = rsi_test::at_rest();
    rsi_outputs outputs{};
    for (int k = 0; k < 200; ++k) {
        rsi_step(&component, &inputs, &outputs);
        ASSERT_EQ(outputs.state, RSI_STATE_UNAVAILABLE);
        ASSERT_TRUE(std::isnan(outputs.rsi));
    }
}

// Memory before the first init, whatever fills it.
TEST(CFace, AnObjectBeforeItsInitDoesNotWarn) {
    const rsi_parameters parameters = rsi_test::large_suv();
    const rsi_inputs inputs = rsi_test::at_rest();
    for (int byte = 0; byte < 256; ++byte) {
        rsi_component component;
        std::memset(&component, byte, sizeof component);
        rsi_reset(&component, &parameters);
        rsi_outputs outputs{};
        for (int k = 0; k < 3; ++k) {
            rsi_step(&component, &inputs, &outputs);
            ASSERT_EQ(outputs.state, RSI_STATE_UNAVAILABLE) << byte;
            ASSERT_TRUE(std::isnan(outputs.rsi)) << byte;
        }
        ASSERT_EQ(rsi_init(&component, &parameters).accepted, 1);
        for (int k = 0; k < 200; ++k) {
            rsi_step(&component, &inputs, &outputs);
        }
        ASSERT_EQ(outputs.state, RSI_STATE_READY) << byte;
    }
}

TEST(CFace, TheStorageFitsTheObjects) {
    RecordProperty("sizeof_component", static_cast<int>(sizeof(rsi::Component)));
    EXPECT_LE(sizeof(rsi::Component), RSI_COMPONENT_SIZE);
    EXPECT_LE(sizeof(rsi::ParameterChange), RSI_PARAMETER_CHANGE_SIZE);
}

}  // namespace
}  // namespace c_face_test
