"""One number for each point of a plane: errors, droops, tolerances over the workspace."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from ._core import (
    COMPONENTS,
    ArmtolError,
    ArrayLike,
    Floats,
    about_fault,
    axes_or_new,
    data_frame,
    floats,
    names_text,
    pointer,
    raise_status,
    reading,
    text,
)
from ._native import ffi, lib
from ._progress import Watch
from .answer import Question, make_question
from .reaching import rotations, setup_of

if TYPE_CHECKING:
    from .arm import Arm

WHAT = {text(lib.armtol_map_value_name(i)): i for i in range(lib.ARMTOL_MAP_VALUE_COUNT)}
OF = {name: i for i, name in enumerate((*COMPONENTS, "position", "rotation"))}
_PLANES = {"xy": (0, 1, 2), "xz": (0, 2, 1), "yz": (1, 2, 0)}
_AT_ONCE = 1024  # points, between two looks for Ctrl-C

Bools = npt.NDArray[np.bool_]


class Map:
    """A number for each point of a plane (armtol/map.h). Arrays are (U, A): U points up, A across; lengths in the arm's
    unit, angles in radians."""

    def __init__(self, arm: Arm, plane: str, points: Floats, q: Floats, marks: npt.NDArray[np.uint8]) -> None:
        right, up, _ = _PLANES[plane]
        self.arm = arm
        self.plane = plane
        """xy, xz or yz: across, and up."""
        self.points = points
        """Where the tool point is, (U, A, 3)."""
        self.across = points[0, :, right].copy()
        """(A,)."""
        self.up = points[:, 0, up].copy()
        """(U,)."""
        self.q = q
        """Joint values, (U, A, n_joints): nan where the point was not reached."""
        self.reached: Bools = (marks & lib.ARMTOL_MAP_REACHED) != 0
        """Whether joint values were found, (U, A). That there are none elsewhere is not proved."""
        self.joined_across: Bools = (marks & lib.ARMTOL_MAP_JOINS_NEXT) != 0
        """Whether the arm moves on to the next point across without a jump to another branch, (U, A)."""
        self.joined_up: Bools = (marks & lib.ARMTOL_MAP_JOINS_ABOVE) != 0
        """Likewise to the point above, (U, A)."""
        self.what, self.of, self.unit = "", "", ""
        self.values = np.full(marks.shape, np.nan)
        """(U, A), nan where the point was not reached; infinite where nothing bounds it."""

    def __repr__(self) -> str:
        points = f"{self.reached.sum()} of {self.values.size} points"
        return f"<armtol.Map: {self.what} of {self.of}, {self.arm.name}, {points}>"

    @property
    def title(self) -> str:
        return f"{self.what} of {self.of}, {self.unit}"

    def to_frame(self) -> Any:
        """A pandas data frame, a row a point: x, y, z, the value, and joint values q1, q2 ..."""
        table = np.concatenate([self.points, self.values[..., np.newaxis], self.q], axis=-1)
        names = ["x", "y", "z", self.what, *(f"q{j + 1}" for j in range(self.arm.n_joints))]
        return data_frame(table.reshape(-1, table.shape[-1]).tolist(), names)

    def plot(self, ax: Any = None) -> Any:
        """The values as colours over the plane, with a bar that says which; matplotlib's axes."""
        ax = axes_or_new(ax)
        shown = np.ma.masked_invalid(self.values)
        colours = ax.pcolormesh(self.across, self.up, shown, shading="nearest")
        ax.figure.colorbar(colours, ax=ax, label=self.title)
        ax.set_aspect("equal")
        ax.set_xlabel(f"{self.plane[0]}, {self.arm.unit}")
        ax.set_ylabel(f"{self.plane[1]}, {self.arm.unit}")
        ax.set_title(self.arm.title)
        return ax


# ---- the points ----


def _places(what: str, ends: ArrayLike, count: int) -> Floats:
    """As the program has them: both ends, and shares of what is between."""
    first, last = floats(what, ends, (2,)).tolist()
    if not (np.isfinite(last - first) and first < last):
        raise ValueError(f"{what}: {first} to {last}, expected two finite ends, the least first")
    places: Floats = first + np.arange(count) / (count - 1) * (last - first)
    places[-1] = last
    return places


def _points(plane: str, across: ArrayLike, up: ArrayLike, offset: float, grid: Sequence[int]) -> Floats:
    if plane not in _PLANES:
        raise ValueError(f"plane: {plane!r}, expected one of {', '.join(_PLANES)}")
    n_across, n_up = grid
    if n_across < 2 or n_up < 2:
        raise ValueError(f"grid: {n_across}, {n_up}, expected 2 points or more to each side")
    right, above, third = _PLANES[plane]
    points = np.empty((n_up, n_across, 3))
    points[..., right] = _places("across", across, n_across)
    points[..., above] = _places("up", up, n_up)[:, np.newaxis]
    points[..., third] = float(floats("offset", offset, ()))
    return points


