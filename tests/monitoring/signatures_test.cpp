// The tables by which a sensor is accused: that they are complete, and how one row is read.
#include "rsi/ecu/monitoring/signatures.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace monitoring_signatures_test {
namespace {

using rsi::monitoring::accuses;
using rsi::monitoring::CodeSet;
using rsi::monitoring::Consequence;
using rsi::monitoring::DiagnosticCode;
using rsi::monitoring::Fact;
using rsi::monitoring::facts;
using rsi::monitoring::Pattern;
using rsi::monitoring::set_of;
using rsi::monitoring::Signature;
using rsi::monitoring::signatures;

using rsi::monitoring::Verdict;

TEST(ASignature, FitsWhereAllOfItIsSeenAndNoExcuse) {
    const Signature row =
        accuses(DiagnosticCode::speed_stuck, Fact::turn_valid).with(Fact::gain_valid).unless(Fact::spinning);
    EXPECT_TRUE(row.pattern.fits(facts(Fact::turn_valid, Fact::gain_valid)));
    EXPECT_TRUE(row.pattern.fits(facts(Fact::turn_valid, Fact::gain_valid, Fact::roll_valid)));
    EXPECT_FALSE(row.pattern.fits(facts(Fact::turn_valid)));
    EXPECT_FALSE(row.pattern.fits(facts(Fact::gain_valid)));
    EXPECT_FALSE(row.pattern.fits(facts(Fact::turn_valid, Fact::gain_valid, Fact::spinning)));
    EXPECT_FALSE(row.pattern.fits(facts()));
}

TEST(ASignature, SaysByItsVerdictWhatItIs) {
    for (const DiagnosticCode code : {DiagnosticCode::speed_stuck, DiagnosticCode::yaw_rate_stuck}) {
        for (const Fact fact : {Fact::turn_valid, Fact::roll_valid}) {
            for (const Signature& row : {accuses(code, fact), rsi::monitoring::keeps(code, fact),
                                         rsi::monitoring::acquits(code, fact)}) {
                EXPECT_EQ(row.code, code);
                EXPECT_TRUE(row.pattern.fits(facts(fact)));
                EXPECT_FALSE(row.pattern.fits(facts(Fact::spinning)));
            }
            EXPECT_EQ(accuses(code, fact).verdict, Verdict::accuses);
            EXPECT_EQ(rsi::monitoring::keeps(code, fact).verdict, Verdict::keeps);
            EXPECT_EQ(rsi::monitoring::acquits(code, fact).verdict, Verdict::acquits);
            EXPECT_FALSE(accuses(code, fact).with(Fact::gain_valid).pattern.fits(facts(fact)));
            EXPECT_FALSE(
                accuses(code, fact).unless(Fact::gain_valid).pattern.fits(facts(fact, Fact::gain_valid)));
        }
    }
}

TEST(APattern, FitsWhereAllOfItIsSeenAndNoExcuse) {
    const Pattern pattern{facts(Fact::leans_into_turn), facts(Fact::spinning)};
    EXPECT_TRUE(pattern.fits(facts(Fact::leans_into_turn)));
    EXPECT_FALSE(pattern.fits(facts()));
    EXPECT_FALSE(pattern.fits(facts(Fact::leans_into_turn, Fact::spinning)));
}

// The rows of a code are read as one, so they stand together; and each code can come and go.
TEST(TheSignatures, HoldEachCodeOnceWithAnAccusationAndAnAcquittal) {
    std::vector<DiagnosticCode> codes;
    for (const Signature& row : signatures) {
        if (codes.empty() || codes.back() != row.code) {
            EXPECT_EQ(std::count(codes.begin(), codes.end(), row.code), 0);
            codes.push_back(row.code);
        }
    }
    for (const DiagnosticCode code : codes) {
        for (const Verdict verdict : {Verdict::accuses, Verdict::acquits}) {
            EXPECT_TRUE(std::any_of(signatures.begin(), signatures.end(), [&](const Signature& row) {
                return row.code == code && row.verdict == verdict;
            })) << static_cast<int>(code);
        }
    }
}

TEST(TheSignatures, TakeOutASignalForEachCode) {
    CodeSet taken_out = rsi::monitoring::roll_contradictions;
    for (const Consequence& each : rsi::monitoring::consequences) {
        taken_out |= each.not_used;
    }
    for (const Signature& row : signatures) {
        EXPECT_NE(taken_out & set_of(row.code), 0U) << static_cast<int>(row.code);
    }
}

TEST(TheSignatures, AreSummedUpAsACompilerDoes) {
    EXPECT_EQ(rsi::monitoring::find_accusing_facts(), rsi::monitoring::accusing_facts);
    EXPECT_EQ(rsi::monitoring::find_judged_codes(), rsi::monitoring::judged_codes);
    EXPECT_EQ(rsi::monitoring::find_no_witness_codes(), rsi::monitoring::no_witness_codes);
    for (const Signature& row : signatures) {
        EXPECT_NE(rsi::monitoring::judged_codes & set_of(row.code), 0U);
    }
    EXPECT_EQ(
        rsi::monitoring::no_witness_codes & set_of(DiagnosticCode::speed_jump, DiagnosticCode::speed_stuck),
        set_of(DiagnosticCode::speed_jump));
}

TEST(TheSignatures, AccuseByAFactThatAccusesAlone) {
    for (const Signature& row : signatures) {
        if (row.verdict == Verdict::accuses) {
            EXPECT_NE(row.pattern.needed & rsi::monitoring::accusing_facts, 0U) << static_cast<int>(row.code);
        }
    }
}

TEST(TheSignatures, AccuseNobodyForWhatIsWithinOrCannotBeJudged) {
    const auto innocent =
        facts(Fact::turn_valid, Fact::turn_within, Fact::turn_beyond_banks, Fact::spinning,
              Fact::roll_force_valid, Fact::roll_force_within, Fact::lateral_suspect, Fact::gain_valid,
              Fact::roll_valid, Fact::roll_angle_frozen, Fact::roll_rate_frozen, Fact::leans_into_turn,
              Fact::observer_valid, Fact::observer_within, Fact::vertical_within, Fact::reference_valid);
    EXPECT_EQ(rsi::monitoring::accusing_facts & innocent, 0U);
    EXPECT_EQ(rsi::monitoring::accusing_facts | innocent, facts(Fact::count) - 1U);
}

}  // namespace
}  // namespace monitoring_signatures_test
