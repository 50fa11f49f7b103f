"""Questions: names and arrays, what the answers keep to, and what is refused."""

import pickle

import numpy as np
import pytest

from armtol import Arm, ArmtolError

Q = [0.0, 0.8, -1.6, 0.0, 0.8, 0.0]
ACCURACY = [0.5, 0.5, 0.5, 2e-4, 2e-4, 2e-4]


def test_worst_case_tolerances_use_up_the_accuracy(arm, random):
    q = random.uniform(-1, 1, (3, arm.n_joints))
    accuracy = np.array([0.5, 0.4, 0.3, 2e-4, 1e-4, 3e-4])
    answer = arm.allocate(q, accuracy)
    worst = np.abs(answer.matrix) @ answer.tolerances
    assert (worst <= accuracy * (1 + 1e-9)).all()
    assert (np.abs(worst.max(axis=0) - answer.worst) <= 1e-9 * answer.worst).all()
    # none can be made larger alone
    for k in range(arm.n_parameters):
        larger = answer.tolerances.copy()
        larger[k] *= 1 + 1e-6
        assert ((np.abs(answer.matrix) @ larger).max(axis=0) > accuracy).any()


def test_weights_by_name_and_by_value_are_the_same(puma):
    is_motor = np.array([x.role == "motor" for x in puma.parameters])
    is_alpha_3 = np.array([(x.link, x.name) == (3, "alpha") for x in puma.parameters])
    weights = np.where(is_motor, 3.0, 1.0)
    weights[is_alpha_3] = 10
    by_value = puma.allocate(Q, ACCURACY, weights=weights).tolerances
    for names in ({"motors": 3, "3.alpha": 10}, "motors=3,3.alpha=10"):
        assert puma.allocate(Q, ACCURACY, weights=names).tolerances.tobytes() == by_value.tobytes()
    assert by_value.tobytes() != puma.allocate(Q, ACCURACY).tolerances.tobytes()


def test_given_by_name_and_by_value_are_the_same(puma):
    is_motor = np.array([x.role == "motor" for x in puma.parameters])
    is_length = np.array([x.unit == "mm" for x in puma.parameters])
    least, largest = np.where(is_motor, 1e-5, 0.0), np.where(is_motor, 1e-5, np.where(is_length, 0.05, np.inf))
    by_value = puma.allocate(Q, ACCURACY, least=least, largest=largest)
    for names in ({"motors": 1e-5, "lengths": "0..0.05"}, "motors=1e-5,lengths<=0.05"):
        assert puma.allocate(Q, ACCURACY, given=names).tolerances.tobytes() == by_value.tolerances.tobytes()
    assert (by_value.tolerances[is_motor] == 1e-5).all()
    assert by_value.given.tolist() == is_motor.tolist()
    assert by_value.tolerances[is_length].max() <= 0.05 < by_value.tolerances[is_length].max() * (1 + 1e-12)
    assert (by_value.held[is_length] >= 0).all() and by_value.held.max() > 0


def test_tolerances_by_name_and_by_value_are_the_same(puma):
    is_length = np.array([x.unit == "mm" for x in puma.parameters])
    by_value = puma.predict(Q, np.where(is_length, 0.01, 0.0))
    assert puma.predict(Q, {"lengths": 0.01}).worst.tobytes() == by_value.worst.tobytes()
    np.testing.assert_allclose(by_value.worst, np.abs(by_value.matrix[0][:, is_length]).sum(axis=1) * 0.01, rtol=1e-12)


def test_drives_by_name(source):
    """A revolute joint about z gives way to nothing, one about y to the whole moment (Hooke): closed form."""
    beam = Arm.from_text("units: m rad\njoint a alpha d theta\ntheta 0 -1.5707963267948966 0 0\ntheta 2 0 0 0\n")
    compliance, mass, g = 1e-6, 3.0, 9.80665
    sag = beam.sag([0, 0], payloads=[0, mass], drives={"compliance": compliance})
    assert sag.shape == (2, 6)
    np.testing.assert_allclose(sag[0], 0, atol=1e-15)
    turned = compliance * mass * g * 2  # about y, which points down the load
    np.testing.assert_allclose(sag[1], [2 * (np.cos(turned) - 1), 0, -2 * np.sin(turned), 0, turned, 0], atol=1e-15)
    assert beam.sag(np.zeros((4, 5, 2)), payloads=[1], drives="compliance=1e-6").shape == (4, 5, 1, 6)


