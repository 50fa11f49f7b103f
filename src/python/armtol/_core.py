"""What the modules of this package share: calls of the C library, its errors as exceptions, arrays that it can read."""

from __future__ import annotations

import math
import os
import re
import threading
from collections.abc import Callable, Sequence
from html import escape
from importlib import import_module
from typing import Any, Union

import numpy as np
import numpy.typing as npt

from ._native import ffi, lib

Floats = npt.NDArray[np.float64]
ArrayLike = npt.ArrayLike
Names = Union[str, "dict[str, float | str]", ArrayLike, None]

COMPONENTS = ("dx", "dy", "dz", "wx", "wy", "wz")
"""The components of the tool's error: three of its point, in the arm's unit, and three rotations in radians."""

_ABOUT = {
    lib.ARMTOL_ABOUT_QUESTION: "the question",
    lib.ARMTOL_ABOUT_ARM: "the arm",
    lib.ARMTOL_ABOUT_POSE: "pose {}",
    lib.ARMTOL_ABOUT_ACCURACY: "accuracy, {}",
    lib.ARMTOL_ABOUT_NORM: "accuracy, norm {}",
    lib.ARMTOL_ABOUT_METHOD: "method",
    lib.ARMTOL_ABOUT_WEIGHTS: "weights, column {}",
    lib.ARMTOL_ABOUT_TOLERANCES: "tolerances, column {}",
    lib.ARMTOL_ABOUT_RANGES: "given, column {}",
    lib.ARMTOL_ABOUT_DISCS: "discs, column {}",
    lib.ARMTOL_ABOUT_SPREADS: "spreads, column {}",
    lib.ARMTOL_ABOUT_DRIVES: "the drive of link {}",
    lib.ARMTOL_ABOUT_LOADING: "loads",
    lib.ARMTOL_ABOUT_NORM_PLACE: "norm {} of a pose",
    lib.ARMTOL_ABOUT_ROW: "row {} of A",
}

# Messages name options of the command line; here they are arguments.
_OPTION = re.compile(r"--(accuracy|given|weights|tolerances|drives|base|tip)\b")

# What reads keeps its messages in one place for all threads.
_reading = threading.Lock()


class ArmtolError(ValueError):
    """What the C library could not do, in its words.

    `status` is the text of its status, as "a value is not finite", or None where a table, a URDF or a list was wrong:
    the message then says what and where. `about` says what of the question it is about.
    """

    def __init__(self, message: str, status: str | None = None, about: str | None = None) -> None:
        super().__init__(message)
        self.status = status
        self.about = about


def text(chars: Any) -> str:
    """A text of the C library's."""
    return str(ffi.string(chars).decode("utf-8", "replace"))


def status_text(status: int) -> str:
    return text(lib.armtol_status_text(status))


def raise_status(status: int, about: str | None = None) -> None:
    """Raises what a status says, unless it says that all is fine."""
    if status == lib.ARMTOL_OK:
        return
    if status == lib.ARMTOL_NO_MEMORY:
        raise MemoryError(status_text(status))
    said = status_text(status)
    raise ArmtolError(f"{about}: {said}" if about else said, said, about)


def about_fault(fault: Any) -> str | None:
    """What a fault of the engine's is about."""
    if fault.about not in _ABOUT:
        return None
    number = COMPONENTS[fault.number] if fault.about == lib.ARMTOL_ABOUT_ACCURACY else str(fault.number)
    return _ABOUT[fault.about].format(number)


def reading(call: Callable[[], Any]) -> Any:
    """What a call returns that reads a table, a URDF or a list; its messages are raised where that is null or false."""
    with _reading:
        lib.binding_listen()
        try:
            result = call()
        finally:
            said = text(lib.binding_said())
    if not result:
        raise ArmtolError(_OPTION.sub(r"\1", said))
    return result


def c_path(path: Any) -> bytes:
    """A file's name for C, once it is known that the file can be opened: Python's own exceptions say why not."""
    name = os.fsencode(os.path.abspath(os.fspath(path)))
    with open(name, "rb"):
        return name


# ---- arrays ----


