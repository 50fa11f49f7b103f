"""A question to the engine and its answer: tolerances, where the error comes from, and arms drawn at random."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from ._core import (
    COMPONENTS,
    ArmtolError,
    ArrayLike,
    Floats,
    Names,
    about_fault,
    axes_or_new,
    copied,
    data_frame,
    floats,
    html_table,
    names_text,
    pointer,
    poses,
    raise_status,
    reading,
    status_text,
    text,
    vector,
)
from ._native import ffi, lib
from ._progress import Watch, drawing
from .tallies import Tally, draw_tally

if TYPE_CHECKING:
    from .arm import Arm, Parameter

METHODS = {text(lib.armtol_method_name(i)): i for i in range(lib.ARMTOL_METHOD_COUNT)}


class Part(NamedTuple):
    """What whoever makes a link, and its joint, has to keep to; nan where there is nothing to keep to."""

    link: int
    distance: float
    """Of the axes of the link, Eq. (4.32), in the arm's unit."""
    angle: float
    """The smallest of the link's angles that no motor moves, radians."""
    motor: float
    """The joint's, radians, or a length for a prismatic joint."""
    drive: float
    """How far the drive of the joint is off, Eq. (4.20), likewise."""


class Component(NamedTuple):
    """One component of the tool's error, the largest of all poses and loads. Infinite where nothing bounds it."""

    name: str
    accuracy: float
    worst: float
    """To first order, |A s| + |A| t."""
    shift: float
    """|A s|, what loads do."""
    deviation: float
    """The standard deviation about it, every error being even within its tolerance."""
    remainder: float
    """What the exact error can differ from A's by: a bound, rounding included."""
    binds: float
    """The share of the optimum that this component's limit holds down."""


class Norm(NamedTuple):
    """The length of the tool's error in some components, the largest of all poses and loads (armtol/norm.h)."""

    name: str
    """r, xy, xz or yz of lengths; w, wxy, wxz or wyz of rotations."""
    limit: float
    worst: float
    """To first order, in the direction that is worst."""
    shift: float
    deviation: float
    """The largest standard deviation of any direction."""
    remainder: float
    binds: float
    """The share of the optimum that the limit holds down."""


class Share(NamedTuple):
    """What one link's making, its motor or its load has to do with each component's error."""

    link: int
    role: str
    dx: float
    dy: float
    dz: float
    wx: float
    wy: float
    wz: float


class Budget:
    """Where the error comes from: shares of each component's predicted error, which add up to 1 each."""

    def __init__(self, c_budget: Any, norms: Sequence[Norm]) -> None:
        rows = [c_budget.rows[i] for i in range(c_budget.n_rows)]
        self.rows = [Share(row.link, text(lib.armtol_role_name(row.role)), *row.shares) for row in rows]
        """A row for each link and role (machining, motor, load)."""
        self.motors = np.array(list(c_budget.motors))
        """The share of all motors in each component, (6,)."""
        self.loads = np.array(list(c_budget.loads))
        """The share of all loads in each component, (6,)."""
        shares = [list(row.norm_shares)[: len(norms)] for row in rows]
        self.norm_shares = np.array(shares, dtype=np.float64).reshape(len(rows), len(norms))
        """Likewise of the answer's norms, along the direction that each is largest in: (rows, norms)."""

    @property
    def shares(self) -> Floats:
        """(rows, 6)."""
        return np.array([row[2:] for row in self.rows], dtype=np.float64).reshape(-1, 6)

    def to_frame(self) -> Any:
        """A pandas data frame, a row for each of `rows`."""
        return data_frame(self.rows, Share._fields)

    def _repr_html_(self) -> str:
        return html_table("shares of each component's error", Share._fields, self.rows)

    def plot(self, ax: Any = None) -> Any:
        """Bars of shares, one a component; returns matplotlib's axes."""
        ax = axes_or_new(ax)
        bottom = np.zeros(6)
        for row, shares in zip(self.rows, self.shares):
            ax.bar(COMPONENTS, shares, bottom=bottom, label=f"link {row.link}, {row.role}")
            bottom = bottom + shares
        ax.set_ylabel("share of the error")
        ax.legend(fontsize="x-small", ncols=2)
        return ax


