"""A verification in parts: ranges of arms drawn anywhere, counted, sent, and added up."""

from __future__ import annotations

import zlib
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from ._core import ArmtolError, about_fault, raise_status, text
from ._native import ffi, lib
from ._progress import Watch, drawing

if TYPE_CHECKING:
    from .answer import Answer, Verification

Ranges = tuple[tuple[int, int], ...]

_SUBJECTS = [text(lib.armtol_tally_subject_name(i)) for i in range(lib.ARMTOL_TALLY_SUBJECT_COUNT)]


def _fingerprints(answer: Answer) -> tuple[int, ...]:
    return tuple(int(lib.armtol_tally_fingerprint(answer._c, i)) for i in range(len(_SUBJECTS)))


def _empty() -> Any:
    made = ffi.new("armtol_tally **")
    raise_status(lib.armtol_tally_create(made))
    return ffi.gc(made[0], lib.armtol_tally_destroy, size=7 << 20)


def _members(c_tally: Any) -> list[Any]:
    return [lib.armtol_tally_member_at(c_tally, i) for i in range(lib.armtol_tally_member_count())]


def _memory(c_tally: Any) -> list[Any]:
    """All that a tally is, to be read and written."""
    members = _members(c_tally)
    return [ffi.buffer(x.counts if x.counts != ffi.NULL else x.numbers, 8 * x.length) for x in members]


def _united(ranges: Ranges) -> Ranges:
    """In order, those that touch as one; ValueError where an arm is in two of them."""
    united: list[tuple[int, int]] = []
    for first, count in sorted(ranges):
        if not count:
            continue
        end = sum(united[-1]) if united else -1
        if first < end:
            raise ValueError(f"tallies: arm {first} is in two of them; expected arms that are not the same")
        if first == end:
            united[-1] = (united[-1][0], united[-1][1] + count)
        else:
            united.append((first, count))
    return tuple(united)


class Tally:
    """What became of arms drawn: counts, and the largest errors. Made by Answer.tally. 7 MB; pickled, some 50 kB
    to 200 kB.

    Tallies of the same answer and seed can be added, in any order, also by sum(); an arm is in one of them alone.
    """

    def __init__(self, c_tally: Any, seed: int, fingerprints: tuple[int, ...], ranges: Ranges) -> None:
        self._c = c_tally
        self._fingerprints = fingerprints
        self.seed = seed
        self.ranges = _united(ranges)
        """The arms that are in it, (first, count) each, in order."""

    @property
    def drawn(self) -> int:
        """How many arms are in it."""
        return sum(count for _, count in self.ranges)

    def __repr__(self) -> str:
        return f"<armtol.Tally: {self.drawn} arms of seed {self.seed}>"

    def __add__(self, other: Tally) -> Tally:
        if not isinstance(other, Tally):
            return NotImplemented
        _same(self._fingerprints, other._fingerprints)
        if self.seed != other.seed:
            raise ValueError(f"tallies: seeds {self.seed} and {other.seed}, expected the same")
        added = Tally(_empty(), self.seed, self._fingerprints, self.ranges + other.ranges)
        for part in (self, other):
            lib.armtol_tally_add(added._c, part._c)
        return added

    def __radd__(self, other: Any) -> Tally:
        """sum() begins with 0."""
        return self if isinstance(other, int) and other == 0 else NotImplemented

    def verify(
        self, answer: Answer, threads: int | None = None, progress: Callable[[int, int], Any] | None = None
    ) -> Verification:
        """What `Answer.verify` tells of these arms; the worst corner is searched for now.

        answer  the one that they were drawn of, or one made anew by the same question. ArmtolError for another

        Arms that are missing between `ranges` are missing; nothing is said of them.
        """
        from .answer import Verification

        _same(self._fingerprints, _fingerprints(answer))
        watch = Watch(progress)
        found, fault = ffi.new("armtol_verification *"), ffi.new("armtol_fault *")
        draw = drawing(self.drawn, self.seed, threads, watch)
        status = lib.armtol_tally_verify(answer._c, draw, self._c, found, fault)
        watch.reraise()
        raise_status(status, about_fault(fault))
        return Verification(found, answer, self.seed)

    def __reduce__(self) -> tuple[Any, ...]:
        # a level that is fast: almost all of it is 0
        data = zlib.compress(b"".join(_memory(self._c)), 1)
        return _from_pickled, (text(lib.armtol_version()), data, self.seed, self._fingerprints, self.ranges)


def _same(ours: tuple[int, ...], theirs: tuple[int, ...]) -> None:
    different = [name for name, one, other in zip(_SUBJECTS, ours, theirs) if one != other]
    if different:
        raise ArmtolError(f"tallies: of different questions ({', '.join(different)}); expected those of one answer")


def _from_pickled(version: str, data: bytes, seed: int, fingerprints: tuple[int, ...], ranges: Ranges) -> Tally:
    if version != text(lib.armtol_version()):
        raise ArmtolError(f"tally: drawn by armtol {version}, expected {text(lib.armtol_version())}")
    c_tally, at = _empty(), 0
    memory, whole = _memory(c_tally), zlib.decompress(data)
    fine = len(whole) == sum(len(member) for member in memory)
    for member in memory if fine else ():
        member[:] = whole[at : at + len(member)]
        at += len(member)
    if not fine or (len(ranges) < 2 and not lib.armtol_tally_is_of(c_tally, *(ranges or ((0, 0),))[0])):
        raise ArmtolError("tally: damaged: its counts are not those of its arms")
    return Tally(c_tally, seed, fingerprints, ranges)


def draw_tally(
    answer: Answer, first: int, count: int, seed: int, threads: int | None, progress: Callable[[int, int], Any] | None
) -> Tally:
    """Answer.tally."""
    if first < 0 or count < 0 or first + count >= 2**64:
        raise ValueError(f"first and count: {first}, {count}, expected whole numbers from 0 on")
    watch = Watch(progress)
    draw = drawing(count, seed, threads, watch)
    c_tally, fault = _empty(), ffi.new("armtol_fault *")
    status = lib.armtol_tally_draw(answer._c, draw, first, c_tally, fault)
    watch.reraise()
    raise_status(status, about_fault(fault))
    drawn = int(next(x.counts[0] for x in _members(c_tally) if text(x.name) == "drawn"))
    if drawn < count and not watch.ended:
        raise KeyboardInterrupt  # a second one, while the first was kept
    return Tally(c_tally, seed, _fingerprints(answer), ((first, drawn),))
