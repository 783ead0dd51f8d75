"""The module as Python sees it."""

import os
import pathlib

import my_mechanism
import numpy as np
import pytest

STUB = pathlib.Path(__file__).parents[1] / "my_mechanism.pyi"


def scenes():
    return [kind for kind in vars(my_mechanism).values() if isinstance(kind, my_mechanism.SceneType)]


@pytest.mark.parametrize("kind", scenes(), ids=lambda kind: kind.name)
def test_equations_are_those_of_finite_differences(kind):
    kind().check()


def test_it_rolls_out_against_the_air():
    run = my_mechanism.coast(k=0.5).run(rtol=1e-9, every=0.1)
    energy = run["kinetic"]
    assert run.outcome.startswith("reached the end") and (np.diff(energy) < 0).all()


def test_a_wrong_name_is_told_from_a_right_one():
    with pytest.raises(my_mechanism.EzyError, match="did you mean"):
        my_mechanism.coast(trial=0.1)


def test_the_types_are_those_of_the_model():
    """After a change of the model they are written anew with the variable EZY_WRITE_STUB."""
    types = my_mechanism.type_stub()
    if os.environ.get("EZY_WRITE_STUB"):
        STUB.write_text(types, encoding="utf-8", newline="\n")
    assert STUB.read_text(encoding="utf-8") == types, "write the types anew: EZY_WRITE_STUB=1 python -m pytest"
