"""Who looks on while the C library works: progress, exceptions of whoever is told, and Ctrl-C."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from ._core import threads_or_all
from ._native import ffi, lib


class Watch:
    """Who looks on, and what came of it. Keep it until the library has returned."""

    def __init__(self, progress: Callable[..., Any] | None) -> None:
        self.progress = progress
        self.raised: BaseException | None = None
        self.ended = False
        self.handle = ffi.new_handle(self)

    def told(self, *what: Any) -> bool:
        """False ends the work."""
        if self.progress is not None and self.progress(*what) is False:
            self.ended = True
        return self.raised is None and not self.ended

    def reraise(self) -> None:
        """What was raised meanwhile."""
        if self.raised is not None:
            raise self.raised


def _keep_exception(exception: Any, value: BaseException, traceback: Any) -> bool:
    """An exception in the callback, KeyboardInterrupt too, waits until the library has returned."""
    watch = ffi.from_handle(traceback.tb_frame.f_locals["context"])
    watch.raised = value.with_traceback(traceback)
    return False


@ffi.def_extern(onerror=_keep_exception)  # type: ignore[untyped-decorator]
def armtol_python_progress(context: Any, done: int, total: int) -> bool:
    return bool(ffi.from_handle(context).told(done, total))


@ffi.def_extern(onerror=_keep_exception)  # type: ignore[untyped-decorator]
def armtol_python_region_progress(context: Any, still_open: float, boxes: int) -> bool:
    return bool(ffi.from_handle(context).told(still_open, boxes))


@ffi.def_extern(onerror=_keep_exception)  # type: ignore[untyped-decorator]
def armtol_python_map_progress(context: Any, done: int, total: int) -> bool:
    return bool(ffi.from_handle(context).told(done, total))


def drawing(n: int, seed: int, threads: int | None, watch: Watch) -> Any:
    """How arms are to be drawn: an armtol_draw."""
    if not 0 <= n < 2**64 or not 0 <= seed < 2**64:
        raise ValueError(f"n and seed: {n}, {seed}, expected whole numbers of 0 to 2^64 - 1")
    draw = ffi.new("armtol_draw *", {"samples": n, "seed": seed, "n_threads": threads_or_all(threads)})
    draw.progress, draw.context = lib.armtol_python_progress, watch.handle
    return draw
