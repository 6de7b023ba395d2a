"""A second importer, the container of fmu-manipulation-toolbox, runs ECU and vehicle together; and others can compile the
sources that are in the FMU of the ECU, to the same bits."""

import contextlib
import json
import pathlib
import shutil
import sys

import fmpy
import fmpy.build
import support
from state_test import drive

HEADERS = pathlib.Path(fmpy.__file__).parent / "c-code"


class Importers(support.WithFmus):
    def test_a_container_of_both(self):
        summary, _ = self.run_of()
        for version in support.VERSIONS:
            with self.subTest(version=version):
                folder = self.scratch()
                for model in ("ecu", "vehicle"):
                    shutil.copy(self.file(model, version), folder)
                names = [self.file(model, version).name for model in ("ecu", "vehicle")]
                (folder / "both.json").write_text(json.dumps(
                    {"name": "both.fmu", "step_size": support.STEP_S, "fmu": names,
                     "start": [[names[1], "manoeuvre", "j-turn-110"]]}), encoding="utf-8")
                support.call(pathlib.Path(sys.executable).with_name("fmucontainer"), "-container", "both.json",
                             "-fmu-directory", ".", "-fmi", version, cwd=folder)
                rows = fmpy.simulate_fmu(str(folder / "both.fmu"), stop_time=3.0, output_interval=support.STEP_S,
                                         output=["state", "side", "true.two_wheel_lift_time_s"], logger=lambda *_: None)
                # The container hands over between steps: what is said of a time is there at the end of its step.
                warned = next(row for row in rows if row["state"] == 3)
                self.assertAlmostEqual(warned["time"] - support.STEP_S, summary["warning_time_s"], delta=1e-9)
                self.assertEqual(warned["side"], 2)
                self.assertAlmostEqual(rows[-1]["true.two_wheel_lift_time_s"], summary["two_wheel_lift_time_s"], delta=1e-9)

    def bits_of(self, version, binary):
        ecu = self.instance("ecu", version, binary=binary).started()
        bits = []
        for number in range(150):
            ecu.set_numbers(ecu.of.names("input"), drive(number))
            ecu.step(number)
            bits.append(ecu.bits())
        return bits

    def test_compiled_by_the_importer(self):
        # FMPy goes by buildDescription.xml, and puts the standard's own headers on the include path.
        folder = self.scratch()
        fmpy.extract(str(self.file("ecu", 3)), unzipdir=str(folder))
        binary = folder / "binaries/x86_64-linux/rsi_ecu.so"
        packed = binary.read_bytes()
        binary.unlink()
        with contextlib.redirect_stdout(None):
            fmpy.build.build_platform_binary(folder, build_dir=self.scratch())
        self.assertNotEqual(binary.read_bytes(), packed)
        self.assertTrue(self.bits_of(3, binary) == self.bits_of(3, None), "other bits")

    def test_compiled_with_nothing_but_the_compiler(self):
        folder = self.scratch()
        fmpy.extract(str(self.file("ecu", 2)), unzipdir=str(folder))
        support.call("g++", "-std=c++17", "-O1", "-fPIC", "-shared", "-ffp-contract=off", "-I.", "rsi_ecu.cpp", "-o", "own.so",
                     cwd=folder / "sources")
        self.assertTrue(self.bits_of(2, folder / "sources/own.so") == self.bits_of(2, None), "other bits")

    def test_the_standards_own_headers_agree(self):
        support.call("g++", "-std=c++17", "-fsyntax-only", "-Wall", "-Werror", f"-I{support.PROJECT}", f"-I{HEADERS}",
                     support.PROJECT / "sil/exchange/fmu/fmi2.cpp")


if __name__ == "__main__":
    support.main()
