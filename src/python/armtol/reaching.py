"""From where the tool should be to joint values: inverse kinematics of any arm, all branches."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from ._core import ArrayLike, Floats, copied, data_frame, floats, html_table, pointer, raise_status, vector
from ._native import ffi, lib

if TYPE_CHECKING:
    from .arm import Arm

_AXES_OFF = 1e-6


class Branches:
    """The ways to bring the tool to each of some wishes, (...): B, the most that any of them has, are kept for each.
    What a wish has fewer of is nan. Nearest to `near` first. Lengths in the arm's unit, angles in radians."""

    def __init__(self, arm: Arm, shape: tuple[int, ...], found: list[Any]) -> None:
        most = max((len(rows) for rows, _ in found), default=0)
        n = arm.n_joints
        table = np.full((len(found), most, n + 4), np.nan)
        for to, (rows, _) in zip(table, found):
            if rows:
                to[: len(rows)] = rows
        table = table.reshape(*shape, most, n + 4)
        best = np.array([row for _, row in found], dtype=np.float64).reshape(*shape, n + 4)
        self.arm = arm
        self.count: npt.NDArray[np.intp] = np.array([len(rows) for rows, _ in found], dtype=np.intp).reshape(shape)
        """How many branches were found, (...): 0 where the wish is out of reach."""
        self.q = table[..., :n].copy()
        """Joint values, (..., B, n_joints): radians, or lengths of prismatic joints."""
        self.from_near = table[..., n].copy()
        """The root of the sum of squares of what joints differ by from `near`, lengths as shares of the arm's size."""
        self.distance = table[..., n + 1].copy()
        """How far the tool point then is from the wish, (..., B)."""
        self.angle = table[..., n + 2].copy()
        """By which angle the tool is turned against it, (..., B); 0 where the axes are free."""
        self.own: npt.NDArray[np.bool_] = table[..., n + 3] == 1
        """Whether it is of the arm's own inverse kinematics, as the programs of 1987 have it, (..., B)."""
        self.best_q = best[..., :n].copy()
        """The nearest that the tool came, also where that is not near enough: joint values, (..., n_joints)."""
        self.best_distance = best[..., n + 1].copy()
        """How far the tool point then is from the wish, (...)."""

    def __repr__(self) -> str:
        return f"<armtol.Branches: {self.arm.name}, {self.count.sum()} branches of {self.count.size} wishes>"

    @property
    def _head(self) -> tuple[str, ...]:
        return ("wish", "branch", *(f"q{j + 1}" for j in range(self.arm.n_joints)), "distance", "angle", "own")

    @property
    def _rows(self) -> list[tuple[Any, ...]]:
        q = self.q.reshape(-1, *self.q.shape[-2:])
        flat = [x.reshape(len(q), q.shape[1]) for x in (self.distance, self.angle, self.own)]
        return [
            (i, b, *map(float, q[i, b]), float(flat[0][i, b]), float(flat[1][i, b]), bool(flat[2][i, b]))
            for i, count in enumerate(self.count.ravel())
            for b in range(count)
        ]

    def to_frame(self) -> Any:
        """A pandas data frame, a row a branch; wishes and branches are counted from 0."""
        return data_frame(self._rows, self._head)

    def _repr_html_(self) -> str:
        return html_table(f"{self.arm.title}: {self.count.sum()} branches", self._head, self._rows)


def rotations(what: str, axes: Floats) -> Floats:
    """Axes, (..., 3, 3), that have to be right-handed systems of unit vectors."""
    fine = np.abs(np.swapaxes(axes, -1, -2) @ axes - np.eye(3)).max(initial=0) <= _AXES_OFF
    if not fine or not (np.linalg.det(axes) > 0).all():
        raise ValueError(f"{what}: expected axes that are right-handed systems of unit vectors")
    return axes


def _wishes(wish: ArrayLike) -> tuple[tuple[int, ...], list[Any]]:
    """The shape of points, (..., 3), or of frames, (..., 4, 4), and a list of armtol_wish."""
    array = floats("wish", wish)
    if array.ndim > 0 and array.shape[-1] == 3:
        shape, point_only = array.shape[:-1], True
        frames = np.tile(np.eye(4), (math.prod(shape), 1, 1))
        frames[:, :3, 3] = array.reshape(-1, 3)
    elif array.shape[-2:] == (4, 4):
        shape, point_only = array.shape[:-2], False
        frames = array.reshape(-1, 4, 4)
        if np.isfinite(frames).all():
            rotations("wish", frames[:, :3, :3])
            if (frames[:, 3] != [0, 0, 0, 1]).any():
                raise ValueError("wish: expected a last row of 0, 0, 0, 1")
    else:
        raise ValueError(f"wish: shape {array.shape}, expected points, (..., 3), or frames, (..., 4, 4)")
    return shape, [ffi.new("armtol_wish *", {"tool": {"m": x.tolist()}, "point_only": point_only}) for x in frames]


def setup_of(
    arm: Arm, near: ArrayLike | None, tool_offset: ArrayLike | None, ignore_limits: bool, kept: list[Any]
) -> Any:
    """An armtol_inverse_setup; what it points to is kept."""
    setup = ffi.new("armtol_inverse_setup *", {"arm": arm._c, "ignore_limits": ignore_limits})
    setup.offset = vector("tool_offset", tool_offset).tolist()
    if near is not None:
        values = floats("near", near, (arm.n_joints,))
        kept.append(values)
        setup.near = pointer(values)
    return setup


def _row(branch: Any, n: int) -> list[float]:
    return [*copied(branch.q, n).tolist(), branch.from_near, branch.distance, branch.angle, float(branch.own)]


def find(arm: Arm, wish: ArrayLike, setup: Any) -> Branches:
    """Arm.inverse."""
    shape, wishes = _wishes(wish)
    made = ffi.new("armtol_inverse **")
    raise_status(lib.armtol_inverse_create(setup, made))
    inverse = ffi.gc(made[0], lib.armtol_inverse_destroy)
    branches = ffi.new("armtol_branches *")
    found: list[Any] = []
    for number, one in enumerate(wishes):
        status = lib.armtol_inverse_find(inverse, one, branches)
        if status != lib.ARMTOL_OUT_OF_REACH:
            raise_status(status, f"wish {number}")
        rows = [_row(branches.branch[i], arm.n_joints) for i in range(branches.count)]
        found.append((rows, _row(branches.best, arm.n_joints)))
    return Branches(arm, shape, found)