def floats(what: str, values: ArrayLike, shape: tuple[int, ...] | None = None) -> Floats:
    """An array of doubles, in C's order; TypeError for what are no real numbers, ValueError for another shape."""
    array = np.asarray(values)
    if array.dtype.kind not in "fiu" or not np.can_cast(array.dtype, np.float64, "same_kind"):
        raise TypeError(f"{what}: {array.dtype} is no type of real numbers")
    if shape is not None and array.shape != shape:
        raise ValueError(f"{what}: shape {array.shape}, expected {shape}")
    return np.asarray(array, dtype=np.float64, order="C")


def poses(q: ArrayLike, n_joints: int) -> Floats:
    """Joint values, (..., n_joints)."""
    array = floats("q", q)
    if array.ndim == 0 or array.shape[-1] != n_joints:
        raise ValueError(f"q: shape {array.shape}, expected (..., {n_joints}): a value for each joint")
    return array


def output(out: Floats | None, shape: tuple[int, ...]) -> Floats:
    """The array to write to: the caller's, where there is one, which has to be as C needs it."""
    if out is None:
        return np.empty(shape)
    if not isinstance(out, np.ndarray) or out.dtype != np.float64:
        raise TypeError("out: expected a numpy array of float64")
    if out.shape != shape:
        raise ValueError(f"out: shape {out.shape}, expected {shape}")
    if not (out.flags.c_contiguous and out.flags.writeable):
        raise ValueError("out: expected an array that is C-contiguous and can be written")
    return out


def no_overlap(out: Floats, *inputs: Floats) -> None:
    for array in inputs:
        if np.may_share_memory(out, array):
            raise ValueError("out: shares memory with an input")


def pointer(array: Floats) -> Any:
    """The array as C sees it. Keep the array while C may look."""
    return ffi.cast("double *", ffi.from_buffer(array)) if array.size else ffi.NULL


def copied(chars: Any, *shape: int) -> Floats:
    """A copy of C's doubles."""
    count = math.prod(shape)
    return np.frombuffer(ffi.buffer(chars, 8 * count), dtype=np.float64).copy().reshape(shape)


def vector(what: str, values: ArrayLike | None) -> Floats:
    array = np.zeros(3) if values is None else floats(what, values, (3,))
    if not np.isfinite(array).all():
        raise_status(lib.ARMTOL_NOT_FINITE, what)
    return array


def names_text(what: str, names: dict[str, Any] | str) -> bytes:
    """The text of a list NAME=NUMBER,... as --weights and --given take it."""
    if isinstance(names, dict):
        for key in names:
            if not isinstance(key, str):
                raise TypeError(f"{what}: {key!r} is no name")
        names = ",".join(
            f"{key}={value if isinstance(value, str) else repr(float(value))}" for key, value in names.items()
        )
    if "\0" in names:
        raise ValueError(f"{what}: embedded null character")
    return names.encode()


def threads_or_all(threads: int | None) -> int:
    if threads is None:
        return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    if threads < 1:
        raise ValueError(f"threads: {threads}, expected 1 or more")
    return threads


# ---- what results have in common ----


def html_table(caption: str, head: Sequence[str], rows: Sequence[Sequence[Any]]) -> str:
    def cell(value: Any) -> str:
        if isinstance(value, float):
            return "" if math.isnan(value) else f"{value:.6g}"
        return escape(str(value))

    lines = [f"<table><caption>{escape(caption)}</caption>", "<thead><tr>"]
    lines += [f"<th>{escape(name)}</th>" for name in head] + ["</tr></thead><tbody>"]
    lines += ["<tr>" + "".join(f"<td>{cell(value)}</td>" for value in row) + "</tr>" for row in rows]
    return "".join(lines) + "</tbody></table>"


def data_frame(rows: Sequence[Any], columns: Sequence[str]) -> Any:
    """A pandas data frame; ImportError where pandas is not installed."""
    return import_module("pandas").DataFrame(list(rows), columns=list(columns))


def axes_or_new(ax: Any) -> Any:
    """matplotlib's axes; ImportError where it is not installed."""
    if ax is not None:
        return ax
    return import_module("matplotlib.pyplot").subplots()[1]
