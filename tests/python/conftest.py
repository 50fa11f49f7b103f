"""What the tests of the Python package share."""

import importlib.util
from pathlib import Path

import numpy as np
import pytest

import armtol

SOURCE = Path(__file__).parents[2]

# Other people's kinematics: compared with where they are installed. `make test-python` installs Pinocchio.
collect_ignore = [
    f"test_{name}.py" for name in ("pinocchio", "roboticstoolbox") if importlib.util.find_spec(name) is None
]


@pytest.fixture
def source():
    return SOURCE


@pytest.fixture(params=["puma560", "stanford", "scara", "ur5e", "iiwa14", "intelledex605t", "adeptone", "panda"])
def arm(request):
    return armtol.Arm.builtin(request.param)


@pytest.fixture
def puma():
    return armtol.Arm.builtin("puma560")


@pytest.fixture
def random():
    return np.random.default_rng(17)
