"""ECU and vehicle in one co-simulation: together.py DIR, DIR being what `sil/exchange/fmu/build --output DIR` wrote.

The libraries are those of sil/tools/requirements.txt; with `cmake/environment/set_up --tools` they are in build/tools/venv."""

import math
import pathlib
import shutil
import sys

import fmpy
from fmpy.fmi3 import FMU3Slave

STEP_S = 0.01
STATES = ("unavailable", "ready", "advisory", "warning")
SIDES = ("", ", left side", ", right side")


class Instance:
    """An FMU under the names of its variables."""

    def __init__(self, file, **parameters):
        described = fmpy.read_model_description(file)
        self.reference = {variable.name: variable.valueReference for variable in described.modelVariables}
        self.inputs = [variable.name for variable in described.modelVariables if variable.causality == "input"]
        self.folder = fmpy.extract(file)
        self.fmu = FMU3Slave(guid=described.instantiationToken, unzipDirectory=self.folder,
                             modelIdentifier=described.coSimulation.modelIdentifier, instanceName=described.modelName)
        self.fmu.instantiate()
        for name, value in parameters.items():
            set_value = self.fmu.setString if isinstance(value, str) else self.fmu.setFloat64
            set_value([self.reference[name]], [value])
        self.fmu.enterInitializationMode()
        self.fmu.exitInitializationMode()

    def numbers(self, names):
        return self.fmu.getFloat64([self.reference[name] for name in names])

    def step(self, number):
        self.fmu.doStep(currentCommunicationPoint=number * STEP_S, communicationStepSize=STEP_S)

    def close(self):
        self.fmu.terminate()
        self.fmu.freeInstance()
        shutil.rmtree(self.folder)


def main(folder):
    vehicle = Instance(f"{folder}/rsi_vehicle_fmi3.fmu", manoeuvre="j-turn-110")
    ecu = Instance(f"{folder}/rsi_ecu_fmi3.fmu", advisory_on=0.7)
    said = None
    for number in range(300):
        # The vehicle's sensor outputs have the names of the ECU's inputs.
        ecu.fmu.setFloat64([ecu.reference[name] for name in ecu.inputs], vehicle.numbers(ecu.inputs))
        ecu.step(number)
        vehicle.step(number)
        state, side = ecu.fmu.getInt64([ecu.reference["state"], ecu.reference["side"]])
        if (state, side) != said:
            print(f"{number * STEP_S:6.2f} s  ECU: {STATES[state]}{SIDES[side]}")
            said = (state, side)
    lift_s = vehicle.numbers(["true.two_wheel_lift_time_s"])[0]
    print("no two-wheel lift-off" if math.isnan(lift_s) else f"{lift_s:6.3f} s  two wheels of one side have lifted")
    ecu.close()
    vehicle.close()


if __name__ == "__main__":
    if len(sys.argv) != 2 or not pathlib.Path(sys.argv[1], "rsi_ecu_fmi3.fmu").is_file():
        sys.exit("Use: together.py DIR, the folder into which sil/exchange/fmu/build has written the FMUs")
    main(sys.argv[1])
