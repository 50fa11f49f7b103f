"""Nothing is left behind: 10^5 arms, with their answers, their errors and their tables, in the memory of the first."""

import gc
import pickle
import resource

import numpy as np
import pytest

import armtol

TABLE = "units: m rad\njoint a alpha d theta\ntheta 0.4 0.3 0 0\ntheta 0.35 0 0.1 0\n"
MOST_GROWTH = 4 << 20  # bytes; an arm takes some 1.5 kB, and so 10^5 of them 150 MB


def resident():
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * resource.getpagesize()


def use_an_arm(i):
    arm = armtol.Arm.from_text(TABLE)
    if i % 100 == 0:
        answer = arm.allocate([0.1, 0.2], [1e-3] * 3 + [1e-3] * 3, weights={"motors": 2}, payloads=[1])
        answer.budget.motors.sum()
        arm.table()
        arm.error_matrix(np.zeros((3, 2)))
        armtol.hahn1987.adpta((200, 200, 0, 0), (0.5, 0.5, 0.5, 0.1, 0.1, 0.1), 0.1).files()
    if i % 100 == 1:
        with pytest.raises(armtol.ArmtolError):
            armtol.Arm.from_text("units: m rad\njoint a\n")
        with pytest.raises(armtol.ArmtolError):
            arm.allocate([0.1, np.nan], [1e-3] * 6)
    if i % 1000 == 2:
        answer = arm.allocate([0.1, 0.2], [1e-3] * 6)
        answer.verify(100, threads=1)
        pickle.loads(pickle.dumps(answer.tally(0, 50, threads=1) + answer.tally(50, 50, threads=1))).verify(answer)
    if i % 1000 == 3:
        arm.region("q1=0..1;q2=0.1..0.2", {"r": 1e-3}, gap=1).answer.budget.motors.sum()
        arm.inverse([[0.5, 0.2, 0.4], [9, 9, 9]])
        arm.map("xy", (0.2, 0.6), (0, 0.4), grid=(3, 3), tolerances={"motors": 1e-3}, offset=0.4)
        with pytest.raises(armtol.ArmtolError):
            arm.region("box=9..10,0..1,0..1", {"r": 1e-3})


def test_arms_leave_nothing_behind():
    for i in range(2_000):
        use_an_arm(i)
    gc.collect()
    before = resident()
    for i in range(100_000):
        use_an_arm(i)
    gc.collect()
    assert resident() - before < MOST_GROWTH
