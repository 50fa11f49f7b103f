"""The programs of 1987, intella and adpta, with their errata as an argument (docs/errata.md).

Millimetres and radians. `fix` names errata to correct: a name, several, "all", or nothing for the programs as printed.
"""

from __future__ import annotations

import json
from collections.abc import Iterable
from importlib.resources import as_file, files
from typing import Any, NamedTuple, Union

import numpy as np

from ._core import (
    ArmtolError,
    ArrayLike,
    Floats,
    _reading,
    copied,
    data_frame,
    floats,
    html_table,
    pointer,
    raise_status,
    text,
)
from ._native import ffi, lib

Fix = Union[str, Iterable[str]]


class Erratum(NamedTuple):
    id: str
    slip: str
    """What the programs do, and what is right."""
    touches: str
    """Which results show it."""
    changes: str
    """The programs whose results it can change."""


class Number(NamedTuple):
    """A published number beside ours."""

    program: str
    case: int
    quantity: str
    published: str
    computed: str
    verdict: str
    """agrees, agrees without its sign (where the paper prints none), differs, or missing."""


def errata() -> list[Erratum]:
    """Every erratum of the programs; its `id` is what `fix` takes."""
    infos = [lib.armtol_erratum(i) for i in range(lib.armtol_errata_count())]
    return [Erratum(text(x.id), text(x.slip), text(x.touches), text(x.changes)) for x in infos]


def _names(fix: Fix) -> list[str]:
    return [fix] if isinstance(fix, str) else list(fix)


def _errata(fix: Fix) -> Any:
    kept = ffi.new("armtol_errata *", lib.armtol_errata_1987)
    for name in _names(fix):
        raise_status(lib.armtol_erratum_keep(kept, name.encode(), False), f"fix: {name!r}")
    return kept


class Run:
    """A run of intella or adpta, from the wish to the tolerances of every part. Millimetres and radians."""

    def __init__(self, program: Any, run: Any) -> None:
        self._program = program
        self._run = run
        robot = run.robot
        n = run.n_columns
        self.program = text(program.name)
        self.q = copied(run.q, robot.n_joints)
        """Joint values that bring the tool there."""
        self.check = copied(run.check, robot.n_wish)
        """Where they bring it, by the second description of the arm."""
        self.matrix = copied(run.matrix, 6, n)
        """A, (6, n)."""
        self.ordered = copied(run.ordered, 6, n)
        """A with its n_lengths columns of lengths first, (6, n)."""
        self.n_lengths = int(run.n_lengths)
        self.distance_bound = float(run.bounds.distance)
        """The radius of the errors of all lengths, Eq. (4.31)."""
        self.angle_bound = float(run.bounds.angle)
        """The radius of the errors of all angles, Eqs (4.25) to (4.28)."""
        self.distance_share = float(run.shares.distance)
        """What each length may be off."""
        self.angle_share = float(run.shares.angle)
        """What each angle may be off."""
        self.machining = copied(run.machining, robot.n_links)
        """The tolerance of the distance between the axes of each link, Eq. (4.32): rd."""
        self.motors = copied(run.motor, robot.n_joints)
        """The tolerance of each motor: td."""

    def files(self) -> dict[str, str]:
        """What the program's four files say, by their names without the run number."""
        prefix = text(self._program.file_prefix)
        parts = ["a", "at", "tol", "mach"]
        return {prefix + part: self._file(i) for i, part in enumerate(parts)}

    def _file(self, number: int) -> str:
        chars = lib.binding_run_file(self._program, self._run, number)
        if chars == ffi.NULL:
            raise MemoryError
        return text(ffi.gc(chars, lib.binding_text_free))

    def __repr__(self) -> str:
        return f"<armtol.hahn1987.Run {self.program}: bounds {self.distance_bound:.6f} mm, {self.angle_bound:.6f} rad>"

    def _repr_html_(self) -> str:
        rows = [(f"rd[{i}]", float(x)) for i, x in enumerate(self.machining)]
        rows += [(f"td[{i}]", float(x)) for i, x in enumerate(self.motors)]
        rows += [("bound of lengths", self.distance_bound), ("bound of angles", self.angle_bound)]
        return html_table(self.program, ("quantity", "value"), rows)

    def to_frame(self) -> Any:
        """A pandas data frame of the parts: machining distance, the share of an angle."""
        rows = [(i, float(x), self.angle_share) for i, x in enumerate(self.machining)]
        return data_frame(rows, ("link", "rd", "ggd"))