def _c_plane(plane: str, points: Floats, axes: ArrayLike | None) -> Any:
    right, above, _ = _PLANES[plane]
    n_up, n_across = points.shape[:2]
    c_plane = ffi.new("armtol_map_plane *", {"n_across": n_across, "n_up": n_up, "point_only": axes is None})
    c_plane.first = points[0, 0].tolist()
    c_plane.across[right] = (points[0, -1, right] - points[0, 0, right]) / (n_across - 1)
    c_plane.up[above] = (points[-1, 0, above] - points[0, 0, above]) / (n_up - 1)
    frame = np.eye(4)
    if axes is not None:
        frame[:3, :3] = rotations("axes", floats("axes", axes, (3, 3)))
    c_plane.axes.m = frame.tolist()
    return c_plane


def reach(
    arm: Arm,
    plane: str,
    across: ArrayLike,
    up: ArrayLike,
    *,
    offset: float,
    grid: Sequence[int],
    axes: ArrayLike | None,
    near: ArrayLike | None,
    tool_offset: ArrayLike | None,
    ignore_limits: bool,
    progress: Callable[[int, int], Any] | None,
) -> Map:
    """A map without values."""
    kept: list[Any] = []
    points = _points(plane, across, up, offset, grid)
    setup = setup_of(arm, near, tool_offset, ignore_limits, kept)
    q = np.empty((*points.shape[:2], arm.n_joints))
    marks = np.zeros(points.shape[:2], dtype=np.uint8)
    watch = Watch(progress)
    status = lib.armtol_map_poses(
        setup,
        _c_plane(plane, points, axes),
        lib.armtol_python_map_progress,
        watch.handle,
        pointer(q),
        ffi.cast("unsigned char *", ffi.from_buffer(marks)),
    )
    watch.reraise()
    raise_status(status, "map")
    q[(marks & lib.ARMTOL_MAP_REACHED) == 0] = np.nan
    return Map(arm, plane, points, q, marks)


# ---- the values ----


def _columns(arm: Arm, of: str) -> Bools:
    """Those of A that a name stands for, or several."""
    values = np.empty(arm.n_parameters)
    names = names_text("of", {name.strip(): 2.0 for name in of.split(",")})
    try:
        reading(lambda: lib.binding_weights(arm._c, names, pointer(values)))
    except ArmtolError as said:
        raise ArmtolError(str(said).replace("weights:", "of:", 1).replace("=2.0", "")) from None
    chosen: Bools = values == 2
    return chosen


def _c_map(arm: Arm, what: str, of: str | None, kept: list[Any]) -> tuple[Any, str, str]:
    """An armtol_map, what it is of, and its unit."""
    if what not in WHAT:
        raise ValueError(f"what: {what!r}, expected one of {', '.join(WHAT)}")
    c_map = ffi.new("armtol_map *", {"value": WHAT[what]})
    if WHAT[what] != lib.ARMTOL_MAP_TOLERANCE:
        of = of or "position"
        if of not in OF:
            raise ValueError(f"of: {of!r}, expected one of {', '.join(OF)}")
        c_map.component = OF[of]
        return c_map, of, arm.unit if OF[of] < 3 or of == "position" else "rad"
    of = of or "lengths"
    columns = _columns(arm, of)
    units = {x.unit for x, meant in zip(arm.parameters, columns) if meant}
    if len(units) != 1:
        raise ValueError(f"of: {of!r} has lengths and angles, and of those there is no least; expected one of them")
    chosen = ffi.new("bool[]", columns.tolist())
    kept.append(chosen)
    c_map.columns = chosen
    return c_map, of, units.pop()


def _find(question: Question, c_map: Any, values: Floats) -> None:
    n_joints = question.arm.n_joints
    fault = ffi.new("armtol_fault *")
    q, to = pointer(question.q), pointer(values)
    for first in range(0, values.size, _AT_ONCE):
        question.c.q = q + first * n_joints
        question.c.n_poses = min(_AT_ONCE, values.size - first)
        if lib.armtol_map_values(question.c, c_map, to + first, fault) != lib.ARMTOL_OK:
            raise_status(fault.status, about_fault(fault))


def fill(map_: Map, what: str, of: str | None, **options: Any) -> Map:
    """A map with its values."""
    arm, kept = map_.arm, list[Any]()
    c_map, map_.of, map_.unit = _c_map(arm, what, of, kept)
    map_.what = what
    known = {key: options.get(key) is not None for key in ("tolerances", "accuracy")}
    if what == "worst" and not known["tolerances"]:
        raise ValueError("tolerances: expected with what='worst', those of an answer, say")
    if what == "tolerance" and (known["tolerances"] or not known["accuracy"]):
        raise ValueError("accuracy: expected with what='tolerance', and no tolerances")
    question = make_question(arm, map_.q.reshape(-1, arm.n_joints), **options)
    _find(question, c_map, map_.values)
    return map_
