"""Refusals of an FMU: a sentence with the place and what to do, through the importer's logger; and nothing has changed."""

import math

import support


class Refusal(support.WithFmus):
    def refused(self, sentence, function, *arguments, **named):
        with self.assertRaises(support.Refused) as raised:
            function(*arguments, **named)
        self.assertEqual(str(raised.exception), f"under test: {sentence}")

    def each(self, model):
        return [self.instance(model, version) for version in support.VERSIONS]

    def test_a_parameter_outside_its_range(self):
        for ecu in self.each("ecu"):
            for value, text in ((50.0, "50"), (60000.5, "60000.5"), (math.nan, "nan"), (math.inf, "inf"),
                                (-1e300, "-1e+300")):
                self.refused(f"parameter sprung_mass_kg: {text} is outside its range, 100 to 60000; give a value within it",
                             ecu.set, "sprung_mass_kg", value)
            ecu.set("sprung_mass_kg", 100.0)
            ecu.set("sprung_cg_height_m", 0.2)  # an end that is no binary fraction
            for value in (2, -1):
                self.refused(f"parameter estimator: {value} is outside its range, 0 to 1; give a value within it",
                             ecu.set, "estimator", value)
        for vehicle in self.each("vehicle"):
            self.refused("parameter geometry.track_width_m: 40 is outside its range, 0.5 to 4; give a value within it",
                         vehicle.set, "geometry.track_width_m", 40.0)

    def test_parameters_that_do_not_go_together(self):
        for ecu in self.each("ecu"):
            self.refused("parameter warning_off must not exceed warning_on; change one of them", ecu.started, warning_off=5.0)

    def test_a_manoeuvre_that_there_is_not(self):
        for vehicle in self.each("vehicle"):
            with self.assertRaisesRegex(support.Refused, "parameter manoeuvre: There is no manoeuvre 'j-turn'.*j-turn-110.*"
                                                         "Or inputs, to drive it by its inputs."):
                vehicle.started(manoeuvre="j-turn")

    def test_a_fixed_parameter_later(self):
        for ecu in self.each("ecu"):
            ecu.started()
            self.refused("parameter advisory_on is fixed; set it before initialisation ends, or reset the instance first",
                         ecu.set, "advisory_on", 0.5)
            self.assertEqual(ecu.get("advisory_on"), 0.76)

    def test_an_output_set(self):
        for ecu in self.each("ecu"):
            self.refused("state cannot be set; only parameters and inputs can", ecu.set, "state", 3)

    def test_steps_of_another_length(self):
        for model in ("ecu", "vehicle"):
            for instance in self.each(model):
                instance.started()
                for step_s, text in ((0.0, "0"), (-0.01, "-0.01"), (math.nan, "nan"), (1e9, "1e+09")):
                    self.refused(f"a step of {text} s; give one above 0 and up to 10000 s, best 0.01 s", instance.step, 0, step_s)
                instance.step(0)

    def test_a_step_from_another_time(self):
        for ecu in self.each("ecu"):
            ecu.started(start_s=5.0)
            self.refused("a step from 7 s, but 5 s is reached; step from there, or restore a state of that time",
                         ecu.step, 200, start_s=5.0)
            ecu.step(0, start_s=5.0)
            self.assertAlmostEqual(ecu.get("time"), 5.01, delta=1e-12)

    def test_a_step_before_initialisation(self):
        for ecu in self.each("ecu"):
            self.refused("a step before initialisation has ended, or after termination; initialise first", ecu.step, 0)

    def test_inputs_of_the_driver(self):
        for vehicle in self.each("vehicle"):
            vehicle.started()
            self.refused("input driver.brake: 1.5 is outside its range, 0 to 1; give a value within it",
                         vehicle.set, "driver.brake", 1.5)
            self.refused("input driver.steering_wheel_angle_rad: nan is outside its range, -30 to 30; give a value within it",
                         vehicle.set, "driver.steering_wheel_angle_rad", math.nan)

    def test_any_number_for_a_sensor_is_survived(self):
        for ecu in self.each("ecu"):
            ecu.started()
            names = ecu.of.names("input")
            for number, value in enumerate((math.nan, math.inf, -math.inf, 1e300, -1e300, 5e-324, 0.0)):
                ecu.set_numbers(names, [value] * len(names))
                ecu.step(number)
            self.assertEqual(ecu.get("state"), 0)

    def test_a_variable_that_there_is_not(self):
        for ecu in self.each("ecu"):
            get = ecu.fmu.getReal if ecu.of.is_fmi2 else ecu.fmu.getFloat64
            self.refused("there is no variable with the value reference 4000000000; modelDescription.xml names them",
                         ecu.asked, get, [4000000000])
            state = ecu.of.variables["state"].valueReference
            self.refused("state is an enumeration and not a number; get and set it as such", ecu.asked, get, [state])

    def test_a_description_of_another_fmu(self):
        for version in support.VERSIONS:
            with self.assertRaises(support.Refused) as raised:
                support.Instance(self.fmu("ecu", version), token="{00000000-0000-0000-0000-000000000000}")
            self.assertEqual(str(raised.exception), "under test: the modelDescription.xml that was read is not this FMU's; "
                                                    "unpack the FMU anew")

    def test_missing_functions(self):
        ecu = self.instance("ecu", 3).started()
        self.refused("fmi3EnterEventMode is not offered by this FMU; modelDescription.xml says what is",
                     ecu.asked, ecu.fmu.enterEventMode)


if __name__ == "__main__":
    support.main()
