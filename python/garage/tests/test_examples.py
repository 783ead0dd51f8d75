"""The examples do what they say."""

import sys
from pathlib import Path

import numpy as np
import pytest

sys.path.insert(0, str(Path(__file__).parents[1] / "examples"))


def test_calibration_finds_what_is_true():
    pytest.importorskip("scipy")
    import calibrate

    values, deviations = calibrate.calibrate()
    # one of 16,000 normal numbers is further off than four standard deviations
    assert np.all(abs(values - list(calibrate.TRUE.values())) < 4 * deviations)
    assert np.all(deviations < 0.01 * values)


def test_a_policy_learns_to_ride():
    pytest.importorskip("cma")
    import ride

    policy, distance = ride.learn(4)
    assert distance > 2 * ride.distances(np.zeros(9))[0]
    assert distance == ride.distances(policy)[0], "a policy does the same again, alone or among others"
