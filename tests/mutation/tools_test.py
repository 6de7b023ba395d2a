"""The tool itself, on a small planted source: which mutants there are, which of them are killed, which survive."""

import collections
import pathlib
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
sys.dont_write_bytecode = True
sys.path.insert(0, str(HERE))

import mutate
import report
import review
import trial

PLANTED = """\
#pragma once
constexpr float limit = 2.5F;
constexpr float smaller(float a, float b) { return (a < b) ? a : b; }
constexpr int twice(int x) { return 2 * x; }
static_assert(twice(3) == 6);
class Counter {
 public:
    void add(int step) {
        if ((step > 0) && !stopped_) {
            count_ += step;
        }
        last_ = step;
    }
    void stop() { stopped_ = true; }
    int count() const { return count_; }

 private:
    int count_{0};
    int last_{0};
    bool stopped_{false};
};
inline float bounded(float x) { return smaller(-x, limit); }
inline int sum_below(int end) {
    int sum = 0;
    for (int i = 0; i < end; ++i) {
        sum += i;
    }
    return sum;
}
"""
TESTS = """\
#include <gtest/gtest.h>
#include "planted.hpp"
TEST(Planted, Counts) {
    Counter counter;
    counter.add(0);
    EXPECT_EQ(counter.count(), 0);
    counter.add(2);
    counter.add(-5);
    EXPECT_EQ(counter.count(), 2);
    counter.stop();
    counter.add(1);
    EXPECT_EQ(counter.count(), 2);
}
TEST(Planted, IsBounded) {
    EXPECT_EQ(bounded(-1.0F), 1.0F);
    EXPECT_EQ(bounded(-7.0F), 2.5F);
}
TEST(Planted, Doubles) { EXPECT_EQ(twice(4), 8); }
TEST(Planted, Sums) { EXPECT_EQ(sum_below(4), 6); }
"""


class Planted(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            source = folder / "planted.hpp"
            source.write_text(PLANTED)
            cls.mutator = mutate.Mutator()
            unit = cls.mutator.parse(source, ["-x", "c++", "-std=c++17", "-w",
                                              "-resource-dir=/usr/lib/llvm-19/lib/clang/19"])
            cls.mutator.find_constants("planted.hpp", source, unit)
            source.write_text(cls.mutator.mutated("planted.hpp", source, unit))
            (folder / "planted_test.cpp").write_text(TESTS)
            program = folder / "planted_test"
            subprocess.run(["g++", "-std=c++17", "-O1", "-w", "-include", HERE / "schemata.hpp", "-o", program,
                            folder / "planted_test.cpp", HERE / "main.cpp", "-lgtest", "-pthread"], check=True)
            programs = {"planted_test": program}
            record = trial.recorded(programs, folder)
            cls.results = trial.Trial(programs, record, folder).run(cls.mutator.mutants, 1)
            cls.again = trial.Trial({"planted_test": program}, record, folder).run(cls.mutator.mutants, 1)
            cls.record = record

    def mutants(self, operator, original=None):
        return [m for m in self.mutator.mutants if m.operator == operator and original in (None, m.original)]

    def survivors(self):
        return {(m.operator, m.original, m.mutated) for m in self.mutator.mutants if self.results[m.id] == "survived"}

    def test_every_operator_makes_its_mutants(self):
        count = collections.Counter(mutant.operator for mutant in self.mutator.mutants)
        self.assertEqual(dict(count), {
            "constant": 17, "arithmetic": 3, "relation": 6, "logical connector": 3, "negated condition": 2,
            "statement": 4, "returned value": 5, "bounding": 2, "unary minus": 1})

    def test_planted_mistakes_are_killed(self):
        for operator, original in (("logical connector", "(step > 0) && !stopped_"), ("negated condition", "!stopped_"),
                                   ("statement", "count_ += step"), ("statement", "stopped_ = true"),
                                   ("arithmetic", "count_ += step"), ("arithmetic", "2 * x"), ("unary minus", "-x"),
                                   ("bounding", "smaller(-x, limit)"), ("constant", "limit"),
                                   ("returned value", "count_"), ("returned value", "sum"), ("statement", "sum += i")):
            mutants = self.mutants(operator, original)
            self.assertTrue(mutants, (operator, original))
            for mutant in mutants:
                self.assertTrue(self.results[mutant.id].startswith("killed"), mutant)

    def test_what_no_test_looks_at_survives(self):
        self.assertIn(("statement", "last_ = step", "(nothing)"), self.survivors())
        self.assertIn(("relation", "step > 0", "step >= 0"), self.survivors())  # 0 adds nothing: equivalent

    def test_what_cannot_be_mutated_is_counted_by_kind(self):
        self.assertEqual(self.mutator.skipped["static_assert, enumerator"], 1)
        self.assertEqual(self.mutator.skipped["step of a loop"], 1)

    def test_results_are_taken_up_again(self):
        self.assertEqual(self.results, self.again)

    def test_each_mutant_is_tried_on_the_tests_that_execute_it(self):
        mutant = self.mutants("arithmetic", "2 * x")[0]
        self.assertEqual(self.record.tests_of[mutant.id], [("planted_test", "Planted.Doubles")])


class Reviewed(unittest.TestCase):
    MUTANT = mutate.Mutant(7, "a.cpp", 3, "f", "relation", "a < b", "a <= b")
    ENTRY = ('[[survivor]]\nfile = "a.cpp"\nfunction = "f"\noperator = "relation"\noriginal = "a < b"\n'
             'mutated = "a <= b"\nwhy = "equivalent"\n')

    def test_an_explained_survivor_is_no_problem(self):
        self.assertEqual(review.Review(self.ENTRY).problems([self.MUTANT], {7: "survived"}, True), [])

    def test_a_survivor_without_explanation_is_one(self):
        self.assertEqual(len(review.Review("").problems([self.MUTANT], {7: "survived"}, True)), 1)

    def test_an_explanation_of_what_is_killed_or_gone_is_one(self):
        self.assertEqual(len(review.Review(self.ENTRY).problems([self.MUTANT], {7: "killed test"}, True)), 1)
        self.assertEqual(len(review.Review(self.ENTRY).problems([], {}, True)), 1)
        self.assertEqual(review.Review(self.ENTRY).problems([self.MUTANT], {}, False), [])

    def test_a_score_below_the_goal_is_told(self):
        self.assertEqual(len(report.missed_goal({1: "survived", 2: "killed test"})), 1)
        self.assertEqual(report.missed_goal({1: "killed crash"}), [])

    def test_the_interval_is_wilsons(self):
        low, high = report.interval(90, 100)
        self.assertAlmostEqual(low, 0.8256, places=3)
        self.assertAlmostEqual(high, 0.9448, places=3)


if __name__ == "__main__":
    unittest.main()
