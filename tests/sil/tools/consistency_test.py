"""Comparison of signals, over every manoeuvre of the catalogue: no good drive is doubted, no sign is answered
wrongly, and wrong signs and units show."""

import numpy

import support

import consistency
import draft
import foreign_recorder

UNITS = {"lateral_acceleration": "mps2", "roll_rate": "degps", "roll_angle": "deg", "yaw_rate": "degps",
         "steering_wheel_angle": "deg", "speed": "mps", "vertical_acceleration": "mps2"}
TURNING = ("slalom", "j-turn-45", "double-lane-change", "step-steer")


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
        answers = {}
        for manoeuvre, (times_us, columns) in self.runs.items():
            for absent in (None, "roll_angle", "yaw_rate"):
                known = {name: values for name, values in columns.items() if name != absent}
                evidence = self.evidence(times_us, known)
                for name in (*draft.SIGNED, "roll_rate"):
                    sign = evidence.sign_if_left(name)
                    if sign is not None:
                        self.assertEqual(sign, 1 if evidence.turn > 0.0 else -1, (manoeuvre, absent, name))
                        answers.setdefault(manoeuvre, set()).add(name)
        self.assertNotIn("straight", answers)
        for manoeuvre in TURNING:
            self.assertEqual(answers[manoeuvre], {*draft.SIGNED, "roll_rate"}, manoeuvre)

    def test_a_wrong_sign_is_doubted_and_answered_the_other_way_round(self):
        for manoeuvre in TURNING:
            times_us, columns = self.runs[manoeuvre]
            for name in (*draft.SIGNED, "roll_rate"):
                wrong = {**columns, name: -columns[name]}
                lines, is_doubtful = consistency.reported(times_us, wrong)
                self.assertTrue(is_doubtful, (manoeuvre, name, lines))
                evidence = self.evidence(times_us, wrong)
                other = "lateral_acceleration" if name != "lateral_acceleration" else "roll_angle"
                self.assertEqual(evidence.sign_if_left(name), -evidence.sign_if_left(other), (manoeuvre, name))

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
