"""Arms: built in, from rows, tables and URDF; where they are, and how errors of their parameters move the tool."""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Mapping, Sequence
from typing import Any, NamedTuple, Union

import numpy as np

from ._core import (
    ArrayLike,
    ArmtolError,
    Floats,
    Names,
    c_path,
    floats,
    html_table,
    no_overlap,
    output,
    pointer,
    poses,
    raise_status,
    reading,
    text,
    vector,
)
from ._native import ffi, lib
from .answer import Answer, ask
from .maps import Map, fill, reach
from .reaching import Branches, find, setup_of
from .regions import Region, ask_region

Accuracy = Union[str, "dict[str, float]", "Sequence[float | None]", ArrayLike]

FRAMES = {"base": lib.ARMTOL_BASE_FRAME, "tool": lib.ARMTOL_TOOL_FRAME}
_JOINTS = {"R": "theta", "P": "d", "F": "fixed"}


class Parameter(NamedTuple):
    """What a column of A stands for."""

    link: int
    """The link's number, from 0."""
    name: str
    """theta, d, a, alpha or beta."""
    role: str
    """motor, where the link's joint moves it, else machining."""
    unit: str
    """The arm's unit of length, or rad."""


class Link(NamedTuple):
    """A row of the arm's table, in Paul's order: T = Rot(z, theta) Trans(a, 0, d) Rot(x, alpha) Rot(y, beta)."""

    kind: str
    joint: str
    a: float
    alpha: float
    d: float
    theta: float
    beta: float


def tool_point(offset: ArrayLike | None, frame: str) -> Any:
    if frame not in FRAMES:
        raise ValueError(f"frame: {frame!r}, expected 'base' or 'tool'")
    tool = ffi.new("armtol_tool_point *")
    tool.offset = vector("tool_offset", offset).tolist()
    tool.frame = FRAMES[frame]
    return tool


def _cell(value: Any) -> str:
    if value is None:
        return "-"
    if isinstance(value, str):
        if "\n" in value or "\r" in value:
            raise ValueError(f"rows: {value!r} is more than a line")
        return '"' + value.replace('"', '""') + '"'
    return repr(float(value))


def _lists_of_rows(rows: Any, joints: str | None, columns: Sequence[str]) -> tuple[list[str], list[list[Any]]]:
    """The head of a table, and its cells."""
    if len(rows) > 0 and isinstance(rows[0], Mapping):
        head = list(dict.fromkeys(name for row in rows for name in row))
        return head, [[row.get(name) for name in head] for row in rows]
    numbers = floats("rows", rows)
    if numbers.ndim != 2 or numbers.shape[1] != len(columns):
        raise ValueError(f"rows: shape {numbers.shape}, expected (n, {len(columns)}): {', '.join(columns)}")
    letters = "R" * len(numbers) if joints is None else joints
    if len(letters) != len(numbers) or not set(letters) <= set(_JOINTS):
        raise ValueError(f"joints: {letters!r}, expected a letter for each of {len(numbers)} rows: R, P or F")
    cells = [[_JOINTS[letter], *row] for letter, row in zip(letters, numbers.tolist())]
    return ["joint", *columns], cells


