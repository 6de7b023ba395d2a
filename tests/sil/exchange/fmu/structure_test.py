"""The SSP: in the form of its schema, and in FMPy the vehicle that turns hard is warned of."""

import re
import zipfile

import support
from fmpy.ssp.simulation import simulate_ssp
from fmpy.ssp.ssd import get_connections, read_ssd

READY, WARNING, RIGHT = 1, 3, 2


class Structure(support.WithFmus):
    @property
    def structure(self):
        return self.folder / "rollover_warning.ssp"

    def test_connects_every_sensor_the_driver_and_the_answers(self):
        connections = {(a.parent.name, a.name, b.parent.name) for a, b in get_connections(read_ssd(str(self.structure)).system)}
        for name in self.fmu("ecu", 2).names("input"):
            self.assertIn(("vehicle", name, "ecu"), connections)
        for name in self.fmu("vehicle", 2).names("input"):
            self.assertIn(("rollover_warning", name, "vehicle"), connections)
        for name in ("state", "side", "warning_level"):
            self.assertIn(("ecu", name, "rollover_warning"), connections)

    def test_a_hard_turn_is_warned_of(self):
        driver = {"driver.speed_mps": lambda _: 30.0, "driver.steering_wheel_angle_rad": lambda time: 5.0 if time > 0.5 else 0.0}
        run = simulate_ssp(str(self.structure), stop_time=1.0, step_size=support.STEP_S, input=driver)
        self.assertEqual((run["state"][45], run["side"][45]), (READY, 0))
        self.assertEqual((run["state"][-1], run["side"][-1]), (WARNING, RIGHT))

    def test_holds_the_same_fmus(self):
        with zipfile.ZipFile(self.structure) as archive:
            for model in ("ecu", "vehicle"):
                self.assertEqual(archive.read(f"resources/rsi_{model}_fmi2.fmu"), self.file(model, 2).read_bytes())

    @support.for_each("ecu", "vehicle")
    def test_an_fmu_has_a_page_with_every_variable(self, model, version):
        page = (self.fmu(model, version).folder / "documentation/index.html").read_text(encoding="utf-8")
        named = set(re.findall(r"<tr><td>([^<]+)</td>", page))
        variables = self.fmu(model, version).variables
        self.assertEqual(named, {name for name, variable in variables.items() if variable.causality != "independent"})


if __name__ == "__main__":
    support.main()
