"""Importance sampling: weights and intervals against answers that are known, and against plain sampling."""

import contextlib
import io
import pathlib
import random
import subprocess
import sys
import tempfile
import unittest

PROJECT = pathlib.Path(__file__).resolve().parents[3]
sys.path[:0] = [str(PROJECT / "sil/tools/campaigns"), str(PROJECT / "cmake/environment")]

import command  # noqa: E402
import judge  # noqa: E402
import rare  # noqa: E402
from campaign_error import CampaignError  # noqa: E402

VEHICLES = {name: (f'parameters = "{PROJECT}/sil/vehicles/{name}.toml"\n'
                   f'calibration = "{PROJECT}/firmware/calibrations/{name}.toml"\nspeed_factors = [1.0, {factor}]\n')
            for name, factor in (("large_suv", 1.0), ("ordinary_suv", 0.5))}
RUNS = 200


def settings(seed, vehicles, manoeuvres, friction="[0.7, 1.2]"):
    text = f"seed = {seed}\nruns = {RUNS}\n[spread]\nfriction_factor = {friction}\n"
    text += "".join(f"\n[[vehicle]]\n{VEHICLES[name]}" for name in vehicles)
    return text + "".join(f'\n[[manoeuvre]]\nname = "{name}"\nweight = {weight}\nspeed_factor = {speed}\n'
                          'steering_factor = [0.5, 1.2]\n' for name, weight, speed in manoeuvres)


class Estimates(unittest.TestCase):
    """A number that is uniform on 0 to 1 is above 0.998: drawn plainly, and beside that on 0.99 to 1."""

    def samples(self, seed, plain, focused):
        numbers = random.Random(seed)
        return [[1.0 / (share + focused_share * (100.0 if x > 0.99 else 0.0)) * (x > 0.998) for x in drawn]
                for share, focused_share in [(plain / (plain + focused), focused / (plain + focused))]
                for drawn in ([numbers.random() for _ in range(plain)],
                              [numbers.uniform(0.99, 1.0) for _ in range(focused)])]

    def test_the_interval_holds_the_answer_as_often_as_it_says(self):
        found = [rare.estimate(self.samples(seed, 300, 300), 300) for seed in range(400)]
        holds = sum(low <= 0.002 <= high for low, high in (each.interval for each in found))
        self.assertGreaterEqual(holds, 370)
        self.assertAlmostEqual(sum(each.share for each in found) / len(found), 0.002, delta=0.0001)
        self.assertGreater(min(each.trials for each in found), 3000)

    def test_plain_runs_alone_are_a_binomial(self):
        found = rare.estimate([[1.0] * 10 + [0.0] * 990], 1000)
        self.assertEqual(found.share, 0.01)
        self.assertAlmostEqual(found.trials, 1000, delta=1.1)

    def test_without_events_only_plain_runs_bound(self):
        found = rare.estimate([[0.0] * 100, [0.0] * 100_000], 100)
        self.assertEqual(found.share, 0.0)
        self.assertGreater(found.interval[1], 0.03)