class Verification:
    """Arms drawn within the tolerances, by the exact kinematics (armtol/verification.h)."""

    def __init__(self, found: Any, answer: Answer, seed: int) -> None:
        self.seed = seed
        self.drawn = int(found.drawn)
        """Arms drawn: fewer than asked for where `progress` ended it early."""
        self.within = int(found.within)
        """Arms that keep to the accuracy in every pose; all, where none is asked for."""
        self.beyond = int(found.beyond)
        """Arms with a component that exceeds its accuracy by more than its remainder."""
        self.share_95 = (float(found.share_low), float(found.share_high))
        """A 95 % interval of the share within."""
        self.probabilities = np.array(list(found.probabilities))
        """Those of `quantiles`, (4,)."""
        self.names = COMPONENTS + tuple(norm.name for norm in answer.norms)
        """dx, dy, dz, wx, wy, wz, and then the answer's norms: what the arrays have a row for."""
        components = [found.components[i] for i in range(6)] + [found.norms[i] for i in range(len(answer.norms))]
        self.quantiles = np.array([list(x.quantiles) for x in components])
        """What that share of arms does not exceed, (names, 4): rounded up by 0.1 % of itself at the most."""
        self.worst_drawn = np.array([x.worst_drawn for x in components])
        self.worst_arm = np.array([x.worst_arm for x in components], dtype=np.uint64)
        self.worst_corner = np.array([x.worst_corner for x in components])
        """The exact error at the worst corner found, (names,)."""
        self.accuracy = np.concatenate([answer.accuracy, [norm.limit for norm in answer.norms]])

    @property
    def _head(self) -> tuple[str, ...]:
        return ("component", *(f"{100 * p:g} %" for p in self.probabilities), "worst drawn", "worst corner")

    @property
    def _rows(self) -> list[tuple[Any, ...]]:
        return [
            (name, *map(float, self.quantiles[i]), float(self.worst_drawn[i]), float(self.worst_corner[i]))
            for i, name in enumerate(self.names)
        ]

    def __repr__(self) -> str:
        return f"<armtol.Verification: {self.within} of {self.drawn} arms are within the accuracy>"

    def to_frame(self) -> Any:
        """A pandas data frame, a row a component."""
        return data_frame(self._rows, self._head)

    def _repr_html_(self) -> str:
        caption = f"{self.within} of {self.drawn} arms are within the accuracy (seed {self.seed})"
        return html_table(caption, self._head, self._rows)

    def plot(self, ax: Any = None) -> Any:
        """Quantiles of components over their accuracy or, where there is none, worst corner; matplotlib's axes."""
        ax = axes_or_new(ax)
        scale = np.where(np.isfinite(self.accuracy), self.accuracy, self.worst_corner)
        with np.errstate(divide="ignore", invalid="ignore"):
            for k, probability in enumerate(self.probabilities):
                ax.plot(self.names, self.quantiles[:, k] / scale, "o", label=f"{100 * probability:g} % of arms")
            ax.plot(self.names, self.worst_corner / scale, "_", markersize=20, label="worst corner")
        ax.axhline(1, color="grey", linewidth=0.8)
        ax.set_ylabel("error / accuracy")
        ax.set_ylim(bottom=0)
        ax.legend(fontsize="small")
        return ax


