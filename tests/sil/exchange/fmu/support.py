"""Shared by the tests of the FMUs: an instance in FMPy whose variables have names, for FMI 2.0 and 3.0 alike."""

import functools
import json
import pathlib
import shutil
import struct
import subprocess
import sys
import tempfile
import unittest

import fmpy
from fmpy.fmi2 import FMU2Slave
from fmpy.fmi3 import FMU3Slave

PROJECT = pathlib.Path(__file__).resolve().parents[4]
STEP_S = 0.01
VERSIONS = (2, 3)


def for_each(*models):
    """A test of one FMU, for each of these models and both versions of FMI."""

    def decorate(test):
        @functools.wraps(test)
        def all_of_them(self):
            for model in models:
                for version in VERSIONS:
                    with self.subTest(model=model, version=version):
                        test(self, model, version)

        return all_of_them

    return decorate


class Refused(Exception):
    """Messages of the FMU through its logger."""


class Unpacked:
    """An FMU, unpacked once for all of its instances."""

    def __init__(self, file):
        self.description = fmpy.read_model_description(str(file))
        self.folder = pathlib.Path(fmpy.extract(str(file)))
        self.is_fmi2 = self.description.fmiVersion == "2.0"
        self.variables = {variable.name: variable for variable in self.description.modelVariables}

    def names(self, causality):
        return [name for name, variable in self.variables.items() if variable.causality == causality]

    def binary(self):
        return next(self.folder.glob("binaries/*/*.so"))

    def close(self):
        shutil.rmtree(self.folder)


class Instance:
    def __init__(self, unpacked, name="under test", token=None, binary=None):
        self.of = unpacked
        self.said = []
        description = unpacked.description
        kind = FMU2Slave if unpacked.is_fmi2 else FMU3Slave
        token = token or (description.guid if unpacked.is_fmi2 else description.instantiationToken)
        self.fmu = kind(guid=token, unzipDirectory=str(unpacked.folder), instanceName=name, libraryPath=binary and str(binary),
                        modelIdentifier=description.coSimulation.modelIdentifier)
        if unpacked.is_fmi2:
            callbacks = fmpy.fmi2.fmi2CallbackFunctions()
            callbacks.logger = fmpy.fmi2.fmi2CallbackLoggerTYPE(lambda _, __, ___, ____, text: self.said.append(text.decode()))
            callbacks.allocateMemory = fmpy.fmi2.fmi2CallbackAllocateMemoryTYPE(fmpy.calloc)
            callbacks.freeMemory = fmpy.fmi2.fmi2CallbackFreeMemoryTYPE(fmpy.free)
            self.asked(self.fmu.instantiate, callbacks=callbacks)
        else:
            self.asked(self.fmu.instantiate, logMessage=lambda _, __, ___, text: self.said.append(text.decode()))

    def asked(self, function, *arguments, **named):
        """Calls the FMU; what it refuses is raised with its own words."""
        self.said.clear()
        try:
            return function(*arguments, **named)
        except Exception as error:
            raise Refused(" ".join(self.said) or f"nothing was said: {error}") from None

    def started(self, start_s=0.0, **parameters):
        for name, value in parameters.items():
            self.set(name.replace("__", "."), value)
        if self.of.is_fmi2:
            self.asked(self.fmu.setupExperiment, startTime=start_s)
            self.asked(self.fmu.enterInitializationMode)
        else:
            self.asked(self.fmu.enterInitializationMode, startTime=start_s)
        self.asked(self.fmu.exitInitializationMode)
        return self

    def function(self, action, name):
        kind = self.of.variables[name].type
        if self.of.is_fmi2:
            kind = {"Enumeration": "Integer"}.get(kind, kind)
        else:
            kind = {"Enumeration": "Int64"}.get(kind, kind)
        return getattr(self.fmu, action + kind)

    def set(self, name, value):
        self.asked(self.function("set", name), [self.of.variables[name].valueReference], [value])

    def get(self, name):
        return self.asked(self.function("get", name), [self.of.variables[name].valueReference])[0]

    def numbers(self, names):
        get = self.fmu.getReal if self.of.is_fmi2 else self.fmu.getFloat64
        return self.asked(get, [self.of.variables[name].valueReference for name in names])

    def set_numbers(self, names, values):
        give = self.fmu.setReal if self.of.is_fmi2 else self.fmu.setFloat64
        self.asked(give, [self.of.variables[name].valueReference for name in names], values)

    def step(self, number, step_s=STEP_S, start_s=0.0):
        self.asked(self.fmu.doStep, currentCommunicationPoint=start_s + number * STEP_S, communicationStepSize=step_s)

    def bits(self):
        """Every output that is a number or a code, to the last bit."""
        values = [self.get(name) for name in self.of.names("output")]
        return struct.pack(f"<{len(values)}d", *(float(value) for value in values))

    def saved(self):
        return self.asked(self.fmu.getFMUState)

    def restore(self, state):
        self.asked(self.fmu.setFMUState, state)

    def close(self):
        self.fmu.freeInstance()


class WithFmus(unittest.TestCase):
    """self.fmu(model, version), and instances that are closed after the test."""

    folder = None  # of the FMUs
    program = None  # rsi-sil

    @classmethod
    def setUpClass(cls):
        cls.unpacked = {}

    @classmethod
    def tearDownClass(cls):
        for each in cls.unpacked.values():
            each.close()

    @classmethod
    def file(cls, model, version):
        return cls.folder / f"rsi_{model}_fmi{version}.fmu"

    @classmethod
    def fmu(cls, model, version):
        if (model, version) not in cls.unpacked:
            cls.unpacked[model, version] = Unpacked(cls.file(model, version))
        return cls.unpacked[model, version]

    def instance(self, model, version, name="under test", binary=None):
        made = Instance(self.fmu(model, version), name, binary=binary)
        self.addCleanup(made.close)
        return made

    def scratch(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        return pathlib.Path(scratch.name)

    def run_of(self, *options):
        """Summary and folder of a run of rsi-sil with the vehicle of the FMUs."""
        output = self.scratch() / "run"
        call(self.program, "run", "j-turn-110", "--in-process", "--vehicle", PROJECT / "sil/vehicles/large_suv.toml",
             "--parameters", PROJECT / "firmware/calibrations/large_suv.toml", "--output", output, *options)
        return json.loads((output / "summary.json").read_text(encoding="utf-8")), output


def call(*parts, **options):
    finished = subprocess.run([str(part) for part in parts], capture_output=True, text=True, check=False, timeout=600, **options)
    if finished.returncode != 0:
        raise AssertionError(f"{parts} failed:\n{finished.stdout}{finished.stderr}")
    return finished.stdout


def main():
    WithFmus.folder = pathlib.Path(sys.argv.pop(1))
    WithFmus.program = pathlib.Path(sys.argv.pop(1))
    unittest.main()
