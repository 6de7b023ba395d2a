"""10,000 foreign frames a second beside rsi-ecu, on a machine that does nothing else: the cycle holds.

Requirements on every machine: bus_load_test.py."""

import unittest

import bus_load_test
from bus_load_test import setUpModule, tearDownModule  # unittest calls them by these names

__all__ = ["setUpModule", "tearDownModule"]


class Pace(unittest.TestCase):
    def check_flood(self, run):
        self.assertGreaterEqual(run.flood_rate, bus_load_test.LEAST_RATE, "this machine is too slow or too busy")

    def test_with_filters_the_cycle_holds_as_well_as_that_of_an_ecu_without_flood(self):
        run = bus_load_test.flooded_run(good=bus_load_test.FloodedRun.cycle_held, most=4)
        self.check_flood(run)
        self.assertTrue(run.cycle_held(), run.describe())

    def test_without_filters_the_loss_is_reported_and_the_ecu_recovers(self):
        run = bus_load_test.flooded_run(
            "--receive-everything", good=bus_load_test.FloodedRun.flood_was_fast_enough, most=4
        )
        self.check_flood(run)
        self.assertTrue(run.lost_some_and_recovered(), run.describe())


if __name__ == "__main__":
    unittest.main()
