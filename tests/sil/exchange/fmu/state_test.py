"""Saved and restored, copied as bytes, or beside others in one process: the same bits."""

import math

import support

MANOEUVRE = {"manoeuvre": "fishhook-1b", "sensors__noise": True}  # a driver with a memory, and drawn noise


def drive(number):
    """Sensor signals of some turn, for an ECU alone."""
    turn = math.sin(0.05 * number)
    return [6.0 * turn, 9.8, 0.2 * math.cos(0.05 * number), 0.05 * turn, 0.2 * turn, math.nan, 25.0, turn, math.nan]


class State(support.WithFmus):
    def assert_same_bits(self, ours, theirs):
        """A difference is not shown: it would be long, and slow."""
        self.assertTrue(ours == theirs, "other bits")

    def started(self, model, version, **parameters):
        return self.instance(model, version).started(**(parameters if model == "ecu" else MANOEUVRE | parameters))

    def stepped(self, instance, numbers):
        """The bits after each step."""
        bits = []
        for number in numbers:
            if "state" in instance.of.variables:
                instance.set_numbers(instance.of.names("input"), drive(number))
            instance.step(number)
            bits.append(instance.bits())
        return bits

    @support.for_each("ecu", "vehicle")
    def test_restored_in_the_middle_gives_the_same_bits(self, model, version):
        instance = self.started(model, version)
        self.stepped(instance, range(110))
        state = instance.saved()
        once = self.stepped(instance, range(110, 220))
        self.assertGreater(len(set(once)), 100)
        instance.restore(state)
        self.assert_same_bits(self.stepped(instance, range(110, 220)), once)
        instance.restore(state)
        self.assert_same_bits(self.stepped(instance, range(110, 130)), once[:20])
        instance.asked(instance.fmu.freeFMUState, state)

    def test_as_bytes_into_another_instance(self):
        for version in support.VERSIONS:
            first = self.started("ecu", version, advisory_on=0.75)
            self.stepped(first, range(90))
            content = first.asked(first.fmu.serializeFMUState, first.saved())
            once = self.stepped(first, range(90, 150))
            other = self.started("ecu", version)
            other.restore(other.asked(other.fmu.deserializeFMUState, content))
            self.assertEqual(other.get("advisory_on"), 0.75)
            self.assert_same_bits(self.stepped(other, range(90, 150)), once)

    def test_as_bytes_in_the_middle_of_a_cycle(self):
        for version in support.VERSIONS:
            first = self.started("ecu", version)
            self.stepped(first, range(90))
            first.set_numbers(first.of.names("input"), drive(90))
            first.step(90, 0.3 * support.STEP_S)
            content = first.asked(first.fmu.serializeFMUState, first.saved())
            other = self.started("ecu", version)
            other.restore(other.asked(other.fmu.deserializeFMUState, content))
            before = first.bits()
            for each in (first, other):
                each.set_numbers(each.of.names("input"), [math.nan] * 9)
                each.step(90.3, 0.7 * support.STEP_S)
            self.assert_same_bits(other.bits(), first.bits())
            self.assertFalse(first.bits() == before, "the cycle has not ended")

    def test_damaged_bytes_are_refused(self):
        for version in support.VERSIONS:
            ecu = self.started("ecu", version)
            content = ecu.asked(ecu.fmu.serializeFMUState, ecu.saved())
            damaged = [content[:-1], content + b"x", b"", b"x" * len(content), content[:8] + bytes(len(content) - 8)]
            damaged += [content[:place] + bytes([content[place] ^ 1]) + content[place + 1:]
                        for place in range(0, len(content), 97)]
            before = ecu.bits()
            for each in damaged:
                with self.assertRaisesRegex(support.Refused, "no state of this FMU, or they are damaged"):
                    ecu.asked(ecu.fmu.deserializeFMUState, each)
            self.assertEqual(ecu.bits(), before)

    def test_the_vehicle_says_that_it_cannot_be_told_as_bytes(self):
        for version in support.VERSIONS:
            vehicle = self.started("vehicle", version)
            self.assertIn("canSerializeFMU" + ("state" if version == 2 else "State") + '="false"',
                          (vehicle.of.folder / "modelDescription.xml").read_text(encoding="utf-8"))
            with self.assertRaisesRegex(support.Refused, "cannot be serialised; save and restore it within the process"):
                vehicle.asked(vehicle.fmu.serializeFMUState, vehicle.saved())

    @support.for_each("ecu", "vehicle")
    def test_a_state_of_another_instance_or_a_freed_one_is_refused(self, model, version):
        mine, other = self.started(model, version), self.started(model, version)
        state = mine.saved()
        with self.assertRaisesRegex(support.Refused, "was not saved by this instance, or it was freed"):
            other.restore(state)
        with self.assertRaisesRegex(support.Refused, "was not saved by this instance"):
            mine.restore(None)

    @support.for_each("ecu", "vehicle")
    def test_reset_begins_anew(self, model, version):
        instance = self.started(model, version)
        once = self.stepped(instance, range(60))
        instance.asked(instance.fmu.reset)
        instance.started(**({} if model == "ecu" else MANOEUVRE))
        self.assert_same_bits(self.stepped(instance, range(60)), once)

    @support.for_each("ecu", "vehicle")
    def test_instances_do_not_know_each_other(self, model, version):
        different = {"ecu": {"prediction_horizon_s": 0.3}, "vehicle": {"sensors__seed": 5}}
        alone = [self.stepped(self.started(model, version), range(80)),
                 self.stepped(self.started(model, version, **different[model]), range(80))]
        self.assertFalse(alone[0] == alone[1])
        pair = [self.started(model, version), self.started(model, version, **different[model])]
        together = [[], []]
        for number in range(80):
            for instance, bits in zip(pair, together):
                bits += self.stepped(instance, [number])
        self.assert_same_bits(together, alone)

    def test_both_versions_give_the_same_bits(self):
        for model in ("ecu", "vehicle"):
            two, three = (self.stepped(self.started(model, version), range(60)) for version in support.VERSIONS)
            self.assert_same_bits(two, three)


if __name__ == "__main__":
    support.main()
