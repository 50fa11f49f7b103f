"""Accuracy by names: components, balls and discs. The judge is every corner of the box of tolerances."""

import itertools

import numpy as np
import pytest

from armtol import Arm, ArmtolError

ROWS = [[0.4, 0.5, 0.1, 0], [0.3, 0, 0, 0.2]]
Q = [0.3, -1.1]


@pytest.fixture
def small():
    return Arm.from_dh(ROWS, unit="m")


def largest_of_corners(answer, components):
    """Of the length of the error in some components, over all corners and poses."""
    corners = np.array(list(itertools.product((-1, 1), repeat=len(answer.tolerances)))) * answer.tolerances
    errors = corners @ answer.matrix[:, components].transpose(0, 2, 1)
    return np.linalg.norm(errors, axis=-1).max()


def test_a_ball_and_a_disc_are_kept_and_used_up(small):
    answer = small.allocate([Q, [1.0, 0.5]], {"r": 1e-3, "wxy": 2e-3, "wz": 5e-3})
    assert [norm.name for norm in answer.norms] == ["r", "wxy"]
    ball, disc = largest_of_corners(answer, [0, 1, 2]), largest_of_corners(answer, [3, 4])
    np.testing.assert_allclose([norm.worst for norm in answer.norms], [ball, disc], rtol=1e-9)
    assert ball <= 1e-3 * (1 + 1e-9) and disc <= 2e-3 * (1 + 1e-9)
    assert max(ball / 1e-3, disc / 2e-3) > 1 - 1e-6
    assert answer.accuracy.tolist() == [np.inf] * 5 + [5e-3]


def test_a_text_is_a_dict(small):
    by_text, by_dict = (small.allocate(Q, x).tolerances for x in ("r=0.001,wz=0.01", {"r": 1e-3, "wz": 0.01}))
    assert by_text.tobytes() == by_dict.tobytes()


def test_components_by_name_are_those_by_place(small):
    by_name = small.allocate(Q, {"dx": 1e-3, "wz": 1e-2}).tolerances
    assert by_name.tobytes() == small.allocate(Q, [1e-3, None, None, None, None, 1e-2]).tolerances.tobytes()


def test_budget_and_verification_have_norms(small):
    answer = small.allocate(Q, {"r": 1e-3, "w": 1e-2})
    budget = answer.budget
    assert budget.norm_shares.shape == (len(budget.rows), 2)
    np.testing.assert_allclose(budget.norm_shares.sum(axis=0), 1, rtol=1e-9)
    found = answer.verify(2000)
    assert found.names[6:] == ("r", "w")
    assert found.quantiles.shape == (8, 4)
    np.testing.assert_allclose(found.worst_corner[6], largest_of_corners(answer, [0, 1, 2]), rtol=1e-2)
    assert len(found.to_frame()) == 8 and found.within == 2000


@pytest.mark.parametrize(
    ("wrong", "message"),
    [
        ({"r": 1e-3, "q": 1}, "accuracy: .*q"),
        ({"r": 0}, "accuracy: r: .* not greater than zero"),
        ({"r": "nan"}, "accuracy: r"),
        ("r=1e-3,r=2e-3", "accuracy: .*r"),
        ("r", "accuracy"),
    ],
)
def test_wrong_names(small, wrong, message):
    with pytest.raises(ArmtolError, match=message):
        small.allocate(Q, wrong)


def test_given_that_leaves_nothing_of_a_ball(small):
    with pytest.raises(ArmtolError, match="% of r in pose 1"):
        small.allocate(Q, {"r": 1e-3}, given={"lengths": 1})


def test_spheres_have_no_norms(small):
    with pytest.raises(ArmtolError, match="method"):
        small.allocate(Q, {"r": 1e-3, "dx": 1, "dy": 1, "dz": 1, "wx": 1, "wy": 1, "wz": 1}, method="sphere")