class Answer:
    """Tolerances, and what they do to the tool. Lengths in the arm's unit, angles in radians. Made by Arm.allocate and
    Arm.predict. P poses, L loads (1 or more), n parameters."""

    def __init__(self, c_answer: Any, arm: Arm, n_poses: int) -> None:
        self._c = ffi.gc(c_answer, lib.armtol_answer_destroy)
        self.arm = arm
        loads, n = self._c.n_loads, self._c.n_columns
        self.method = text(lib.armtol_method_name(self._c.method))
        self.accuracy = np.array(list(self._c.accuracy))
        """What was asked for, (6,); infinite for a free component."""
        self.tolerances = copied(self._c.tolerances, n)
        """How far each parameter may be off to either side, (n,); infinite where no bounded component sees it."""
        self.matrix = copied(self._c.matrices, n_poses, loads, 6, n)[:, 0].copy()
        """A of every pose, (P, 6, n), what rounding left of a 0 being 0."""
        self.shifts = copied(self._c.shifts, n_poses, loads, n)
        """What drives under loads shift the parameters by, (P, L, n): 0 but for motors."""
        self.moments = copied(self._c.moments, n_poses, loads, self._c.n_links)
        """Of the joints, (P, L, links): N m, or N along prismatic ones."""
        self.sag = copied(self._c.droops, n_poses, loads, 6)
        """Where loads take the tool by the exact kinematics, (P, L, 6)."""
        self.remainders = copied(self._c.remainders, n_poses, loads, 6)
        """What the exact error can differ from A's by, (P, L, 6)."""
        self.given = np.array([self._c.given[k] for k in range(n)], dtype=bool)
        """Whether a drive or the question gave the tolerance, (n,)."""
        self.held = copied(self._c.held, n)
        """The share of the optimum that each tolerance's largest, or (negative) least, holds, (n,)."""
        sphere = self.method == "sphere" and not math.isnan(self._c.delta)
        self.bounds = (self._c.bounds.distance, self._c.bounds.angle) if sphere else None
        """With method "sphere": the radii of all lengths and of all angles, Eqs (4.25) to (4.31)."""
        self.delta = float(self._c.delta) if sphere else None

    @property
    def parameters(self) -> list[Parameter]:
        """What `tolerances` and the columns of `matrix` are of."""
        return self.arm.parameters

    @property
    def parts(self) -> list[Part]:
        """What whoever makes a link, and its joint, has to keep to; one a link."""
        parts = [self._c.parts[i] for i in range(self._c.n_links)]
        return [Part(i, x.distance, x.angle, x.motor, x.drive) for i, x in enumerate(parts)]

    @property
    def components(self) -> list[Component]:
        """The predicted error of the tool: dx, dy, dz, wx, wy, wz."""
        found = [self._c.components[i] for i in range(6)]
        return [
            Component(name, float(self.accuracy[i]), x.worst, x.shift, x.deviation, x.remainder, x.binds)
            for i, (name, x) in enumerate(zip(COMPONENTS, found))
        ]

    @property
    def norms(self) -> list[Norm]:
        """The norms that the accuracy names, as `components`."""
        found = [self._c.norms[i] for i in range(self._c.n_norms)]
        names = [text(lib.armtol_norm_name(x.components)) for x in found]
        return [
            Norm(name, x.limit, x.of.worst, x.of.shift, x.of.deviation, x.of.remainder, x.of.binds)
            for name, x in zip(names, found)
        ]

    @property
    def worst(self) -> Floats:
        """The worst case of each component, (6,)."""
        return np.array([self._c.components[i].worst for i in range(6)])

    @property
    def budget(self) -> Budget:
        """Where the error comes from."""
        made = ffi.new("armtol_budget **")
        raise_status(lib.armtol_budget_create(self._c, made))
        c_budget = ffi.gc(made[0], lib.armtol_budget_destroy)
        return Budget(c_budget, self.norms)

    def verify(
        self,
        n: int = 100_000,
        seed: int = 1987,
        threads: int | None = None,
        progress: Callable[[int, int], Any] | None = None,
    ) -> Verification:
        """Draws n arms, every parameter evenly within its tolerance, and computes where their tools are, exactly.

        threads   at most; None: as many as this process may use. The result does not depend on it
        progress  called now and then with the arms done and n, on the calling thread; what is False, and not None, ends
                  the work: the arms drawn until then count. What it raises is raised

        Ctrl-C raises KeyboardInterrupt. The interpreter's lock is released while the library works. ArmtolError where a
        component with an accuracy depends on a parameter without a bound.
        """
        watch = Watch(progress)
        found, fault = ffi.new("armtol_verification *"), ffi.new("armtol_fault *")
        draw = drawing(n, seed, threads, watch)
        status = lib.armtol_verify(self._c, draw, found, fault)
        watch.reraise()
        if found.drawn < n and status == lib.ARMTOL_OK and not watch.ended:
            raise KeyboardInterrupt  # a second one, while the first was kept
        raise_status(status, about_fault(fault))
        return Verification(found, self, seed)

    def tally(
        self,
        first: int,
        count: int,
        seed: int = 1987,
        threads: int | None = None,
        progress: Callable[[int, int], Any] | None = None,
    ) -> Tally:
        """Draws arms `first` to `first + count - 1` of those that `verify` draws with this seed, and counts them.

        Any process on any machine may draw a part: tallies can be pickled and added, and the sum's `verify` is that of
        all arms at once, to the bit. The other arguments, and what is raised, are those of `verify`.
        """
        return draw_tally(self, first, count, seed, threads, progress)

    # ---- how it is shown ----

    @property
    def _rows(self) -> list[tuple[Any, ...]]:
        set_by = np.where(
            self.given, "given", np.where(self.held > 0, "largest", np.where(self.held < 0, "least", "accuracy"))
        )
        return [(*x, float(self.tolerances[k]), str(set_by[k])) for k, x in enumerate(self.parameters)]

    _head = ("link", "parameter", "role", "unit", "tolerance", "set by")

    def __repr__(self) -> str:
        counts = f"{len(self.matrix)} poses, {len(self.tolerances)} tolerances"
        return f"<armtol.Answer: {self.arm.name}, {self.method}, {counts}>"

    def to_frame(self) -> Any:
        """A pandas data frame of the tolerances, a row a parameter."""
        return data_frame(self._rows, self._head)

    def _repr_html_(self) -> str:
        return html_table(f"{self.arm.title}: tolerances", self._head, self._rows) + html_table(
            "the tool's error", Component._fields, [*self.components, *self.norms]
        )

    def plot(self, ax: Any = None) -> Any:
        """The tolerances as bars, on a logarithmic scale, a colour for each unit; matplotlib's axes."""
        ax = axes_or_new(ax)
        names = [f"{x.link} {x.name}" for x in self.parameters]
        for unit in dict.fromkeys(x.unit for x in self.parameters):
            at = [k for k, x in enumerate(self.parameters) if x.unit == unit and 0 < self.tolerances[k] < math.inf]
            ax.barh(at, self.tolerances[at], label=unit)
        ax.set_xscale("log")
        ax.set_yticks(range(len(names)), names, fontsize="x-small")
        ax.invert_yaxis()
        ax.set_xlabel("tolerance")
        ax.legend()
        return ax


