"""What holds everywhere in a region: tolerances, and the largest error, enclosed."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ._core import COMPONENTS, ArmtolError, Floats, copied, data_frame, html_table, reading, status_text, text
from ._native import ffi, lib
from ._progress import Watch
from .answer import Answer, make_question

if TYPE_CHECKING:
    from .arm import Arm

_ENDED = {lib.ARMTOL_ENDED_GAP: "gap", lib.ARMTOL_ENDED_MOST: "most", lib.ARMTOL_ENDED_CALLER: "caller"}

_SHAPES = ("box", "cylinder", "path", "direction")

_WHY = {
    lib.ARMTOL_REGION_EMPTY: "no pose is in it: the tool is nowhere there within these ranges of the joints",
    lib.ARMTOL_REGION_NOT_FOUND: "no pose was found in it; `most` has the boxes to look for one",
    lib.ARMTOL_REGION_METHOD: "method sphere is for poses; expected worst or rss",
    lib.ARMTOL_REGION_RANGE: "joint {} has no range",
    lib.ARMTOL_REGION_GAP: "gap: expected 1e-6 to 10",
}


class Enclosure(NamedTuple):
    """From where to where the largest error of a region is: lengths in the arm's unit, or radians."""

    name: str
    """A component, or a norm."""
    low: float
    """An error that the arm has in the pose `q`, to first order."""
    high: float
    """What no pose of the region exceeds: proved, to first order."""
    accuracy: float
    """Infinite where none is asked for."""
    q: Floats
    """(n_joints,)."""
    ended: str
    """gap: as near as was asked for; most: after as many boxes as there may be; caller: `progress` said so."""


class Region:
    """The tolerances that hold everywhere in a region, or what given ones do there (armtol/region.h)."""

    def __init__(self, c_region: Any, arm: Arm) -> None:
        c_answer = c_region.answer
        self.q = copied(c_region.q, c_region.n_poses, c_answer.n_joints)
        """The poses that `answer` is of, (P, n_joints): the worst that were found, and some drawn from the region."""
        self.n_worst = int(c_region.n_worst)
        """How many of them, the first, are there for being the worst."""
        found = [c_region.enclosures[i] for i in range(c_region.n_enclosures)]
        self.enclosures = [
            Enclosure(_name(x.components), x.low, x.high, x.accuracy, self.q[x.pose], _ENDED[x.ended]) for x in found
        ]
        self.remainder = (float(c_region.remainder[0]), float(c_region.remainder[1]))
        """What the exact error can differ from the first order, anywhere in the region: of lengths, and of angles."""
        self.ended = _ENDED[c_region.ended]
        """The worst of all enclosures."""
        c_region.answer = ffi.NULL  # the Answer's from now on
        self.answer = Answer(c_answer, arm, int(c_region.n_poses))
        """Tolerances, budget, verification: of the poses `q`."""

    @property
    def tolerances(self) -> Floats:
        """How far each parameter may be off to either side, (n_parameters,)."""
        return self.answer.tolerances

    def __repr__(self) -> str:
        return f"<armtol.Region: {self.answer.arm.name}, {len(self.enclosures)} enclosures, ended by {self.ended}>"

    _head = ("error", "at least", "at most", "accuracy", "ended by")

    @property
    def _rows(self) -> list[tuple[Any, ...]]:
        return [(x.name, x.low, x.high, x.accuracy, x.ended) for x in self.enclosures]

    def to_frame(self) -> Any:
        """A pandas data frame, a row an enclosure."""
        return data_frame(self._rows, self._head)

    def _repr_html_(self) -> str:
        return html_table("the largest error in the region", self._head, self._rows) + self.answer._repr_html_()


def _name(components: int) -> str:
    """Of a component alone, or of a norm."""
    alone = components & (components - 1) == 0
    return COMPONENTS[components.bit_length() - 1] if alone else text(lib.armtol_norm_name(components))


def _why(why: int, number: int) -> str | None:
    if why == lib.ARMTOL_REGION_SHAPE:
        return f"the {_SHAPES[number]} is none"
    joint = why == lib.ARMTOL_REGION_RANGE
    return _WHY[why].format(number + 1 if joint else number) if why in _WHY else None


def ask_region(
    arm: Arm,
    where: str,
    *,
    gap: float,
    most: int,
    ignore_limits: bool,
    progress: Callable[[float, int], Any] | None,
    **options: Any,
) -> Region:
    """Arm.region."""
    if "\0" in where:
        raise ValueError("where: embedded null character")
    if not 0 <= most < 2**64:
        raise ValueError(f"most: {most}, expected a whole number of 0 to 2^64 - 1")
    question = make_question(arm, np.zeros(arm.n_joints), **options)
    words = reading(lambda: lib.binding_region_read(arm._c, where.encode(), ignore_limits))
    words = ffi.gc(words, lib.binding_region_free)
    watch = Watch(progress)
    how = ffi.new("armtol_enclosing *", {"gap": gap, "most": most})
    how.progress, how.context = lib.armtol_python_region_progress, watch.handle
    made, fault, why = ffi.new("armtol_region_answer **"), ffi.new("armtol_fault *"), ffi.new("armtol_region_fault *")
    status = lib.armtol_region_answer_create(question.c, lib.binding_region_of(words), how, made, fault, why)
    c_region = ffi.gc(made[0], lib.armtol_region_answer_destroy)
    watch.reraise()
    if status != lib.ARMTOL_OK:
        said = _why(why[0], fault.number)
        if said is not None:
            raise ArmtolError(f"region: {said}", status_text(status), "region")
        question.failed(fault)
    return Region(c_region, arm)
