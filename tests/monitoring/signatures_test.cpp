// The tables of fault signatures: that they are complete, and how one row is read.
#include "rsi/ecu/monitoring/signatures.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace monitoring_signatures_test {
namespace {

using rsi::monitoring::CodeSet;
using rsi::monitoring::Consequence;
using rsi::monitoring::DiagnosticCode;
using rsi::monitoring::Pattern;
using rsi::monitoring::set_of;
using rsi::monitoring::sets;
using rsi::monitoring::Signature;
using rsi::monitoring::signatures;
using rsi::monitoring::Symptom;
using rsi::monitoring::symptoms;

using rsi::monitoring::Action;

TEST(ASignature, FitsWhereAllOfItIsSeenAndNoExcuse) {
    const Signature row = sets(DiagnosticCode::speed_stuck, Symptom::turn_valid)
                              .with(Symptom::gain_valid)
                              .unless(Symptom::spinning);
    EXPECT_TRUE(row.pattern.fits(symptoms(Symptom::turn_valid, Symptom::gain_valid)));
    EXPECT_TRUE(row.pattern.fits(symptoms(Symptom::turn_valid, Symptom::gain_valid, Symptom::roll_valid)));
    EXPECT_FALSE(row.pattern.fits(symptoms(Symptom::turn_valid)));
    EXPECT_FALSE(row.pattern.fits(symptoms(Symptom::gain_valid)));
    EXPECT_FALSE(row.pattern.fits(symptoms(Symptom::turn_valid, Symptom::gain_valid, Symptom::spinning)));
    EXPECT_FALSE(row.pattern.fits(symptoms()));
}

TEST(ASignature, SaysByItsVerdictWhatItIs) {
    for (const DiagnosticCode code : {DiagnosticCode::speed_stuck, DiagnosticCode::yaw_rate_stuck}) {
        for (const Symptom symptom : {Symptom::turn_valid, Symptom::roll_valid}) {
            for (const Signature& row : {sets(code, symptom), rsi::monitoring::holds(code, symptom),
                                         rsi::monitoring::clears(code, symptom)}) {
                EXPECT_EQ(row.code, code);
                EXPECT_TRUE(row.pattern.fits(symptoms(symptom)));
                EXPECT_FALSE(row.pattern.fits(symptoms(Symptom::spinning)));
            }
            EXPECT_EQ(sets(code, symptom).action, Action::sets);
            EXPECT_EQ(rsi::monitoring::holds(code, symptom).action, Action::holds);
            EXPECT_EQ(rsi::monitoring::clears(code, symptom).action, Action::clears);
            EXPECT_FALSE(sets(code, symptom).with(Symptom::gain_valid).pattern.fits(symptoms(symptom)));
            EXPECT_FALSE(sets(code, symptom)
                             .unless(Symptom::gain_valid)
                             .pattern.fits(symptoms(symptom, Symptom::gain_valid)));
        }
    }
}

TEST(APattern, FitsWhereAllOfItIsSeenAndNoExcuse) {
    const Pattern pattern{symptoms(Symptom::leans_into_turn), symptoms(Symptom::spinning)};
    EXPECT_TRUE(pattern.fits(symptoms(Symptom::leans_into_turn)));
    EXPECT_FALSE(pattern.fits(symptoms()));
    EXPECT_FALSE(pattern.fits(symptoms(Symptom::leans_into_turn, Symptom::spinning)));
}

// The rows of a code are read as one, so they stand together; and each code can come and go.
TEST(TheSignatures, SetAndClearEachCode) {
    std::vector<DiagnosticCode> codes;
    for (const Signature& row : signatures) {
        if (codes.empty() || codes.back() != row.code) {
            EXPECT_EQ(std::count(codes.begin(), codes.end(), row.code), 0);
            codes.push_back(row.code);
        }
    }
    for (const DiagnosticCode code : codes) {
        for (const Action action : {Action::sets, Action::clears}) {
            EXPECT_TRUE(std::any_of(signatures.begin(), signatures.end(), [&](const Signature& row) {
                return row.code == code && row.action == action;
            })) << static_cast<int>(code);
        }
    }
}

TEST(TheSignatures, InvalidateASignalForEachCode) {
    CodeSet invalidated = rsi::monitoring::roll_contradictions;
    for (const Consequence& each : rsi::monitoring::consequences) {
        invalidated |= each.not_used;
    }
    for (const Signature& row : signatures) {
        EXPECT_NE(invalidated & set_of(row.code), 0U) << static_cast<int>(row.code);
    }
}

TEST(TheSignatures, AreSummedUpAsACompilerDoes) {
    EXPECT_EQ(rsi::monitoring::find_setting_symptoms(), rsi::monitoring::setting_symptoms);
    EXPECT_EQ(rsi::monitoring::find_judged_codes(), rsi::monitoring::judged_codes);
    EXPECT_EQ(rsi::monitoring::find_no_reference_codes(), rsi::monitoring::no_reference_codes);
    for (const Signature& row : signatures) {
        EXPECT_NE(rsi::monitoring::judged_codes & set_of(row.code), 0U);
    }
    EXPECT_EQ(
        rsi::monitoring::no_reference_codes & set_of(DiagnosticCode::speed_jump, DiagnosticCode::speed_stuck),
        set_of(DiagnosticCode::speed_jump));
}

// A good test of a code is what clears it, if need be with more; and a row that clears has no excuse.
TEST(TheSignatures, ProveEachCodeGoodByWhatClearsIt) {
    EXPECT_EQ(rsi::monitoring::find_proven_codes(), rsi::monitoring::judged_codes);
    for (const Signature& row : signatures) {
        if (row.action == Action::clears) {
            EXPECT_EQ(row.pattern.excuses, 0U) << static_cast<int>(row.code);
            EXPECT_TRUE(std::any_of(rsi::monitoring::proofs.begin(), rsi::monitoring::proofs.end(),
                                    [&](const rsi::monitoring::Proof& proof) {
                                        return (proof.codes & set_of(row.code)) != 0U &&
                                               (proof.needed & row.pattern.needed) == row.pattern.needed;
                                    }))
                << static_cast<int>(row.code);
        }
    }
    CodeSet shown = 0U;
    for (unsigned index = 0U; index < static_cast<unsigned>(Symptom::count); ++index) {
        const auto symptom = static_cast<Symptom>(index);
        const rsi::monitoring::Proof proof = rsi::monitoring::proof_by(symptom).with(Symptom::turn_clear);
        EXPECT_EQ(proof.needed, symptoms(symptom, Symptom::turn_clear));
        EXPECT_EQ(proof.codes & shown, 0U) << "once";
        shown |= proof.codes;
    }
    EXPECT_EQ(shown, rsi::monitoring::judged_codes);
}

TEST(TheSignatures, SetACodeByASymptomThatSetsItAlone) {
    for (const Signature& row : signatures) {
        if (row.action == Action::sets) {
            EXPECT_NE(row.pattern.needed & rsi::monitoring::setting_symptoms, 0U)
                << static_cast<int>(row.code);
        }
    }
}

TEST(TheSignatures, SetNoCodeForResidualsWithinOrNotJudged) {
    const auto innocent = symptoms(
        Symptom::turn_valid, Symptom::turn_within, Symptom::turn_beyond_banks, Symptom::turn_clear,
        Symptom::spinning, Symptom::roll_force_valid, Symptom::roll_force_within, Symptom::lateral_suspect,
        Symptom::gain_valid, Symptom::roll_valid, Symptom::roll_angle_frozen, Symptom::roll_rate_frozen,
        Symptom::leans_into_turn, Symptom::observer_valid, Symptom::observer_within, Symptom::vertical_within,
        Symptom::reference_valid, Symptom::load_valid);
    EXPECT_EQ(rsi::monitoring::setting_symptoms & innocent, 0U);
    EXPECT_EQ(rsi::monitoring::setting_symptoms | innocent,
              ~rsi::monitoring::Symptoms{0U} >> (32U - static_cast<unsigned>(Symptom::count)));
}

}  // namespace
}  // namespace monitoring_signatures_test
