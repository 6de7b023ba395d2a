"""Comparison of signals, over every manoeuvre of the catalogue: no good drive is doubted, no sign is answered
wrongly, and wrong signs and units show."""

import itertools

import numpy

import support

import consistency
import draft
import foreign_recorder

UNITS = {"lateral_acceleration": "mps2", "roll_rate": "degps", "roll_angle": "deg", "yaw_rate": "degps",
         "steering_wheel_angle": "deg", "speed": "mps", "vertical_acceleration": "mps2"}
MIRRORED = (*draft.SIGNED, "roll_rate")
TURNING = ("slalom", "j-turn-45", "double-lane-change", "step-steer", "slowly-increasing-steer", "slow-ramp")


class Consistency(support.WithRun):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        listed = support.call(cls.program, "list").stdout.splitlines()
        # A vehicle that trips is not driven to map signals by.
        driven = [line.split()[0] for line in listed if "-trip" not in line.split()[0]]
        cls.runs = {manoeuvre: cls.signals_of(manoeuvre) for manoeuvre in driven}

    @classmethod
    def signals_of(cls, manoeuvre):
        folder = cls.run_folder.parent / manoeuvre
        support.call(cls.program, "run", manoeuvre, "--in-process", "--noise", "--vehicle",
                     support.PROJECT / "sil/vehicles/large_suv.toml", "--parameters", support.CALIBRATION, "--output", folder)
        rows = list(foreign_recorder.rows(folder))
        columns = {name: numpy.array([row[f"{name}_{unit}"] for row in rows]) for name, unit in UNITS.items()}
        columns["speed"] = columns["speed"] * 3.6
        return numpy.array([round(row["time_s"] * 1.0e6) for row in rows]), columns

    @staticmethod
    def evidence(times_us, columns):
        evidence = draft.Evidence(None, {}, None)
        evidence.look(times_us, columns)
        return evidence

    def test_no_good_drive_is_doubted(self):
        for manoeuvre, (times_us, columns) in self.runs.items():
            for absent in (None, "roll_angle", "yaw_rate", "speed"):
                known = {name: values for name, values in columns.items() if name != absent}
                lines, is_doubtful = consistency.reported(times_us, known)
                self.assertFalse(is_doubtful, (manoeuvre, absent, lines))

    def test_no_sign_is_answered_wrongly(self):
        """Also not of a drive to one side only, to the left or, in a mirror, to the right."""
        answers = {}
        for manoeuvre, (times_us, columns) in self.runs.items():
            for absent, side in itertools.product((None, "roll_angle", "yaw_rate"), (1.0, -1.0)):
                known = {name: side * values if name in MIRRORED else values for name, values in columns.items() if name != absent}
                evidence = self.evidence(times_us, known)
                if evidence.turn_s is None or (manoeuvre, absent) == ("banked-straight", "yaw_rate"):
                    continue  # without a yaw rate a bank is as a turn
                turn = side * columns["yaw_rate"][round(evidence.turn_s / 0.01)]
                self.assertEqual(evidence.turn > 0.0, turn > 0.0, (manoeuvre, absent, side))
                self.assertGreater(abs(turn), 2.0, (manoeuvre, absent, side))
                for name in MIRRORED:
                    sign = evidence.sign_if_left(name)
                    if sign is not None:
                        self.assertEqual(sign, 1 if turn > 0.0 else -1, (manoeuvre, absent, name))
                        answers.setdefault(manoeuvre, set()).add(name)
        self.assertNotIn("straight", answers)
        for manoeuvre in TURNING:
            self.assertEqual(answers[manoeuvre], set(MIRRORED), manoeuvre)

    def test_a_wrong_sign_is_doubted_named_and_answered_the_other_way_round(self):
        for manoeuvre, side in itertools.product(TURNING, (1.0, -1.0)):
            times_us, columns = self.runs[manoeuvre]
            columns = {name: side * values if name in MIRRORED else values for name, values in columns.items()}
            for name in MIRRORED:
                wrong = {**columns, name: -columns[name]}
                lines, is_doubtful = consistency.reported(times_us, wrong)
                self.assertTrue(is_doubtful, (manoeuvre, name, lines))
                self.assertIn(f"LOOK: {name} runs against the others: probably that sign is wrong", lines, (manoeuvre, side))
                evidence = self.evidence(times_us, wrong)
                other = "lateral_acceleration" if name != "lateral_acceleration" else "roll_angle"
                self.assertEqual(evidence.sign_if_left(name), -evidence.sign_if_left(other), (manoeuvre, name))

    def test_neither_of_two_signals_is_named(self):
        times_us, columns = self.runs["slalom"]
        two = {name: columns[name] for name in ("lateral_acceleration", "speed")}
        two.update(yaw_rate=-columns["yaw_rate"], roll_rate=0.0 * columns["roll_rate"])
        lines, is_doubtful = consistency.reported(times_us, two)
        self.assertTrue(is_doubtful)
        self.assertFalse([line for line in lines if "against the others" in line], lines)

    def test_a_turn_is_known_from_the_value_of_no_turn(self):
        """In a unit that is not known that is the beginning's; of a vehicle that has stood, that at rest."""
        times_us, columns = self.runs["slowly-increasing-steer"]
        raw = {**columns, "yaw_rate": 32768.0 - 100.0 * columns["yaw_rate"]}
        evidence = draft.Evidence(None, {}, None)
        evidence.look(times_us, raw, {"yaw_rate"})
        self.assertLess(evidence.turn, 0.0)
        self.assertEqual(evidence.sign_if_left("yaw_rate"), -evidence.sign_if_left("roll_angle"))
        stood = numpy.zeros(300)
        from_rest = {name: numpy.concatenate([stood, values]) for name, values in columns.items()}
        from_rest["yaw_rate"] = from_rest["yaw_rate"] - 40.0
        evidence = self.evidence(numpy.arange(len(times_us) + 300) * consistency.STEP_US, from_rest)
        self.assertGreater(evidence.turn, 0.0)
        still = {**columns, "yaw_rate": 0.0 * columns["yaw_rate"]}
        self.assertEqual(self.evidence(times_us, still).anchor, "lateral_acceleration")

    def test_a_wrong_unit_is_doubted(self):
        times_us, columns = self.runs["slalom"]
        radians, gravities = numpy.radians(1.0), 1 / consistency.G_MPS2
        for name, factor in (("lateral_acceleration", gravities), ("roll_rate", radians), ("speed", 1 / 3.6),
                             ("roll_angle", radians), ("yaw_rate", radians), ("yaw_rate", 1 / radians), ("vertical_acceleration", gravities)):
            lines, is_doubtful = consistency.reported(times_us, {**columns, name: factor * columns[name]})
            self.assertTrue(is_doubtful, (name, lines))

    def test_a_unit_that_may_be_wrong_is_questioned(self):
        times_us, columns = self.runs["slalom"]
        for name, factor in (("speed", 1 / 1.609), ("speed", 1.609), ("speed", 1.852), ("roll_rate", 1 / 6.0), ("roll_rate", 6.0)):
            lines, _ = consistency.reported(times_us, {**columns, name: factor * columns[name]})
            self.assertTrue(any("check the units" in line or "units is wrong" in line for line in lines), (name, factor, lines))

    def test_right_units_are_not_questioned_in_turns_without_a_slide(self):
        for manoeuvre in ("slalom", "slow-ramp"):
            lines, is_doubtful = consistency.reported(*self.runs[manoeuvre])
            self.assertFalse(is_doubtful)
            self.assertFalse([line for line in lines if "units" in line], lines)

    def test_gaps_are_not_crossed(self):
        times_us = numpy.concatenate([numpy.arange(0, 100), numpy.arange(120, 220)]) * consistency.STEP_US
        ramp = times_us / 1.0e6
        for result in (consistency.change(times_us, ramp), consistency.turned(times_us, numpy.ones(200))):
            known = ~numpy.isnan(result)
            self.assertEqual(numpy.flatnonzero(known).tolist(), [*range(50, 100), *range(150, 200)])
            numpy.testing.assert_allclose(result[known], 0.5)
        regular_us = numpy.arange(0, 200) * consistency.STEP_US
        rate = numpy.ones(200)
        rate[[0, 120, 199]] = numpy.nan
        turned = consistency.turned(regular_us, rate)
        known = ~numpy.isnan(turned)
        self.assertEqual(numpy.flatnonzero(known).tolist(), [*range(51, 120), *range(171, 199)])
        numpy.testing.assert_allclose(turned[known], 0.5)


if __name__ == "__main__":
    support.main()
