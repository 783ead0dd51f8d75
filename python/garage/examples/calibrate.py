"""Finds the moment of inertia and the damping of a machine from a measured motion, by least squares of SciPy.

The measurement here is a run with known values and noise, so that one can see what comes back:

    pip install scipy
    python calibrate.py
"""

import ezy
import numpy as np
from scipy.optimize import least_squares

TIMES = np.linspace(0, 4, 81)
NOISE = 2e-3  # rad
TRUE = {"i1": 12.5, "m0": 2.6}


def angles(values):
    """The bar's angle at the times of the measurement, rad."""
    run = ezy.ezyroller.driven(**values).run(until=TIMES[-1], at=list(TIMES), rtol=1e-9)
    return run["bar.phi"]


def slopes(values):
    """Its exact derivatives by the values, in the order of TRUE: a row for each time."""
    scene = ezy.ezyroller.driven(**values)
    found = scene.sensitivities(list(TRUE), until=TIMES[-1], at=list(TIMES), rtol=1e-9)
    return found.jacobian("bar.phi")[:, 0, :]


def calibrate():
    """The values found, and their standard deviations, in the order of TRUE."""
    measured = angles(TRUE) + NOISE * np.random.default_rng(3).standard_normal(len(TIMES))
    found = least_squares(
        lambda x: (angles(dict(zip(TRUE, x))) - measured) / NOISE,
        jac=lambda x: slopes(dict(zip(TRUE, x))) / NOISE,
        x0=[10.0, 2.0],
        x_scale=[10.0, 2.0],
    )
    covariance = np.linalg.inv(found.jac.T @ found.jac)
    return found.x, np.sqrt(np.diag(covariance))


if __name__ == "__main__":
    values, deviations = calibrate()
    for (name, true), value, deviation in zip(TRUE.items(), values, deviations):
        unit = ezy.ezyroller.driven.parameters[name][1]
        print(f"{name} = {value:.4f} ± {deviation:.4f} {unit}, and {true} is true")