class Campaigns(unittest.TestCase):
    program = None

    @classmethod
    def setUpClass(cls):
        scratch = tempfile.TemporaryDirectory()
        cls.addClassCleanup(scratch.cleanup)
        cls.scratch = pathlib.Path(scratch.name)
        plain = (("straight", 3.0, "[0.5, 1.0]"), ("j-turn-110", 1.0, "[0.5, 1.0]"))
        cls.plain = cls.drive("plain", settings(1, ("large_suv", "ordinary_suv"), plain))
        # Another order, a vehicle more often, other weights and ends.
        nearer = (("straight", 1.0, "[0.8, 0.9]"), ("j-turn-110", 3.0, "[0.9, 1.0]"))
        cls.nearer = cls.drive("nearer", settings(2, ("ordinary_suv", "ordinary_suv", "large_suv"), nearer, "[0.7, 0.8]"))

    @classmethod
    def drive(cls, name, text):
        file = cls.scratch / f"{name}.toml"
        file.write_text(text, encoding="utf-8")
        cls.run_program("--settings", file, "--output", cls.scratch / name)
        return cls.scratch / name

    @classmethod
    def run_program(cls, *arguments):
        subprocess.run([cls.program, "campaign", "run", *map(str, arguments)], cwd=PROJECT, check=True, capture_output=True, timeout=300)

    def test_draws_have_the_probability_of_the_settings(self):
        # With the one vehicle (a half), of the turn (a quarter), the upper tenth of the speed (factor 0.5), the lower
        # twentieth of the friction.
        what = "vehicle = 'ordinary_suv' AND manoeuvre = 'j-turn-110' AND speed_factor > 0.95 * 0.5 AND friction_factor < 0.725"
        with contextlib.redirect_stderr(io.StringIO()):
            samples, weights = rare.weighed([self.plain, self.nearer], self.program, what)
        truth = 0.5 * 0.25 * 0.1 * 0.05
        found = rare.estimate(samples, RUNS)
        self.assertGreater(found.events, 10)
        self.assertGreater(found.trials, 10 * RUNS)
        self.assertLess(found.interval[0], truth)
        self.assertGreater(found.interval[1], truth)
        self.assertLess(found.interval[1], 3 * truth)
        weights = sum(weights, [])
        self.assertLessEqual(max(weights), 2 + 1e-9)
        self.assertAlmostEqual(sum(weights) / len(weights), 1, delta=0.15)

    def test_an_event_of_the_warning_agrees_with_plain_sampling(self):
        with contextlib.redirect_stderr(io.StringIO()):
            samples, _ = rare.weighed([self.plain, self.nearer], self.program, "lifted")
        weighed = rare.estimate(samples, RUNS)
        plain = rare.estimate([[float(weight > 0) for weight in samples[0]]], RUNS)
        self.assertGreaterEqual(plain.events, 5)
        self.assertLess(weighed.interval[0], plain.interval[1])
        self.assertGreater(weighed.interval[1], plain.interval[0])

    def test_the_command_tells_both_and_a_proposal_can_be_driven(self):
        said = self.say("rare", self.plain, self.nearer, "--event", "late")
        for part in ("late: lifted AND NOT warned_100ms", "plain runs alone:", "all, weighed:", "effective sample size"):
            self.assertIn(part, said)
        proposed = self.scratch / "proposed.toml"
        turns = self.drive("turns", settings(5, ("large_suv", "ordinary_suv"), (("straight", 0.1, "[0.5, 1.0]"),
                                                                             ("j-turn-110", 3.0, "[0.9, 1.0]"))))
        self.say("rare", turns, "--event", "late", "--propose", proposed)
        self.run_program("--settings", proposed, "--runs", 5, "--output", self.scratch / "proposed")
        drawn = rare.Distribution(rare.settings_of(self.scratch / "proposed"))
        plainly = rare.Distribution(rare.settings_of(turns))
        turn = {**dict.fromkeys(rare.DRAWN, 0.0), "load_height_factor": 1.0, "friction_factor": 1.1, "vehicle": "large_suv",
                "manoeuvre": "j-turn-110", "speed_factor": 0.99, "steering_factor": 1.1}
        straight = dict(turn, manoeuvre="straight", speed_factor=0.9)
        self.assertGreater(drawn.density(turn), plainly.density(turn))
        self.assertLess(drawn.density(straight), 1e-3 * plainly.density(straight), "a straight drive never lifts two wheels")
        with self.assertRaises(CampaignError) as raised:
            rare.weighed([turns, self.scratch / "proposed"], self.program, "lifted")
        self.assertIn("is the pilot", str(raised.exception))

    def test_campaigns_of_another_kind_are_refused(self):
        both, turns = ("large_suv", "ordinary_suv"), (("straight", 1.0, "[0.5, 1.0]"), ("j-turn-110", 1.0, "[0.5, 1.0]"))
        few = f"runs = {RUNS}", "runs = 2"
        quiet = settings(3, both, turns).replace(*few).replace("[spread]", "[spread]\nsensor_noise = false")
        other, same_seed = self.drive("other", quiet), self.drive("same_seed", settings(1, both, turns).replace(*few))
        for folder, expected in ((other, "is of another kind than"), (same_seed, "has the seed of another")):
            with self.assertRaises(CampaignError) as raised:
                rare.weighed([self.plain, folder], self.program, "lifted")
            self.assertIn(expected, str(raised.exception))

    def say(self, *arguments):
        said = io.StringIO()
        with contextlib.redirect_stdout(said), contextlib.redirect_stderr(io.StringIO()):
            command.main([*map(str, arguments), "--program", str(self.program)])
        return said.getvalue()


if __name__ == "__main__":
    Campaigns.program = pathlib.Path(sys.argv.pop(1)).resolve()
    judge.use(Campaigns.program)
    unittest.main()
