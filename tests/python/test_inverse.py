"""From positions to joint values: against the closed form of two links, where the tool is, and the program."""

import json
import math

import numpy as np
import pytest

from armtol import Arm
from armtol._native import ffi, lib

A, B = 0.4, 0.3


@pytest.fixture
def planar():
    return Arm.from_dh([[A, 0, 0, 0], [B, 0, 0, 0]], unit="m")


def elbows(x, y):
    """Both, by the law of cosines."""
    bend = math.acos((x * x + y * y - A * A - B * B) / (2 * A * B))
    first = math.atan2(y, x)
    return [(first - math.atan2(B * math.sin(e), A + B * math.cos(e)), e) for e in (bend, -bend)]


def test_two_links_have_two_elbows(planar, random):
    points = np.array([(r * math.cos(t), r * math.sin(t), 0) for r, t in random.uniform([0.2, -1], [0.6, 1], (20, 2))])
    found = planar.inverse(points)
    assert found.count.tolist() == [2] * 20
    assert found.q.shape == (20, 2, 2)
    for (x, y, _), q in zip(points, found.q):
        np.testing.assert_allclose(sorted(map(tuple, q)), sorted(elbows(x, y)), atol=1e-8)


def test_the_tool_is_where_it_should_be(arm, random):
    """Of each built-in arm, some joint values: one branch, at least, brings it there again. The slide without limits is
    out by 300 to 900 mm: where it is nearly in, the arm is nearly singular, and branches are missed."""
    limits = np.where(np.isfinite(arm.limits), arm.limits, [300.0, 900.0])
    frames = arm.forward(random.uniform(limits[:, 0], limits[:, 1], (5, arm.n_joints)))
    found = arm.inverse(frames, enough=2)
    assert (found.count > 0).all()
    for frame, count, branches in zip(frames, found.count, found.q):
        np.testing.assert_allclose(arm.forward(branches[:count]) - frame, 0, atol=2e-6)
        assert np.isnan(branches[count:]).all()
        low, high = arm.limits.T
        assert (branches[:count] >= low - 1e-9).all() and (branches[:count] <= high + 1e-9).all()


def test_shapes_and_out_of_reach(planar):
    near = planar.inverse([[[0.5, 0, 0], [0.2, 0.3, 0], [7, 0, 0]]])
    assert near.count.tolist() == [[2, 2, 0]]
    assert near.q.shape == (1, 3, 2, 2) and near.distance.shape == (1, 3, 2)
    assert np.isnan(near.q[0, 2]).all()
    np.testing.assert_allclose(near.best_distance[0, 2], 7 - A - B, rtol=1e-6)
    alone = planar.inverse([0.5, 0, 0])
    assert alone.q.shape == (2, 2) and alone.count == 2
    assert planar.inverse([9, 9, 9]).q.shape == (0, 2)
    assert planar.inverse(np.empty((0, 3))).q.shape == (0, 0, 2)
    assert len(near.to_frame()) == 4 and near._repr_html_().count("<tr>") == 5
    assert repr(near) == "<armtol.Branches: arm, 4 branches of 3 wishes>"


def test_near_and_the_tool_offset(planar):
    up = planar.inverse([0.5, 0.1, 0], near=[0.7, -1.2])
    assert up.q[0, 1] < 0 < up.q[1, 1] and up.from_near[0] < up.from_near[1]
    longer = planar.inverse([A + B + 0.1, 0, 0], tool_offset=[0.1, 0, 0], within=1e-6)
    np.testing.assert_allclose(longer.q[0], 0, atol=1e-2)


def test_the_same_as_the_program(source):
    """What it shows of joint values is rounded; the distances between are not."""
    expected = json.loads((source / "golden/armtol/at-branches-json").read_text())["positions"][0]
    radians = [x * math.pi / 180 for x in expected["at"][3:]]
    pose = [x * 1000 for x in expected["at"][:3]] + radians
    frame = lib.armtol_pose_to_transform(pose, ffi.addressof(lib.armtol_errata_none))
    found = Arm.builtin("ur5e").inverse([list(row) for row in frame.m])
    assert found.from_near.tolist() == [x["from_near"] for x in expected["branches"]]
    assert (found.distance / 1000).tolist() == [x["distance"] for x in expected["branches"]]
    np.testing.assert_allclose(np.degrees(found.q), [x["joints"] for x in expected["branches"]], atol=1e-11)


def test_the_own_inverse_kinematics_of_1987():
    intelledex = Arm.builtin("intelledex605t")
    frame = np.array([[0.0, -1, 0, 200], [0, 0, 1, 200], [-1, 0, 0, 0], [0, 0, 0, 1]])
    own = intelledex.inverse(frame, ignore_limits=True)
    assert own.own.tolist() == [True] + [False] * (own.count - 1)
    assert not intelledex.inverse(frame, near=np.zeros(6), ignore_limits=True).own.any()


@pytest.mark.parametrize(
    ("wish", "options", "message"),
    [
        ([1.0, 2.0], {}, "expected points"),
        (np.eye(4) * 2, {}, "right-handed"),
        (np.diag([1.0, 1, -1, 1]), {}, "right-handed"),
        (np.eye(4) + np.eye(4)[[3, 0, 1, 2]][:, [0, 1, 2, 3]] * [[0], [0], [0], [1]], {}, "last row"),
        ([np.nan, 0, 0], {}, "wish 0: a value is not finite"),
        ([0.1, 0, 0], {"near": [0.0]}, "near: shape"),
        ([0.1, 0, 0], {"near": [0.0, np.inf]}, "not finite"),
        ([0.1, 0, 0], {"enough": -1}, "enough"),
        ([0.1, 0, 0], {"within": np.nan}, "within"),
    ],
)
def test_wrong_wishes(planar, wish, options, message):
    with pytest.raises(ValueError, match=message):
        planar.inverse(wish, **options)