class Arm:
    """An arm: a table of links, and what is known of its drives and masses. It does not change.

    Lengths are in `unit`, the arm's own; angles are in radians. Make one by `builtin`, `from_dh`, `from_table`,
    `from_urdf` or `from_text`. Arms can be pickled and copied.
    """

    def __init__(self, model: Any) -> None:
        """Of a model that the C library made."""
        self._model = ffi.gc(model, lib.binding_arm_free)
        self._c = ffi.addressof(model, "arm")
        self._links = [self._c.links[i] for i in range(self._c.n_links)]
        self._driven = [i for i in range(len(self._links)) if lib.armtol_arm_is_driven(self._c, i)]

    # ---- where arms come from ----

    @classmethod
    def builtin(cls, name: str) -> Arm:
        """A built-in arm, in millimetres; `armtol.builtin_arms()` lists them."""
        if not isinstance(name, str):
            raise TypeError(f"name: {name!r}, expected a text")
        if name not in builtin_arms():
            raise ArmtolError(f"{name!r} is no built-in arm; there are {', '.join(builtin_arms())}")
        return cls._read(name.encode())

    @classmethod
    def from_dh(
        cls,
        rows: Sequence[Mapping[str, Any]] | ArrayLike,
        convention: str = "paul",
        *,
        joints: str | None = None,
        columns: Sequence[str] | None = None,
        unit: str = "mm",
        angle: str = "rad",
        name: str = "arm",
    ) -> Arm:
        """An arm from Denavit-Hartenberg parameters.

        rows        one a link: dicts with the columns of an arm's table (docs/arm-files.md: joint, a, alpha, d, theta,
                    and kind, beta, low, high, backlash, mass ...), or an array of numbers, (n, 4)
        convention  "paul" (also "standard", "distal"), "craig" ("modified", "proximal"), or "hayati": Paul's with beta
        joints      with an array: a letter a row, R (revolute), P (prismatic) or F (fixed); all R where left out
        columns     with an array: what its columns are; ("a", "alpha", "d", "theta"), and "beta" behind them for
                    "hayati"
        unit        of lengths: "mm", "m" or "in"
        angle       "rad" or "deg"

        theta of a revolute joint, and d of a prismatic one, are those at joint value 0. The C library reads the rows as
        it reads a table: ArmtolError says which cell is wrong, the head of the table being line 4.
        """
        hayati = convention == "hayati"
        if columns is None:
            columns = ("a", "alpha", "d", "theta", "beta") if hayati else ("a", "alpha", "d", "theta")
        head, cells = _lists_of_rows(rows, joints, columns)
        lines = [f"order: {'paul' if hayati else convention}", f"units: {unit} {angle}", f"name: {_cell(name)}"]
        lines += [",".join(row) for row in [head, *([_cell(value) for value in row] for row in cells)]]
        return cls.from_text("\n".join(lines) + "\n", where="rows")

    @classmethod
    def from_table(cls, path: str | os.PathLike[str], *, as_is: bool = False) -> Arm:
        """The arm of a file with a table of links (docs/arm-files.md). as_is: frames far off it are not laid anew."""
        return cls._read(c_path(path), as_is=as_is)

    @classmethod
    def from_urdf(
        cls, path: str | os.PathLike[str], base: str | None = None, tip: str | None = None, *, snap: float = 1e-5
    ) -> Arm:
        """The chain of a URDF from link `base` to link `tip` (docs/urdf.md), in metres.

        What is left out has to be the only one that it can be. snap: what is nearly parallel or nearly meets is taken
        for exact within it, 0 to 0.01.
        """
        if not 0 <= snap <= 0.01:
            raise ValueError(f"snap: {snap}, expected 0 to 0.01")
        return cls._read(c_path(path), base=base, tip=tip, snap=snap)

    @classmethod
    def from_text(cls, table: str, *, where: str = "text", as_is: bool = False) -> Arm:
        """The arm of a table in a text; `where` stands in messages for the file's name."""
        if not isinstance(table, str):
            raise TypeError("table: expected a text")
        if "\0" in where:
            raise ValueError("where: embedded null character")
        return cls._read(where.encode(), content=table.encode(), as_is=as_is)

    @classmethod
    def _read(
        cls,
        path: bytes,
        content: bytes | None = None,
        base: str | None = None,
        tip: str | None = None,
        snap: float = 1e-5,
        as_is: bool = False,
    ) -> Arm:
        c_text = ffi.new("char[]", (content or b"\n") if content is not None else b"")
        c_base, c_tip = (ffi.NULL if word is None else ffi.new("char[]", word.encode()) for word in (base, tip))
        used = ffi.NULL if content is None else c_text
        length = 0 if content is None else max(len(content), 1)
        return cls(reading(lambda: lib.binding_arm_read(path, used, length, c_base, c_tip, snap, as_is)))

    def __reduce__(self) -> tuple[Any, ...]:
        return _from_pickled, (self.table(),)

    # ---- what it is ----

    @property
    def name(self) -> str:
        return text(self._c.name)

    @property
    def title(self) -> str:
        return text(self._c.title)

    @property
    def source(self) -> str:
        """Where the numbers are from."""
        return text(self._c.source)

    @property
    def unit(self) -> str:
        """The unit of all lengths: "mm", "m" or "in"."""
        return text(lib.armtol_length_unit_name(self._c.unit))

    @property
    def n_joints(self) -> int:
        """The joints that have a value in q: those that follow another have none."""
        return len(self._driven)

    @property
    def n_links(self) -> int:
        return len(self._links)

    @property
    def links(self) -> list[Link]:
        """The table, all joints at 0."""
        names = {lib.ARMTOL_FIXED: "fixed", lib.ARMTOL_REVOLUTE: "revolute", lib.ARMTOL_PRISMATIC: "prismatic"}
        return [
            Link(text(lib.armtol_kind_name(x.kind)), names[x.joint], x.a, x.alpha, x.d, x.theta, x.beta)
            for x in self._links
        ]

    @property
    def names(self) -> list[str | None]:
        """What the links, and their joints, are called; None for one without a name."""
        known = self._c.names
        return [text(known[i]) if known and known[i] else None for i in range(self.n_links)]

    @property
    def limits(self) -> Floats:
        """The least and the largest value of each joint, (n_joints, 2); infinite where not known.

        Nothing here compares joint values with them.
        """
        return np.array([[self._c.drives[i].low, self._c.drives[i].high] for i in self._driven]).reshape(-1, 2)

    @property
    def n_parameters(self) -> int:
        """The columns of A."""
        return int(lib.armtol_column_count(self._c.links, self._c.n_links))

    @property
    def parameters(self) -> list[Parameter]:
        """What the columns of A stand for, and so what tolerances are of."""
        n = self.n_parameters
        columns = ffi.new("armtol_column[]", n)
        raise_status(lib.armtol_columns(self._c.links, self._c.n_links, columns, n))
        return [self._parameter(columns[k]) for k in range(n)]

    def _parameter(self, column: Any) -> Parameter:
        role = lib.armtol_role_of(self._c.links + column.link, column.parameter)
        unit = self.unit if lib.armtol_parameter_is_length(column.parameter) else "rad"
        return Parameter(
            column.link, text(lib.armtol_parameter_name(column.parameter)), text(lib.armtol_role_name(role)), unit
        )

    def table(self, convention: str = "paul") -> str:
        """The arm's table as text, in radians, by convention "paul" or "craig"; `from_text` reads it."""
        if convention not in ("paul", "craig"):
            raise ValueError(f"convention: {convention!r}, expected 'paul' or 'craig'")
        chars = reading(lambda: lib.binding_arm_table(self._c, convention == "craig"))
        return text(ffi.gc(chars, lib.binding_text_free))

    def __repr__(self) -> str:
        return f"<armtol.Arm {self.name}: {self.n_links} links, {self.n_joints} joints, {self.unit}>"

    def _repr_html_(self) -> str:
        return html_table(
            f"{self.title}, {self.unit} and rad", ("link", *Link._fields), [(i, *x) for i, x in enumerate(self.links)]
        )

    # ---- what it does ----

    def forward(self, q: ArrayLike, *, tool_offset: ArrayLike | None = None, out: Floats | None = None) -> Floats:
        """Where the tool is: homogeneous transforms, (..., 4, 4), for joint values q, (..., n_joints).

        q            radians, or lengths for prismatic joints
        tool_offset  the tool point from the origin of the last frame, in its coordinates, (3,)
        out          where to write to: float64, C-contiguous, of the result's shape
        """
        values = poses(q, self.n_joints)
        frames = output(out, (*values.shape[:-1], 4, 4))
        tool = tool_point(tool_offset, "base")
        no_overlap(frames, values)
        failed = ffi.new("size_t *")
        count = math.prod(values.shape[:-1])
        status = lib.binding_forward(self._c, tool, pointer(values), count, pointer(frames), failed)
        raise_status(status, f"pose {failed[0]}")
        return frames

    def error_matrix(
        self,
        q: ArrayLike,
        *,
        frame: str = "base",
        tool_offset: ArrayLike | None = None,
        out: Floats | None = None,
    ) -> Floats:
        """A, by which small errors of the parameters move the tool: (..., 6, n_parameters) for q, (..., n_joints).

        Rows are dx, dy, dz of the tool point and wx, wy, wz, rotations, along the axes of the base or, with
        frame="tool", of the tool where it should be. Columns are `parameters`. Lengths in the arm's unit, angles in
        radians.

        q            radians, or lengths for prismatic joints
        tool_offset  the tool point from the origin of the last frame, in its coordinates, (3,)
        out          where to write to: float64, C-contiguous, of the result's shape

        What rounding leaves of a 0 stays as it is here; an Answer has it as 0.
        """
        values = poses(q, self.n_joints)
        matrices = output(out, (*values.shape[:-1], 6, self.n_parameters))
        tool = tool_point(tool_offset, frame)
        no_overlap(matrices, values)
        failed = ffi.new("size_t *")
        count = math.prod(values.shape[:-1])
        status = lib.binding_matrices(self._c, tool, pointer(values), count, pointer(matrices), failed)
        raise_status(status, f"pose {failed[0]}")
        return matrices

    def allocate(
        self,
        q: ArrayLike,
        accuracy: Accuracy,
        *,
        method: str = "worst",
        sigma: float = 3.0,
        delta: float | None = None,
        weights: Names = None,
        given: Names = None,
        least: ArrayLike | None = None,
        largest: ArrayLike | None = None,
        frame: str = "base",
        tool_offset: ArrayLike | None = None,
        drives: Names = None,
        payloads: Sequence[Any] = (),
        gravity: ArrayLike | None = None,
        force: ArrayLike | None = None,
        compensated: float = 0.0,
        drives_apart: bool = False,
    ) -> Answer:
        """The largest tolerances with which the tool keeps to an accuracy in the given poses; elsewhere is unknown.

        q            one pose, (n_joints,), or several that hold at once, (N, n_joints)
        accuracy     dx, dy, dz, wx, wy, wz: each > 0, None or infinity for a component that is free; or names, of
                     components and of norms: {"xy": 0.02, "dz": 0.1, "w": 1e-3}; a ball is "r", any rotation "w"
        method       "worst": the largest that guarantee it; "rss": the largest with which `sigma` standard deviations
                     keep to it; "sphere": the report's, with `delta` (None: to be chosen)
        weights      what precision costs: a value a parameter, or names: {"motors": 3, "3.alpha": 10}
        given        tolerances that are known, or in a range: names, {"motors": 0.02, "lengths": "0.02..0.2"}, or a
                     text "motors=0.02,angles>=0.01"
        least, largest  the same as arrays of a value a parameter; where both are the same it is given, and 0 is exact
        frame        "base" or "tool": the axes along which errors count
        tool_offset  the tool point from the origin of the last frame, in its coordinates, (3,)
        drives       what is known of drives: {"backlash": 1e-4, "2.compliance": 1e-5}
        payloads     load cases: a mass in kg, or (kg, x, y, z) with its center from the tool point in the last frame
        gravity      m/s^2 along the base's axes; (0, 0, -9.80665) where left out
        force        N at the tool point, along the base's axes
        compensated  the share of what compliance gives way by that a controller takes back, 0 to 1
        drives_apart drives and loads are in no error, and the motors' tolerances are asked for

        Names are those of `armtol --weights` and `--given` (docs/armtol.md), in the arm's unit and radians. ArmtolError
        where there are no such tolerances.
        """
        return ask(
            self,
            q,
            accuracy=accuracy,
            method=method,
            sigma=sigma,
            delta=delta,
            weights=weights,
            given=given,
            least=least,
            largest=largest,
            tool=tool_point(tool_offset, frame),
            drives=drives,
            payloads=payloads,
            gravity=gravity,
            force=force,
            compensated=compensated,
            drives_apart=drives_apart,
        )

    def predict(
        self,
        q: ArrayLike,
        tolerances: Names,
        *,
        accuracy: Accuracy | None = None,
        method: str = "worst",
        sigma: float = 3.0,
        frame: str = "base",
        tool_offset: ArrayLike | None = None,
        drives: Names = None,
        payloads: Sequence[Any] = (),
        gravity: ArrayLike | None = None,
        force: ArrayLike | None = None,
        compensated: float = 0.0,
        drives_apart: bool = False,
    ) -> Answer:
        """What given tolerances do to the tool: the other way round than `allocate`, whose arguments it has.

        tolerances  a value a parameter, each >= 0, infinity for what has no bound, or names, {"motors": 1e-4,
                    "lengths": 0.02}: what is not named is exact
        accuracy    what the errors are held against by `Answer.verify`
        """
        return ask(
            self,
            q,
            accuracy=accuracy,
            method=method,
            sigma=sigma,
            tolerances=tolerances,
            tool=tool_point(tool_offset, frame),
            drives=drives,
            payloads=payloads,
            gravity=gravity,
            force=force,
            compensated=compensated,
            drives_apart=drives_apart,
        )

    def region(
        self,
        where: str,
        accuracy: Accuracy | None = None,
        *,
        tolerances: Names = None,
        method: str = "worst",
        sigma: float = 3.0,
        weights: Names = None,
        given: Names = None,
        least: ArrayLike | None = None,
        largest: ArrayLike | None = None,
        frame: str = "base",
        tool_offset: ArrayLike | None = None,
        drives: Names = None,
        payloads: Sequence[Any] = (),
        gravity: ArrayLike | None = None,
        force: ArrayLike | None = None,
        compensated: float = 0.0,
        drives_apart: bool = False,
        gap: float = 0.01,
        most: int = 0,
        ignore_limits: bool = False,
        progress: Callable[[float, int], Any] | None = None,
    ) -> Region:
        """The largest tolerances that keep to an accuracy everywhere in a region: proved, to first order.

        where          as `armtol --region` has it (docs/region.md), in the arm's unit and radians: words, as
                       "q1=-1.5..1.5;box=300..600,-100..100,0..200", or a file of them. Joints that are not named have
                       their limits
        tolerances     given ones, as for `predict`: then the largest error is told, with or without an accuracy
        gap            how near the bounds of the largest error are to be, a share of it, 1e-6 to 10
        most           boxes to look at; 0: a million
        ignore_limits  joints may be beyond their limits
        progress       called now and then with the share of the largest error that is still open, and the boxes; False
                       ends the work: the bounds are then those reached

        The other arguments are those of `allocate`. ArmtolError where no pose is in the region. Ctrl-C raises
        KeyboardInterrupt.
        """
        return ask_region(
            self,
            where,
            gap=gap,
            most=most,
            ignore_limits=ignore_limits,
            progress=progress,
            accuracy=accuracy,
            tolerances=tolerances,
            method=method,
            sigma=sigma,
            weights=weights,
            given=given,
            least=least,
            largest=largest,
            tool=tool_point(tool_offset, frame),
            drives=drives,
            payloads=payloads,
            gravity=gravity,
            force=force,
            compensated=compensated,
            drives_apart=drives_apart,
        )

    def inverse(
        self,
        wish: ArrayLike,
        *,
        near: ArrayLike | None = None,
        tool_offset: ArrayLike | None = None,
        ignore_limits: bool = False,
        enough: int = 0,
        within: float = 0.0,
    ) -> Branches:
        """Joint values that bring the tool where it should be: all branches that are found, of each wish.

        wish           points, (..., 3), the tool's axes being free; or frames, (..., 4, 4), as `forward` gives them
        near           joint values, (n_joints,), that branches come in order of their distance from; None: the middle
                       of each joint's range, and first the arm's own inverse kinematics, where it is one of 1987
        tool_offset    the tool point from the origin of the last frame, in its coordinates, (3,)
        ignore_limits  joints may be beyond their limits
        enough         so many branches are: fewer starts are made; 0: all are wanted
        within         how near counts as there, radians and shares of the arm's size; 0: 1e-10

        A wish that is out of reach has no branch, and raises nothing: that none was found is no proof
        (docs/inverse.md).
        """
        if enough < 0:
            raise ValueError(f"enough: {enough}, expected 0 or more")
        if not 0 <= within < math.inf:
            raise ValueError(f"within: {within}, expected 0 or more")
        kept: list[Any] = []
        setup = setup_of(self, near, tool_offset, ignore_limits, kept)
        setup.enough, setup.within = enough, within
        return find(self, wish, setup)

    def map(
        self,
        plane: str,
        across: ArrayLike,
        up: ArrayLike,
        *,
        what: str = "worst",
        of: str | None = None,
        offset: float = 0.0,
        grid: Sequence[int] = (61, 61),
        axes: ArrayLike | None = None,
        near: ArrayLike | None = None,
        ignore_limits: bool = False,
        tolerances: Names = None,
        accuracy: Accuracy | None = None,
        method: str = "worst",
        sigma: float = 3.0,
        weights: Names = None,
        given: Names = None,
        least: ArrayLike | None = None,
        largest: ArrayLike | None = None,
        frame: str = "base",
        tool_offset: ArrayLike | None = None,
        drives: Names = None,
        payloads: Sequence[Any] = (),
        gravity: ArrayLike | None = None,
        force: ArrayLike | None = None,
        compensated: float = 0.0,
        drives_apart: bool = False,
        progress: Callable[[int, int], Any] | None = None,
    ) -> Map:
        """One number for each point of a plane, the arm reaching for each: `values`, (U, A), and `plot()`.

        plane       "xy", "xz" or "yz": across, and up
        across, up  from where to where, in the arm's unit: (2,) each
        what        "worst": the largest error that `tolerances` and drives allow, to first order; "droop": how far
                    loads take the tool; "repeatability": what is left open at each arrival; "tolerance": the least of
                    the largest tolerances that keep to `accuracy` in this point alone
        of          "position" (where left out), "rotation", or a component as "dx"; with "tolerance" names of
                    parameters as "lengths" (where left out), "angles", "2.theta"
        offset      where the plane is along the third axis
        grid        (A, U): points across and up
        axes        the tool's, (3, 3), at all points, as forward(q)[:3, :3]; None: free
        near        the posture to begin with, (n_joints,); points are followed from their neighbours
        progress    called now and then with the points reached for and all; False ends it: the others are not reached

        The other arguments are those of `allocate`, `predict` and `inverse`. Points that are not reached are nan.
        Ctrl-C raises KeyboardInterrupt.
        """
        tool = tool_point(tool_offset, frame)
        reached = reach(
            self,
            plane,
            across,
            up,
            offset=offset,
            grid=grid,
            axes=axes,
            near=near,
            tool_offset=tool_offset,
            ignore_limits=ignore_limits,
            progress=progress,
        )
        return fill(
            reached,
            what,
            of,
            tolerances=tolerances,
            accuracy=accuracy,
            method=method,
            sigma=sigma,
            weights=weights,
            given=given,
            least=least,
            largest=largest,
            tool=tool,
            drives=drives,
            payloads=payloads,
            gravity=gravity,
            force=force,
            compensated=compensated,
            drives_apart=drives_apart,
        )

    def sag(
        self,
        q: ArrayLike,
        *,
        payloads: Sequence[Any] = (),
        gravity: ArrayLike | None = None,
        force: ArrayLike | None = None,
        compensated: float = 0.0,
        drives: Names = None,
        frame: str = "base",
        tool_offset: ArrayLike | None = None,
    ) -> Floats:
        """Where loads take the tool by the exact kinematics: (..., loads, 6) for q, (..., n_joints).

        Arguments are those of `allocate`; there is one load where no payload is given.
        """
        values = poses(q, self.n_joints)
        flat = values.reshape(math.prod(values.shape[:-1]), self.n_joints)
        answer = ask(
            self,
            flat,
            tolerances=np.zeros(self.n_parameters),
            tool=tool_point(tool_offset, frame),
            drives=drives,
            payloads=payloads,
            gravity=gravity,
            force=force,
            compensated=compensated,
        )
        return answer.sag.reshape(*values.shape[:-1], -1, 6)


def _from_pickled(table: str) -> Arm:
    return Arm.from_text(table, as_is=True)


def builtin_arms() -> list[str]:
    """The names that `Arm.builtin` takes."""
    return [text(lib.armtol_arm_at(i).name) for i in range(lib.armtol_arm_count())]
