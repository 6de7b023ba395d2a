"""The tool itself, on a small planted source: which mutants there are, which of them are killed, which survive."""

import collections
import dataclasses
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
sys.dont_write_bytecode = True
sys.path.insert(0, str(HERE))

import ledger
import mutated_copy
import mutants as mutant_list
import program as test_program
import report
import scope
import trial

PLANTED = """\
#pragma once
#include <algorithm>
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
inline int checked(int x, const int* most) {
    if (most && x > *most) {
        throw x;
    }
    return std::max(x, -5);
}
"""
TESTS = """\
#include <gtest/gtest.h>
#include <fstream>
#include <string>
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
TEST(Planted, TakesWhatIsGood) {
    const int most = 2;
    EXPECT_EQ(checked(2, &most), 2);
    EXPECT_EQ(checked(3, nullptr), 3);
    EXPECT_EQ(checked(-9, nullptr), -5);
}
TEST(Planted, HasFilesOfItsOwn) {
    const std::string name = testing::TempDir() + "/planted";
    EXPECT_FALSE(std::ifstream{name}.good()) << "left behind by another mutant";
    std::ofstream{name} << sum_below(2);
}
"""


class Planted(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            source = folder / "planted.hpp"
            source.write_text(PLANTED)
            declarations = mutated_copy.declarations_of(["planted.hpp"], folder)
            texts, cls.all = mutated_copy.mutated_texts(["planted.hpp"], folder, declarations)
            source.write_text(texts["planted.hpp"])
            (folder / "planted_test.cpp").write_text(TESTS)
            program = folder / "planted_test"
            subprocess.run(["g++", "-std=c++17", "-O1", "-w", "-include", HERE / "schemata.hpp", "-o", program,
                            folder / "planted_test.cpp", HERE / "main.cpp", "-lgtest", "-pthread"], check=True)
            programs = {"planted_test": program}
            cls.record = test_program.recorded(programs, folder, 1)
            cls.results = trial.Trial(programs, cls.record, folder).run(cls.all, 1)
            cls.killers = {tuple(key): killer for _, key, _, killer in map(
                json.loads, next(folder.glob("results_*.jsonl")).read_text().splitlines())}
            cls.again = trial.Trial(programs, cls.record, folder).run(cls.all, 1)
            other = folder / "other_test"
            other.write_bytes(program.read_bytes() + b" ")
            others = trial.Trial({"planted_test": other}, cls.record, folder)
            cls.asked_of_others = {mutant.id: sum(others._groups(mutant), []) for mutant in cls.all}

    def mutants(self, operator, original=None):
        return [m for m in self.all if m.operator == operator and original in (None, m.original)]

    def survivors(self):
        return {(m.operator, m.original, m.mutated) for m in self.all if self.results[m.id] == "survived"}

    def test_every_operator_makes_its_mutants(self):
        count = collections.Counter(mutant.operator for mutant in self.all)
        self.assertEqual(dict(count), {
            "constant": 20, "arithmetic": 3, "relation": 8, "logical connector": 6, "negated condition": 3,
            "refusal": 1, "statement": 4, "returned value": 6, "bounding": 4, "unary minus": 2})

    def test_planted_mistakes_are_killed(self):
        for operator, original in (("logical connector", "(step > 0) && !stopped_"), ("negated condition", "!stopped_"),
                                   ("statement", "count_ += step"), ("statement", "stopped_ = true"),
                                   ("arithmetic", "count_ += step"), ("arithmetic", "2 * x"), ("unary minus", "-x"),
                                   ("bounding", "smaller(-x, limit)"), ("bounding", "std::max(x, -5)"), ("constant", "limit"),
                                   ("returned value", "count_"), ("returned value", "sum"), ("statement", "sum += i")):
            mutants = self.mutants(operator, original)
            self.assertTrue(mutants, (operator, original))
            for mutant in mutants:
                self.assertTrue(self.results[mutant.id].startswith("killed"), mutant)

    def test_a_place_without_a_test_survives(self):
        self.assertIn(("statement", "last_ = step", "(nothing)"), self.survivors())
        self.assertIn(("relation", "step > 0", "step >= 0"), self.survivors())  # 0 adds nothing: equivalent

    def test_an_untested_refusal_survives(self):
        """Its condition's opposite does not: good input notices that."""
        self.assertIn(("refusal", "most && x > *most", "never refused"), self.survivors())
        self.assertEqual({self.results[m.id] for m in self.mutants("relation", "x > *most")
                          if m.mutated == "x <= *most"}, {"killed by a test"})

    def test_places_that_cannot_be_mutated_are_counted_by_kind(self):
        self.assertEqual(self.all.skipped["static_assert, enumerator"], 1)
        self.assertEqual(self.all.skipped["step of a loop"], 1)

    def test_results_are_taken_up_again(self):
        self.assertEqual(self.results, self.again)

    # A test may have changed under its name: what survived it is tried on it again.
    def test_all_tests_of_other_programs_are_asked_the_killer_of_before_first(self):
        for mutant in self.all:
            asked = self.asked_of_others[mutant.id]
            self.assertEqual(set(asked), set(self.record.tests_of.get(mutant.id, [])), mutant)
            if self.results[mutant.id] != "survived":
                self.assertEqual(list(asked[0]), self.killers[mutant.key()], mutant)

    def test_the_test_that_kills_is_known(self):
        for mutant in self.mutants("arithmetic", "2 * x"):
            self.assertEqual(self.killers[mutant.key()], ["planted_test", "Planted.Doubles"])

    def test_each_mutant_is_tried_on_the_tests_that_execute_it(self):
        mutant = self.mutants("arithmetic", "2 * x")[0]
        self.assertEqual(self.record.tests_of[mutant.id], [("planted_test", "Planted.Doubles")])


class Floors(unittest.TestCase):
    MUTANTS = [mutant_list.Mutant(number, "a.cpp", number, "f", "constant", str(number), "0") for number in range(1, 11)]
    FLOORS = [ledger.Floor("firmware", "a.cpp", 10, 9)]

    def below(self, survivors, mutants=MUTANTS, floors=FLOORS):
        results = {mutant.id: "survived" if mutant.id in survivors else "killed by a test" for mutant in mutants}
        return list(ledger.below_floor(mutants, results, floors, 0.9))

    def test_one_more_survivor_is_below_the_floor(self):
        self.assertEqual(self.below({1, 2}), ["a.cpp"])

    def test_another_survivor_instead_is_not(self):
        self.assertEqual(self.below({7}), [])

    def test_mutants_that_are_gone_lower_the_share_but_not_the_floor(self):
        self.assertEqual(self.below({1}, self.MUTANTS[:5]), [])
        self.assertEqual(self.below({1, 2}, self.MUTANTS[:5]), ["a.cpp"])

    def test_a_file_without_a_floor_needs_the_goal(self):
        self.assertEqual(self.below({1}, floors=[]), [])
        self.assertEqual(self.below({1, 2}, floors=[]), ["a.cpp"])

    def test_a_file_of_which_not_all_was_tried_is_not_judged(self):
        self.assertEqual(list(ledger.below_floor(self.MUTANTS, {1: "survived", 2: "survived"}, self.FLOORS, 0.9)), [])


class Reasons(unittest.TestCase):
    MUTANTS = [mutant_list.Mutant(1, "a.cpp", 3, "f", "relation", "a < b", "a <= b"),
               mutant_list.Mutant(2, "a.cpp", 4, "f", "relation", "a < c", "a <= c")]
    KNOWN = [ledger.Survivor("firmware", "a.cpp", "f", "relation", "a < b -> a <= b", "yes", "they differ")]

    def reviewed(self, mutants, known=KNOWN):
        results = {mutant.id: "survived" for mutant in mutants}
        return [(row.change, row.equivalent, row.reason) for row in ledger.reviewed("firmware", mutants, results, known)]

    def test_a_reason_stays_with_its_mutant(self):
        self.assertEqual(self.reviewed(self.MUTANTS), [("a < b -> a <= b", "yes", "they differ"), ("a < c -> a <= c", "", "")])

    def test_a_reason_stays_when_the_text_changes(self):
        self.assertEqual(self.reviewed(self.MUTANTS[1:]), [("a < c -> a <= c", "yes", "they differ")])

    def test_a_further_survivor_beside_a_changed_text_has_none(self):
        changed = dataclasses.replace(self.MUTANTS[0], id=3, original="x < y", mutated="x <= y")
        self.assertEqual(sum(bool(reason) for *_, reason in self.reviewed([changed, self.MUTANTS[1]])), 1)

    def test_none_of_two_reasons_is_guessed(self):
        other = dataclasses.replace(self.KNOWN[0], change="b < a -> b <= a", reason="another")
        self.assertEqual(self.reviewed(self.MUTANTS[1:], [*self.KNOWN, other]), [("a < c -> a <= c", "", "")])


class Kept(unittest.TestCase):
    """The data that is committed."""

    @classmethod
    def setUpClass(cls):
        cls.ledger = ledger.Ledger(scope.PROJECT)

    def test_the_page_shows_the_data(self):
        text = report.page(scope.SCOPES.values(), self.ledger)
        self.assertTrue((scope.PROJECT / "docs/reports/mutation.md").read_text().endswith("\n\n" + text),
                        "run tests/quality/mutation/run --page")

    def test_each_file_is_there_once_and_is_mutated(self):
        for asked in scope.SCOPES.values():
            floors, survivors, _ = self.ledger.of(asked.name)
            files = [floor.file for floor in floors]
            self.assertEqual(len(files), len(set(files)))
            for file in sorted({*files, *(survivor.file for survivor in survivors)} - set(asked.sources())):
                self.fail(f"{file} is gone or no longer mutated: give its rows in {ledger.FOLDER} the new name")

    def test_floors_and_survivors_agree(self):
        for asked in scope.SCOPES.values():
            floors, survivors, totals = self.ledger.of(asked.name)
            count = collections.Counter(survivor.file for survivor in survivors)
            self.assertEqual({floor.file: floor.mutants - floor.killed for floor in floors},
                             {floor.file: count[floor.file] for floor in floors})
            of_operators = [total for total in totals if total.kind == "operator"]
            self.assertEqual(sum(total.mutants for total in of_operators), sum(floor.mutants for floor in floors))
            self.assertEqual(sum(total.killed for total in of_operators), sum(floor.killed for floor in floors))

    def test_every_survivor_that_needs_a_reason_has_one(self):
        for asked in scope.SCOPES.values():
            for survivor in self.ledger.of(asked.name)[1]:
                self.assertIn(survivor.equivalent, ("", "yes"))
                self.assertTrue(survivor.reason.strip() or not (asked.every_survivor_explained or survivor.equivalent), survivor)

    def test_a_written_ledger_is_read_again(self):
        with tempfile.TemporaryDirectory() as name:
            project = pathlib.Path(name)
            (project / "docs/reports").mkdir(parents=True)
            other = ledger.Ledger(project)
            for asked in scope.SCOPES.values():
                other.replace(asked.name, *self.ledger.of(asked.name))
            other.write()
            for file in (project / ledger.FOLDER).iterdir():
                self.assertEqual(file.read_bytes(), (scope.PROJECT / ledger.FOLDER / file.name).read_bytes(), file.name)


class Reported(unittest.TestCase):
    MUTANTS = [mutant_list.Mutant(number, "a.cpp", number, "f", "constant", str(number), "0") for number in range(1, 100)]

    def test_a_score_below_the_goal_is_told(self):
        self.assertEqual(len(report.missed_goal(1, 2, 0.9)), 1)
        self.assertEqual(report.missed_goal(9, 10, 0.9), [])

    def test_the_page_counts_with_and_without_equivalents_and_names_what_is_left_out(self):
        asked = dataclasses.replace(scope.JUDGES, left_out={"b.cpp": "says nothing"})
        mutants = mutant_list.Mutants()
        mutants.extend(self.MUTANTS[:5])
        results = {1: "survived", 2: "killed by a test", 3: "survived", 4: "killed by a crash"}
        record = test_program.Record([("a_test", "A.B", 1, [1, 2, 4], [])])
        known = [ledger.Survivor("judges", "a.cpp", "f", "constant", "1 -> 0", "yes", "why")]
        with tempfile.TemporaryDirectory() as name:
            kept = ledger.Ledger(pathlib.Path(name))
        kept.replace("judges", *report.rows(asked, mutants, mutants[:4], results, record, known))
        page = report.page([asked], kept)
        self.assertIn("2 of 4 mutants are killed, 50.0 %: 1 by a test, 1 by a crash. 2 survive, 1 of them "
                      "executed by no test", page)
        self.assertIn("Without them 2 of 3 are killed, 66.7 %.", page)
        self.assertIn("| constant | 4 | 2 | 50.0 % | 1 | 66.7 % |", page)
        self.assertIn("constant that only the compiler evaluates: 1.", page)
        self.assertIn("- `b.cpp`: says nothing", page)

    def test_a_mutants_place_in_the_sample_does_not_depend_on_the_others(self):
        sample = report.draw(self.MUTANTS, 20, 1)
        self.assertEqual(len(sample), 20)
        self.assertTrue(set(m.id for m in report.draw(self.MUTANTS, 10, 1)) < set(m.id for m in sample))
        self.assertNotEqual(sample, report.draw(self.MUTANTS, 20, 2))
        left_out = next(m for m in self.MUTANTS if m not in sample)
        self.assertEqual(report.draw([m for m in self.MUTANTS if m != left_out], 20, 1), sample)

    def test_unexecuted_code_survives_unless_all_is_executed_or_it_is_a_named_constant(self):
        record = test_program.Record([("a_test", "A.B", 1, [1], [])])
        named = dataclasses.replace(self.MUTANTS[3], function="")
        for all_executed, expected in ((True, [False, True, True]), (False, [False, False, True])):
            self.assertEqual([report.only_compiled(mutant, record, all_executed) for mutant in (*self.MUTANTS[:2], named)],
                             expected)


class Linked(unittest.TestCase):
    def test_nothing_is_written_through_a_link_of_a_smaller_scope(self):
        with tempfile.TemporaryDirectory() as name:
            project, source = pathlib.Path(name) / "project", pathlib.Path(name) / "source"
            for file in ("a/one.cpp", "a/two.cpp", "b/three.cpp"):
                (project / file).parent.mkdir(parents=True, exist_ok=True)
                (project / file).write_text("original")
            for mutated in (["a/one.cpp"], ["a/one.cpp", "a/two.cpp", "b/three.cpp"], ["a/two.cpp"]):
                mutated_copy.link_everything_else(mutated, project, source)
                for file in mutated:
                    mutated_copy.write_if_other(source / file, "mutated")
                for file in ("a/one.cpp", "a/two.cpp", "b/three.cpp"):
                    self.assertEqual((project / file).read_text(), "original", file)
                    self.assertEqual((source / file).read_text(), "mutated" if file in mutated else "original", file)
            with self.assertRaises(ValueError):
                mutated_copy.write_if_other(source / "a/one.cpp", "mutated")

    def test_nothing_compiled_or_recorded_of_another_scope_is_kept(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name) / "mutation"
            def copy(names):
                """Whether what the copy before has built, recorded and found is still there."""
                mutated_copy.forget_another_scope(names, folder)
                files = [folder / file for file in ("source/a.cpp", "build/a.o", "record_a_test_1.json", "results_1.jsonl")]
                kept = [file.is_file() for file in files]
                for file in files:
                    file.parent.mkdir(parents=True, exist_ok=True)
                    file.write_text("[]")
                return kept
            self.assertEqual(copy(["a.cpp", "b.cpp"]), [False] * 4)
            self.assertEqual(copy(["a.cpp", "b.cpp"]), [True] * 4)
            self.assertEqual(copy(["a.cpp"]), [False, False, False, True])

    def test_the_mutants_of_a_larger_scope_are_not_taken_for_those_of_a_smaller_one(self):
        smaller = dataclasses.replace(scope.JUDGES, left_out={**scope.JUDGES.left_out, "sil/results/events.cpp": "a test"})
        self.assertNotEqual(*(mutated_copy.MutatedCopy(asked)._digest() for asked in (scope.JUDGES, smaller)))


class Scopes(unittest.TestCase):
    def test_exceptions_and_asked_programs_exist(self):
        for asked in scope.SCOPES.values():
            self.assertTrue(asked.sources())
            for name in (*asked.asked, *asked.left_out):
                self.assertTrue((scope.PROJECT / name).exists(), name)
            for name in asked.left_out:
                self.assertFalse([source for source in asked.sources() if source == name or source.startswith(name + "/")])
            self.assertEqual(set().union(*asked.asked.values()), set(asked.programs))

    def test_a_folder_is_not_another_whose_name_begins_with_its(self):
        self.assertEqual(scope.JUDGES.asked_about("sil/results/a.cpp"), {"results_test"})
        self.assertEqual(scope.JUDGES.asked_about("sil/results_of/a.cpp"), set())

    def test_a_file_alone_can_be_asked_about(self):
        file = "sil/studies/faults/judgement.cpp"
        asked = dataclasses.replace(scope.JUDGES, asked={file: {"faults_tests"}}, left_out={})
        self.assertEqual(asked.sources(), [file])
        self.assertEqual(asked.asked_about(file), {"faults_tests"})
        self.assertEqual(asked.asked_about("sil/studies/faults/judgement.hpp"), set())


if __name__ == "__main__":
    unittest.main()