def test_noise_of_drives_is_three_deviations_wide(puma):
    """Named, or in the rows of an arm, which keeps it when it is written and read, and pickled."""
    sigma, exact = 1e-5, np.zeros(puma.n_parameters)
    named = puma.predict(Q, exact, drives={"1.noise": sigma})
    expected = [3 * sigma if x.role == "motor" and x.link == 1 else 0 for x in puma.parameters]
    np.testing.assert_allclose(named.tolerances, expected, rtol=1e-15)
    row = {"joint": "theta", "a": 100, "alpha": 0, "d": 0, "theta": 0}
    arm = Arm.from_dh([{**row, "noise": 0}, {**row, "noise": sigma}])
    for one in (arm, Arm.from_text(arm.table()), pickle.loads(pickle.dumps(arm))):
        found = one.predict([0.1, 0.2], np.zeros(one.n_parameters))
        motors = [t for t, x in zip(found.tolerances, one.parameters) if x.role == "motor"]
        np.testing.assert_allclose(motors, [0, 3 * sigma], rtol=1e-15)
    with pytest.raises(ArmtolError, match="drives: .* is negative"):
        puma.predict(Q, exact, drives={"noise": -1})


def test_payloads_with_centers_and_gravity(source):
    level = Arm.from_table(source / "golden/armtol/level.csv")
    q = [0.1, 0.5, -1.0]
    both = level.sag(q, payloads=[5, (5, 0.05, 0, 0)])
    assert both.shape == (2, 6) and not np.array_equal(both[0], both[1])
    weightless = level.sag(q, gravity=[0, 0, 0], drives={"backlash": 0})
    np.testing.assert_array_equal(weightless, np.zeros((1, 6)))


def test_a_budget_shares_out_everything(puma):
    budget = puma.allocate(Q, ACCURACY).budget
    np.testing.assert_allclose(budget.shares.sum(axis=0), 1, rtol=1e-12)
    is_motor = np.array([row.role == "motor" for row in budget.rows])
    np.testing.assert_allclose(budget.shares[is_motor].sum(axis=0), budget.motors, rtol=1e-12)
    np.testing.assert_array_equal(budget.loads, 0)


def test_free_components_and_what_nothing_bounds(puma):
    answer = puma.allocate(Q, [0.5, None, np.inf, None, None, None])
    assert np.isinf(answer.accuracy).sum() == 5
    assert np.isinf(answer.tolerances).any()
    with pytest.raises(ArmtolError, match="dx|accuracy"):
        puma.predict(Q, np.where(answer.matrix[0, 0] != 0, np.inf, 0), accuracy=ACCURACY).verify(1000)


def test_the_sphere_and_its_bounds(puma):
    chosen = puma.allocate(Q, ACCURACY, method="sphere")
    given = puma.allocate(Q, ACCURACY, method="sphere", delta=chosen.delta)
    assert given.bounds == chosen.bounds
    assert puma.allocate(Q, ACCURACY).bounds is None


def test_more_deviations_leave_less(puma):
    one, two = (puma.allocate(Q, ACCURACY, method="rss", sigma=sigma).tolerances for sigma in (1.5, 3))
    np.testing.assert_allclose(one, 2 * two, rtol=1e-9)


def test_drives_apart(source):
    level = Arm.from_table(source / "golden/armtol/level.csv")
    accuracy = [0.002] * 3 + [0.2] * 3
    apart, within = (level.allocate([0.1, 0.5, -1], accuracy, drives_apart=apart) for apart in (True, False))
    assert within.given.any() and not apart.given.any()
    np.testing.assert_array_equal(apart.sag, 0)


def test_answers_outlive_their_arm_and_their_question():
    answer = Arm.builtin("puma560").allocate(np.array(Q), np.array(ACCURACY))
    assert answer.verify(100).within == 100
    assert len(answer.parts) == 6