# ---- the question ----


def _accuracy(accuracy: Any) -> Floats:
    """Six numbers; None is a free one."""
    if not isinstance(accuracy, (str, bytes)) and hasattr(accuracy, "__len__"):
        accuracy = [math.inf if value is None else value for value in accuracy]
    return floats("accuracy", accuracy, (6,))


def _payload(payload: Any) -> dict[str, Any]:
    values = floats("payloads", payload).ravel()
    if values.size not in (1, 4):
        raise ValueError(f"payloads: {payload!r}, expected kg, or (kg, x, y, z)")
    return {"mass": values[0], "center": values[1:].tolist() if values.size == 4 else [0.0, 0.0, 0.0]}


class Question:
    """A question to the engine, and the memory that it is made of."""

    def __init__(self, arm: Arm, q: ArrayLike) -> None:
        self.arm = arm
        self.n = arm.n_parameters
        self.q = poses(q, arm.n_joints)
        if self.q.ndim > 2:
            raise ValueError(f"q: shape {self.q.shape}, expected (n_joints,) or (N, n_joints)")
        self.n_poses = 1 if self.q.ndim == 1 else len(self.q)
        self.kept: list[Any] = [self.q]
        self.given = False
        self.c_arm = ffi.new("armtol_arm *", arm._c[0])
        self.c = ffi.new("armtol_question *", {"arm": self.c_arm, "q": pointer(self.q), "n_poses": self.n_poses})

    def keep(self, array: Any) -> Any:
        self.kept.append(array)
        return array

    def array(self, what: str, values: ArrayLike, shape: tuple[int, ...]) -> Any:
        return pointer(self.keep(floats(what, values, shape)))

    def named(self, what: str, values: Names, read: Callable[[Any, bytes, Any], bool]) -> Any:
        """A value a parameter: names that the C library knows, or an array."""
        if isinstance(values, (str, dict)):
            array = self.keep(np.zeros(self.n))
            names = names_text(what, values)
            if names or what != "given":
                reading(lambda: read(self.arm._c, names, pointer(array)))
            return pointer(array)
        if values is None:
            return ffi.NULL
        return self.array(what, values, (self.n,))

    def weights(self, weights: Names) -> None:
        if isinstance(weights, str) and "=" not in weights:
            raise ValueError(f"weights: {weights!r}, expected NAME=NUMBER,...")
        self.c.weights = self.named("weights", weights, lib.binding_weights)

    def accuracy(self, accuracy: Any) -> None:
        """Six numbers, or names: components and norms."""
        if accuracy is None:
            return
        if not isinstance(accuracy, (str, dict)):
            self.c.accuracy = pointer(self.keep(_accuracy(accuracy)))
            return
        named = self.keep(ffi.new("named_accuracy *"))
        names = names_text("accuracy", accuracy)
        reading(lambda: lib.accuracy_parse(names, named))
        self.c.accuracy, self.c.norms, self.c.n_norms = named.components, named.norms, named.n_norms

    def ranges(self, given: Names, least: ArrayLike | None, largest: ArrayLike | None) -> None:
        low, high = self.keep(np.zeros(self.n)), self.keep(np.full(self.n, math.inf))
        if isinstance(given, (str, dict)):
            names = names_text("given", given)
            if names:
                reading(lambda: lib.binding_given(self.arm._c, names, pointer(low), pointer(high)))
        elif given is not None:
            low[:] = high[:] = floats("given", given, (self.n,))
        if least is not None:
            low[:] = floats("least", least, (self.n,))
        if largest is not None:
            high[:] = floats("largest", largest, (self.n,))
        self.given = bool(np.any(low > 0) or np.any(high < math.inf))
        self.least = low
        self.c.least, self.c.largest = pointer(low), pointer(high)

    def drives(self, drives: Names) -> None:
        if drives is None:
            return
        if not isinstance(drives, (str, dict)):
            raise TypeError("drives: expected names, as in {'backlash': 1e-4}")
        copy = self.keep(ffi.new("armtol_drive[]", [self.c_arm.drives[i] for i in range(self.c_arm.n_links)]))
        names = names_text("drives", drives)
        if names:
            reading(lambda: lib.binding_drives(self.arm._c, names, copy))
        self.c_arm.drives = copy

    def loads(self, payloads: Any, gravity: ArrayLike | None, force: ArrayLike | None, compensated: float) -> None:
        if not hasattr(payloads, "__len__"):
            raise TypeError("payloads: expected a list, an item a load case")
        masses = self.keep(ffi.new("armtol_mass[]", [_payload(x) for x in payloads]))
        loading = self.keep(ffi.new("armtol_loading *", lib.armtol_loading_standard))
        if gravity is not None:
            loading.gravity = vector("gravity", gravity).tolist()
        loading.force = vector("force", force).tolist()
        loading.compensated = compensated
        loading.n_payloads, loading.payloads = len(payloads), masses
        self.c.loading = loading

    def failed(self, fault: Any) -> None:
        if fault.status == lib.ARMTOL_NOTHING_LEFT:
            q, least = pointer(self.q), pointer(self.least)
            try:
                reading(lambda: lib.binding_say_nothing_left(self.c, q, least, self.given, fault))
            except ArmtolError as said:
                raise ArmtolError(str(said), status_text(fault.status), about_fault(fault)) from None
        raise_status(fault.status, about_fault(fault))


