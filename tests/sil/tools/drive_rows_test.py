"""The common clock against known answers: interpolation, averages, gaps, ends, lags, units."""

import unittest

import support  # the tools' folder on the path

import numpy

import drive
import drive_rows
import recorded
from drive_quantities import UNITS, factor_of
from mapping import Entry

GRID_US = numpy.arange(0, 1_000_000, 10_000)


def ramp(times_us):
    return 3.0 * times_us / 1.0e6 + 1.0


class Rows(unittest.TestCase):
    def sampled(self, times_us, values=None):
        times_us = numpy.asarray(times_us)
        return drive_rows.sampled(times_us, ramp(times_us) if values is None else numpy.asarray(values), GRID_US)

    def test_a_ramp_stays_a_ramp_at_any_rate(self):
        for period_us in (100_000, 20_000, 10_000, 8_000, 3_000, 1_000):
            times_us = numpy.arange(-200_000, 1_300_000, period_us) + 1_234
            numpy.testing.assert_allclose(self.sampled(times_us), ramp(GRID_US), rtol=0.0, atol=0.004, err_msg=str(period_us))

    def test_a_fast_signal_is_averaged_by_a_triangle(self):
        times_us = numpy.arange(0, 1_000_000, 1_000)
        alternating = self.sampled(times_us, numpy.where(numpy.arange(len(times_us)) % 2 == 0, 1.0, -1.0))
        self.assertLess(numpy.abs(alternating[1:-1]).max(), 0.01)
        pulse = numpy.zeros(len(times_us))
        pulse[505] = 1.0  # half way between two rows
        rows = self.sampled(times_us, pulse)
        self.assertAlmostEqual(rows[50], 0.05)
        self.assertAlmostEqual(rows[51], 0.05)
        self.assertAlmostEqual(float(rows.sum()), 0.1)

    def test_nothing_is_invented_in_gaps(self):
        regular = numpy.arange(0, 1_000_000, 10_000)
        for silence_us, bridged in ((30_000, True), (40_000, False)):
            times_us = regular[(regular <= 500_000) | (regular >= 500_000 + silence_us)]
            unknown = GRID_US[numpy.isnan(self.sampled(times_us))]
            expected = [] if bridged else [510_000, 520_000, 530_000]
            self.assertEqual(unknown.tolist(), expected, silence_us)
        slow = numpy.arange(0, 1_000_000, 100_000)
        self.assertFalse(numpy.isnan(self.sampled(slow)).any())
        unknown = GRID_US[numpy.isnan(self.sampled(slow[(slow < 300_000) | (slow > 500_000)]))]
        self.assertEqual((unknown[0], unknown[-1], len(unknown)), (210_000, 590_000, 39))

    def test_the_ends_are_held_for_a_period(self):
        rows = self.sampled([500_000, 520_000, 540_000], [1.0, 2.0, 3.0])
        known = GRID_US[~numpy.isnan(rows)]
        self.assertEqual(known.tolist(), [490_000, 500_000, 510_000, 520_000, 530_000, 540_000, 550_000])
        self.assertEqual(rows[49:56].tolist(), [1.0, 1.0, 1.5, 2.0, 2.5, 3.0, 3.0])

    def test_missing_values_are_counted(self):
        times_us = numpy.delete(numpy.arange(0, 1_000_000, 10_000), [20, 50, 51, 52, 53])
        found = drive_rows.examine(times_us)
        self.assertEqual((found.period_us, found.missing, found.gaps, found.longest_us), (10_000, 5, 1, 50_000))

    def test_disorder_and_repetitions(self):
        times_us, values = recorded.in_order(numpy.array([20, 10, 30, 20, 30]), numpy.array([1.0, 2.0, 3.0, 4.0, 5.0]))
        self.assertEqual((times_us.tolist(), values.tolist()), ([10, 20, 30], [2.0, 4.0, 5.0]))

    def test_factor_offset_unit_sign_and_lag(self):
        class Units:
            @staticmethod
            def unit_factor(entry, _):
                return factor_of(entry.unit, "acceleration")

        one = recorded.Recorded(numpy.array([100_000, 200_000]), numpy.array([10.0, -30.0]), "", {})
        entry = Entry("lateral_acceleration", "a", "g", 0.02, 0.1, -1, 0.05, None)
        applied = drive.applied(entry, one, Units)
        self.assertEqual(applied.times_us.tolist(), [50_000, 150_000])
        numpy.testing.assert_allclose(applied.values, [-0.3 * 9.80665, 0.5 * 9.80665])

    def test_units(self):
        radian = 57.29577951308232
        known = {"acceleration": {"m/s\u00b2": 1.0, "m/s^2": 1.0, "[m/s2]": 1.0, "mps2": 1.0, "m s-2": 1.0, "G": 9.80665},
                 "rate": {"\u00b0/s": 1.0, "deg/sec": 1.0, "Degree/s": 1.0, "deg_per_s": 1.0, "rad/s": radian, "rad s-1": radian},
                 "angle": {"\u00b0": 1.0, "degrees": 1.0, "rad": radian},
                 "speed": {"km/h": 1.0, "KPH": 1.0, "m/s": 3.6, "mph": 1.609344, "kn": 1.852},
                 "force": {"kN": 1000.0}, "mass": {"t": 1000.0}, "time": {"ms": 0.001}}
        for dimension, units in known.items():
            for spelling, factor in units.items():
                self.assertAlmostEqual(factor_of(spelling, dimension), factor, msg=spelling)
        for dimension, spelling in (("rate", "rad"), ("angle", "deg/s"), ("acceleration", "m/s"), ("angle", ""), ("angle", "%"),
                                    ("speed", "V")):
            self.assertIsNone(factor_of(spelling, dimension), spelling)
        for dimension, units in UNITS.items():
            for unit, factor in units.items():
                self.assertEqual(factor_of(unit, dimension), factor)


if __name__ == "__main__":
    support.sys.argv[1:] = []
    unittest.main()