@pytest.mark.parametrize(
    ("wrong", "error", "message"),
    [
        (lambda arm: arm.allocate(Q, ACCURACY[:5]), ValueError, r"accuracy: shape \(5,\), expected \(6,\)"),
        (lambda arm: arm.allocate(Q, "fine"), ArmtolError, "accuracy: .fine. is no NAME=NUMBER"),
        (lambda arm: arm.allocate(Q, 1), ValueError, r"accuracy: shape \(\)"),
        (
            lambda arm: arm.allocate(Q, [0.5, 0, 0.5, 1, 1, 1]),
            ArmtolError,
            "accuracy, dy: a tolerance is not greater than zero",
        ),
        (lambda arm: arm.allocate(Q, [np.nan] * 6), ArmtolError, "accuracy, dx"),
        (lambda arm: arm.allocate(np.zeros((0, 6)), ACCURACY), ArmtolError, "the question"),
        (lambda arm: arm.allocate(np.zeros((1, 2, 6)), ACCURACY), ValueError, "q: shape"),
        (lambda arm: arm.allocate([np.inf] * 6, ACCURACY), ArmtolError, "pose 0: a value is not finite"),
        (
            lambda arm: arm.allocate(Q, ACCURACY, method="best"),
            ValueError,
            "method: 'best', expected one of worst, rss, sphere",
        ),
        (lambda arm: arm.allocate(Q, ACCURACY, method="rss", sigma=0), ArmtolError, "method"),
        (lambda arm: arm.allocate(Q, ACCURACY, method="sphere", delta=9), ArmtolError, "method: .*delta"),
        (lambda arm: arm.allocate(Q, ACCURACY, method="sphere", delta=0), ArmtolError, "method: .*delta"),
        (
            lambda arm: arm.allocate(Q, ACCURACY, weights=[1, 2]),
            ValueError,
            r"weights: shape \(2,\), expected \(24,\)",
        ),
        (lambda arm: arm.allocate(Q, ACCURACY, weights=[0] * 24), ArmtolError, "weights, column 0"),
        (lambda arm: arm.allocate(Q, ACCURACY, weights={"motor": 2}), ArmtolError, 'weights: unknown name "motor"'),
        (lambda arm: arm.allocate(Q, ACCURACY, weights={"9.alpha": 2}), ArmtolError, "puma560 has no parameter"),
        (lambda arm: arm.allocate(Q, ACCURACY, weights="motors"), ValueError, "expected NAME=NUMBER"),
        (lambda arm: arm.allocate(Q, ACCURACY, weights={3: 2}), TypeError, "3 is no name"),
        (lambda arm: arm.allocate(Q, ACCURACY, weights="motors=1\0"), ValueError, "null"),
        (lambda arm: arm.allocate(Q, ACCURACY, given={"motors": "2..1"}), ArmtolError, "given: .*the least is above"),
        (lambda arm: arm.allocate(Q, ACCURACY, given={"motors": -1}), ArmtolError, "given"),
        (lambda arm: arm.allocate(Q, ACCURACY, least=[2] * 24, largest=[1] * 24), ArmtolError, "given, column 0"),
        (
            lambda arm: arm.allocate(Q, ACCURACY, given=np.ones(24)),
            ArmtolError,
            "no tolerances: what is given uses .* in pose 1: machining",
        ),
        (lambda arm: arm.allocate(Q, ACCURACY, drives={"play": 1}), ArmtolError, "drives: unknown name"),
        (lambda arm: arm.allocate(Q, ACCURACY, drives=[1]), TypeError, "drives"),
        (lambda arm: arm.allocate(Q, ACCURACY, drives={"compliance": 1}), ArmtolError, "the drive of link 0"),
        (
            lambda arm: arm.allocate(Q, ACCURACY, drives={"backlash": 1}),
            ArmtolError,
            "the drives alone use .* motor of link",
        ),
        (lambda arm: arm.allocate(Q, ACCURACY, payloads=3), TypeError, "payloads: expected a list"),
        (lambda arm: arm.allocate(Q, ACCURACY, payloads=[(1, 2)]), ValueError, "payloads"),
        (lambda arm: arm.allocate(Q, ACCURACY, payloads=[-1]), ArmtolError, "loads"),
        (lambda arm: arm.allocate(Q, ACCURACY, compensated=2), ArmtolError, "loads"),
        (lambda arm: arm.allocate(Q, ACCURACY, gravity=[0, 0]), ValueError, r"gravity: shape \(2,\)"),
        (lambda arm: arm.allocate(Q, ACCURACY, force=[0, 0, np.nan]), ArmtolError, "force"),
        (lambda arm: arm.allocate(Q, ACCURACY, frame="hand"), ValueError, "frame"),
        (lambda arm: arm.predict(Q, [1] * 5), ValueError, r"tolerances: shape \(5,\)"),
        (lambda arm: arm.predict(Q, [-1] * 24), ArmtolError, "tolerances, column 0"),
        (lambda arm: arm.predict(Q, {"lengths": "0..1"}), ArmtolError, "tolerances"),
        (lambda arm: arm.predict(Q, None), ArmtolError, "the question"),
    ],
)
def test_what_is_wrong_is_said(puma, wrong, error, message):
    with pytest.raises(error, match=message):
        wrong(puma)


def test_an_error_has_the_status_apart(puma):
    with pytest.raises(ArmtolError) as caught:
        puma.allocate(Q, ACCURACY, given=np.ones(24))
    assert caught.value.about is not None and caught.value.about.endswith("of A")
    assert caught.value.status == "what is given exceeds the accuracy by itself"
    with pytest.raises(ArmtolError) as caught:
        puma.allocate(Q, ACCURACY, given="x=1")
    assert caught.value.status is None
