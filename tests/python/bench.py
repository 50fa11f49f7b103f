"""How much Python adds: ns a pose, and ns an arm drawn, beside the same C routines called directly.

    build/python/bin/python tests/python/bench.py [POSES]

The processor's time, the best of 15 runs each, on one thread. Ends with status 1 where A of all poses, written to
`out`, takes more than 3 times as long as the library's own blocks. Those are its fastest form; `out` is (N, 6, n),
which has to be sorted.
"""

import sys
import time

import numpy as np

import armtol
from armtol._core import pointer
from armtol._native import ffi, lib

RUNS = 15


def best(call):
    times = []
    for _ in range(RUNS):
        began = time.thread_time()
        call()
        times.append(time.thread_time() - began)
    return min(times)


def blocks_of(arm, q):
    """armtol_pose_blocks over all poses at once, as a C program would call it."""
    n, columns = len(q), arm.n_parameters
    poses = ffi.new("armtol_poses *")
    prepared = ffi.new("armtol_pose_link[]", arm.n_links)
    limits = ffi.new("double[6]", [2] * 6)
    tool = ffi.new("armtol_tool_point *")
    assert lib.armtol_poses_start(poses, prepared, arm._c.links, arm.n_links, tool, limits, 1) == lib.ARMTOL_OK
    blocks = np.empty(-(-n // 8) * 8 * 6 * columns + 8)
    aligned = blocks[(-blocks.ctypes.data % 64) // 8 :]
    bounds = ffi.new("armtol_bounds[]", n)
    kept = prepared, limits, tool, blocks, aligned
    return lambda: (kept, lib.armtol_pose_blocks(poses, pointer(q), n, pointer(aligned), bounds))


def main(n):
    worst = 0.0
    print(f"{n} poses, ns a pose        blocks in C   error_matrix   ratio   forward   one pose")
    for name in armtol.builtin_arms():
        arm = armtol.Arm.builtin(name)
        q = np.random.default_rng(1).uniform(-1, 1, (n, arm.n_joints))
        out, frames = np.empty((n, 6, arm.n_parameters)), np.empty((n, 4, 4))
        direct = best(blocks_of(arm, q))
        ours = best(lambda: arm.error_matrix(q, out=out))
        forward = best(lambda: arm.forward(q, out=frames))
        alone = best(lambda: arm.error_matrix(q[0]))
        worst = max(worst, ours / direct)
        print(f"{name:24} {1e9 * direct / n:12.1f} {1e9 * ours / n:14.1f} {ours / direct:7.2f} "
              f"{1e9 * forward / n:9.1f} {1e9 * alone:10.0f}")  # fmt: skip
    answer = armtol.Arm.builtin("puma560").allocate([0, 0.8, -1.6, 0, 0.8, 0], [0.5] * 3 + [2e-4] * 3)
    arms = 1_000_000
    print(f"{'puma560, an arm drawn':24} {1e9 * best(lambda: answer.verify(arms, threads=1)) / arms:12.1f}")
    return worst > 3


sys.exit(main(int(sys.argv[1]) if len(sys.argv) > 1 else 100_000))
