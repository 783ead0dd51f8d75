"""Runs an unpacked FMU by FMPy until a step fails: python check_failing.py FOLDER. Prints what the importer is told."""

import sys

import fmpy
from fmpy.fmi1 import FMICallException

said = []


def logged(*arguments):
    text = arguments[-1]
    said.append(text.decode() if isinstance(text, bytes) else text)


try:
    fmpy.simulate_fmu(sys.argv[1], fmi_type="CoSimulation", stop_time=1.0, logger=logged)
except FMICallException:
    print(*said, sep="\n")
else:
    raise SystemExit("no step failed")
