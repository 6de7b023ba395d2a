// The C interface, called from C, against the C++ interface: the same bits.
#include <gtest/gtest.h>

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

TEST(CFace, TheStorageFitsTheComponent) {
    RecordProperty("sizeof_component", static_cast<int>(sizeof(rsi::Component)));
    EXPECT_LE(sizeof(rsi::Component), RSI_COMPONENT_SIZE);
}

}  // namespace
}  // namespace c_face_test
