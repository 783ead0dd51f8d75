"""Runs an unpacked FMU by FMPy: python check_unit.py FOLDER UNTIL.

Validates its description, compares directional derivatives with differences, saves and restores a state, and prints the states at the end, by
co-simulation and by model exchange with CVODE.
"""

import sys

import fmpy
import numpy as np
from fmpy.fmi1 import FMICallException
from fmpy.fmi2 import FMU2Slave
from fmpy.fmi3 import FMU3Slave
from fmpy.validation import validate_fmu

# of the largest derivative, for steps of 1e-6: half of the digits of central differences
OF_DIFFERENCES = 1e-7

folder, until = sys.argv[1], float(sys.argv[2])
assert validate_fmu(folder) == [], validate_fmu(folder)
description = fmpy.read_model_description(folder)
is_two = description.fmiVersion.startswith("2")
names = {variable.name: variable for variable in description.modelVariables}
derivatives = [variable for variable in description.modelVariables if variable.derivative is not None]
states = [variable.derivative for variable in derivatives]
said = []


def logged(*arguments):
    text = arguments[-1]
    said.append(text.decode() if isinstance(text, bytes) else text)


def new():
    common = dict(unzipDirectory=folder, modelIdentifier=description.coSimulation.modelIdentifier, instanceName="unit")
    unit = FMU2Slave(guid=description.guid, **common) if is_two else FMU3Slave(guid=description.guid, **common)
    unit.instantiate()
    if is_two:
        unit.setupExperiment(tolerance=1e-10, startTime=0.0)
        unit.enterInitializationMode()
    else:
        unit.enterInitializationMode(tolerance=1e-10, startTime=0.0)
    unit.exitInitializationMode()
    return unit


def get(unit, variables):
    references = [variable.valueReference for variable in variables]
    return np.array(unit.getReal(references) if is_two else unit.getFloat64(references))


def set_to(unit, variables, values):
    references = [variable.valueReference for variable in variables]
    (unit.setReal if is_two else unit.setFloat64)(references, list(values))


unit = new()

# directional derivatives along a direction of all states and inputs
if description.modelExchange.providesDirectionalDerivative:
    inputs = [variable for variable in description.modelVariables if variable.causality == "input"]
    knowns = states + inputs
    calculated = [variable for variable in description.modelVariables if variable.causality == "output" and variable.initial == "calculated"]
    unknowns = derivatives + calculated
    x = get(unit, knowns)
    seed = np.cos(np.arange(len(x)) + 1.0)
    arguments = [variable.valueReference for variable in unknowns], [variable.valueReference for variable in knowns], list(seed)
    exact = np.array(unit.getDirectionalDerivative(*arguments))
    step = 1e-6
    ends = []
    for side in (1, -1):
        set_to(unit, knowns, x + side * step * seed)
        ends.append(get(unit, unknowns))
    set_to(unit, knowns, x)
    difference = (ends[0] - ends[1]) / (2 * step)
    worst = abs(exact - difference).max()
    assert worst <= OF_DIFFERENCES * max(1.0, abs(exact).max()), worst

# what is saved goes on with the same bits, in bytes, too
half = min(until, 0.2) / 2
unit.doStep(0.0, half)
saved = unit.getFMUState() if not is_two else unit.getFMUstate()
unit.doStep(half, half)
end = get(unit, states)
(unit.setFMUState if not is_two else unit.setFMUstate)(saved)
unit.doStep(half, half)
assert np.array_equal(end, get(unit, states))
serialized = (unit.serializeFMUState if not is_two else unit.serializeFMUstate)(saved)
other = new()
restored = (other.deserializeFMUState if not is_two else other.deSerializeFMUstate)(serialized)
(other.setFMUState if not is_two else other.setFMUstate)(restored)
other.doStep(half, half)
assert np.array_equal(end, get(other, states))

# a state that is no number is refused, and the importer is told why
try:
    set_to(unit, states[:1], [float("nan")])
    raise SystemExit("a state that is no number was taken")
except FMICallException:
    pass

for kind in ("CoSimulation", "ModelExchange"):
    result = fmpy.simulate_fmu(folder, fmi_type=kind, stop_time=until, output_interval=until / 20, relative_tolerance=1e-10,
                               output=[variable.name for variable in states], logger=logged)
    print(*(repr(float(x)) for x in list(result[-1])))
assert not said, said