def _run(name: str, wish: ArrayLike, accuracy: ArrayLike, delta: float, fix: Fix, residue: ArrayLike | None) -> Run:
    program = lib.program_named(name.encode())
    n_wish = program.robot.n_wish
    c_wish = floats("position", wish, (n_wish,))
    c_accuracy = floats("accuracy", accuracy, (6,))
    words = None if residue is None else floats("residue", residue, (3,))
    status = ffi.new("armtol_status *")
    run = lib.binding_run(
        program,
        pointer(c_wish),
        pointer(c_accuracy),
        delta,
        _errata(fix),
        ffi.NULL if words is None else pointer(words),
        status,
    )
    if run == ffi.NULL:
        raise MemoryError
    run = ffi.gc(run, lib.binding_run_free)
    raise_status(status[0], name)
    return Run(program, run)


def intella(
    position: ArrayLike, accuracy: ArrayLike, delta: float, *, fix: Fix = (), residue: ArrayLike | None = None
) -> Run:
    """The Intelledex 605T, as the program `intella` computes it.

    position  x, y, z in mm and gamma, beta, alpha: zyx Euler angles in radians
    accuracy  of dx, dy, dz (mm) and of the rotations about x, y and z (radians), all > 0
    delta     what of the linear accuracy is kept for errors of lengths, below the least of the three
    fix       errata to correct
    residue   the three words on the stack that getj never sets, as floats; None: those that the library works out

    ArmtolError where the position is out of reach or singular.
    """
    return _run("intella", position, accuracy, delta, fix, residue)


def adpta(
    position: ArrayLike, accuracy: ArrayLike, delta: float, *, fix: Fix = (), residue: ArrayLike | None = None
) -> Run:
    """The Adept AdeptOne, as the program `adpta` computes it.

    position is x, y, z in mm and theta in radians; the rest is as of `intella`.
    """
    return _run("adpta", position, accuracy, delta, fix, residue)


class Reproduction:
    """Every published number beside ours."""

    def __init__(self, numbers: list[Number]) -> None:
        self.numbers = numbers

    @property
    def reproduced(self) -> int:
        """How many agree."""
        return sum(number.verdict.startswith("agrees") for number in self.numbers)

    def __len__(self) -> int:
        return len(self.numbers)

    def __repr__(self) -> str:
        return f"<{self.reproduced} of {len(self)} published numbers reproduced>"

    def to_frame(self) -> Any:
        """A pandas data frame, a row a number."""
        return data_frame(self.numbers, Number._fields)

    def _repr_html_(self) -> str:
        return html_table(
            f"{self.reproduced} of {len(self)} published numbers reproduced", Number._fields, self.numbers
        )


_opened = False


def reproduce(fix: Fix = ()) -> Reproduction:
    """Runs both programs on the paper's four cases and compares, to the last printed digit, with what it prints."""
    global _opened
    _errata(fix)
    names = " ".join(_known(fix)).encode()
    with _reading:
        lib.binding_listen()
        try:
            if not _opened:
                with as_file(files("armtol") / "published.tsv") as path:
                    _opened = bool(lib.page_open(str(path).encode()))
            told = text(lib.page_bench(names)) if _opened else ""
        finally:
            said = text(lib.binding_said())
    if not told:
        raise ArmtolError(said)
    return Reproduction(
        [
            Number(case["program"], case["number"], x["quantity"], x["published"], x["computed"], x["verdict"])
            for case in json.loads(told)["cases"]
            for x in case.get("results", ())
        ]
    )


def _known(fix: Fix) -> list[str]:
    names = _names(fix)
    return [x.id for x in errata()] if "all" in names else names
