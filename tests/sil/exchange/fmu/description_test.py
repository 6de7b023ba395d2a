"""modelDescription.xml: FMPy finds nothing wrong, and it says what the one table of each thing says."""

import re
import tomllib

import fmpy.validation
import support

class Description(support.WithFmus):
    @support.for_each("ecu", "vehicle")
    def test_fmpy_finds_nothing_wrong(self, model, version):
        self.assertEqual(fmpy.validation.validate_fmu(str(self.file(model, version))), [])

    def test_parameters_are_those_of_the_files(self):
        calibration = tomllib.loads((support.PROJECT / "firmware/calibrations/large_suv.toml").read_text(encoding="utf-8"))
        tables = tomllib.loads((support.PROJECT / "sil/vehicles/large_suv.toml").read_text(encoding="utf-8"))
        vehicle = {f"{table}.{key}": value for table, keys in tables.items() if isinstance(keys, dict)
                   for key, value in keys.items()}
        for version in support.VERSIONS:
            ecu = self.fmu("ecu", version)
            self.assertEqual(set(ecu.names("parameter")), set(calibration))
            for name, value in calibration.items():
                self.assertEqual(self.start(ecu, name), value, name)
            described = self.fmu("vehicle", version)
            left_out = {"steering.lag_s", "steering.compliance_radpn"}  # may be left out of a file, and are 0 then
            self.assertLessEqual(set(vehicle), set(described.names("parameter")))
            self.assertEqual({name for name in described.names("parameter") if "." in name and not name.startswith("sensors.")}
                             - set(vehicle) - left_out, set())
            for name, value in vehicle.items():
                self.assertEqual(self.start(described, name), value, name)

    @staticmethod
    def start(unpacked, name):
        variable = unpacked.variables[name]
        if variable.type == "Enumeration":
            return next(item.name for item in variable.declaredType.items if str(item.value) == str(variable.start))
        return float(variable.start)

    def test_outputs_are_those_of_the_component(self):
        table = (support.PROJECT / "firmware/rsi/rsi_outputs.h").read_text(encoding="utf-8")
        rows = re.findall(r"^    (?:CODE|NUMBER|INDEX)\((\w+),", table, re.M)
        self.assertGreater(len(rows), 30)
        for version in support.VERSIONS:
            self.assertEqual(self.fmu("ecu", version).names("output"), rows)
            self.assertLess({"state", "side", "warning_level"}, set(rows))

    def test_the_vehicles_sensors_are_the_inputs_of_the_ecu(self):
        for version in support.VERSIONS:
            ecu, vehicle = self.fmu("ecu", version), self.fmu("vehicle", version)
            for name in ecu.names("input"):
                self.assertEqual(vehicle.variables[name].causality, "output")
                self.assertEqual(vehicle.variables[name].unit, ecu.variables[name].unit)
                self.assertIsNotNone(ecu.variables[name].unit, name)

    def test_descriptions_are_those_for_an_importer(self):
        for version in support.VERSIONS:
            variables = self.fmu("ecu", version).variables
            self.assertIn("0 unavailable, 1 ready, 2 advisory, 3 warning", variables["state"].description)
            self.assertIn("1 left, 2 right", variables["side"].description)
            self.assertEqual(variables["roll_stiffness_nmprad"].description, "roll stiffness, K_f")
            self.assertEqual((variables["sprung_mass_kg"].min, variables["sprung_mass_kg"].max), ("100", "60000"))
            for name, choices in (("state", ["unavailable", "ready", "advisory", "warning"]), ("side", ["none", "left", "right"])):
                self.assertEqual([item.name for item in variables[name].declaredType.items], choices)
            self.assertEqual({variables[name].type for name in ("roll_sensor_disagrees", "estimate_frozen")}, {"Boolean"})

    @support.for_each("ecu", "vehicle")
    def test_every_variable_is_described_and_its_unit_shown(self, model, version):
        for name, variable in self.fmu(model, version).variables.items():
            self.assertRegex(variable.description or "", r"[a-z]{3,}", name)
            self.assertEqual(variable.displayUnit, {"rad": "deg", "rad/s": "deg/s", "m/s": "km/h"}.get(variable.unit, variable.unit))

    @support.for_each("ecu", "vehicle")
    def test_every_ranged_value_starts_within_its_range(self, model, version):
        for name, variable in self.fmu(model, version).variables.items():
            if variable.causality == "parameter" and variable.min is not None:
                self.assertTrue(float(variable.min) <= float(variable.start) <= float(variable.max), name)

    @support.for_each("ecu", "vehicle")
    def test_functions_of_the_standard_only_are_exported(self, model, version):
        # Any other exported symbol could be taken for another FMU's in the same process.
        exported = support.call("nm", "-D", "--defined-only", self.fmu(model, version).binary())
        names = {line.split()[-1] for line in exported.splitlines()}
        self.assertIn("fmi3DoStep", names)
        self.assertEqual({name for name in names if not name.startswith(("fmi2", "fmi3"))}, {"rsi_fmu_variables"})

    @support.for_each("ecu", "vehicle")
    def test_needs_nothing_that_is_not_on_every_linux(self, model, version):
        needed = re.findall(r"NEEDED.*\[(.*)\]", support.call("readelf", "-d", self.fmu(model, version).binary()))
        everywhere = {"libstdc++", "libm", "libgcc_s", "libc", "ld-linux-x86-64"}
        self.assertLessEqual({name.split(".so")[0] for name in needed}, everywhere)


if __name__ == "__main__":
    support.main()