def make_question(
    arm: Arm,
    q: ArrayLike,
    *,
    tool: Any,
    accuracy: Any = None,
    method: str = "worst",
    sigma: float = 3.0,
    delta: float | None = None,
    weights: Names = None,
    tolerances: Names = None,
    given: Names = None,
    least: ArrayLike | None = None,
    largest: ArrayLike | None = None,
    drives: Names = None,
    payloads: Sequence[Any] = (),
    gravity: ArrayLike | None = None,
    force: ArrayLike | None = None,
    compensated: float = 0.0,
    drives_apart: bool = False,
) -> Question:
    """What is asked; what the arguments mean is said at Arm.allocate."""
    if method not in METHODS:
        raise ValueError(f"method: {method!r}, expected one of {', '.join(METHODS)}")
    question = Question(arm, q)
    question.c.tool = tool[0]
    question.c.method = METHODS[method]
    question.c.sigma = sigma
    if delta is not None:
        if not delta > 0:
            raise_status(lib.ARMTOL_BAD_DELTA, "method")
        question.c.delta = delta
    question.accuracy(accuracy)
    question.weights(weights)
    question.ranges(given, least, largest)
    question.c.tolerances = question.named("tolerances", tolerances, lib.binding_tolerances)
    question.drives(drives)
    question.loads(payloads, gravity, force, compensated)
    question.c.drives_apart = drives_apart
    return question


def ask(arm: Arm, q: ArrayLike, **options: Any) -> Answer:
    """The engine's answer to a question of these options."""
    question = make_question(arm, q, **options)
    made, fault = ffi.new("armtol_answer **"), ffi.new("armtol_fault *")
    if lib.armtol_answer_create(question.c, made, fault) != lib.ARMTOL_OK:
        question.failed(fault)
    return Answer(made[0], arm, question.n_poses)
