// Pages of the fault matrix and the endurance run: the template and its values must fit.
#include "sil/studies/faults/page_template.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace rsi_test {
namespace page_template_test {
namespace {

TEST(PageTemplate, PutsEachValueIntoItsPlace) {
    EXPECT_EQ(sil::fill_template("a {{x}} b {{y}}{{x}}", {{"x", "1"}, {"y", "{{x}}"}}), "a 1 b {{x}}1");
    EXPECT_EQ(sil::fill_template("none", {}), "none");
}

TEST(PageTemplate, RefusesWhatDoesNotFit) {
    EXPECT_THROW(sil::fill_template("{{x}}", {}), std::invalid_argument);
    EXPECT_THROW(sil::fill_template("{{x}}", {{"x", ""}, {"y", ""}}), std::invalid_argument);
    EXPECT_THROW(sil::fill_template("{{x", {{"x", ""}}), std::invalid_argument);
}

}  // namespace
}  // namespace page_template_test
}  // namespace rsi_test
