"""armtol: tolerances of a manipulator's links and joints, after Hahn 1987, by the C library of the same name.

    >>> import armtol
    >>> arm = armtol.Arm.builtin("puma560")
    >>> answer = arm.allocate([0, 0.8, -1.6, 0, 0.8, 0], [0.5, 0.5, 0.5, 2e-4, 2e-4, 2e-4])
    >>> answer.tolerances.shape
    (28,)
    >>> answer.verify(1000).within
    1000

Lengths are in the arm's own unit, angles in radians, everywhere. docs/python.md tells more.
"""

from . import hahn1987
from ._core import COMPONENTS, ArmtolError, text as _text
from ._native import lib as _lib
from .answer import Answer, Budget, Component, Norm, Part, Share, Verification
from .arm import Arm, Link, Parameter, builtin_arms
from .maps import Map
from .reaching import Branches
from .regions import Enclosure, Region
from .tallies import Tally

__version__: str = _text(_lib.armtol_version())

__all__ = [
    "COMPONENTS",
    "Answer",
    "Arm",
    "ArmtolError",
    "Branches",
    "Budget",
    "Component",
    "Enclosure",
    "Link",
    "Map",
    "Norm",
    "Parameter",
    "Part",
    "Region",
    "Share",
    "Tally",
    "Verification",
    "builtin_arms",
    "hahn1987",
]
