"""Arms from everywhere, and where they are: against Eq. (4.1), written down here once more."""

import copy
import pickle

import numpy as np
import pytest

import armtol
from armtol import Arm, ArmtolError


def turn(axis, angle):
    c, s = np.cos(angle), np.sin(angle)
    i, j = [k for k in range(3) if k != axis]
    frame = np.eye(4)
    frame[i, i] = frame[j, j] = c
    frame[j, i], frame[i, j] = (s, -s) if axis != 1 else (-s, s)
    return frame


def shift(x, y, z):
    frame = np.eye(4)
    frame[:3, 3] = x, y, z
    return frame


def paul(a, alpha, d, theta, beta=0.0):
    return turn(2, theta) @ shift(a, 0, d) @ turn(0, alpha) @ turn(1, beta)


def craig(a, alpha, d, theta):
    return turn(0, alpha) @ shift(a, 0, 0) @ turn(2, theta) @ shift(0, 0, d)


ROWS = np.array([[0.0, np.pi / 2, 100, 0.1], [300, 0, 0, -0.2], [20.5, -np.pi / 2, 5, 0], [0, 0, 60, 0.3]])


def chain(transform, rows, q):
    frame = np.eye(4)
    for row, value in zip(rows, q):
        a, alpha, d, theta, *beta = row
        frame = frame @ transform(a, alpha, d, theta + value, *beta)
    return frame


@pytest.mark.parametrize(
    ("convention", "transform"), [("paul", paul), ("standard", paul), ("craig", craig), ("modified", craig)]
)
def test_rows_mean_what_the_convention_says(convention, transform, random):
    made = Arm.from_dh(ROWS, convention)
    assert made.n_joints == 4
    for q in random.uniform(-3, 3, (20, 4)):
        np.testing.assert_allclose(made.forward(q), chain(transform, ROWS, q), atol=1e-11)


def test_hayati_has_beta(random):
    rows = np.column_stack([ROWS, [0, 0.01, 0, 0]])
    made = Arm.from_dh(rows, "hayati")
    assert made.links[1].kind == "ppr"
    for q in random.uniform(-3, 3, (20, 4)):
        np.testing.assert_allclose(made.forward(q), chain(paul, rows, q), atol=1e-11)


def test_rows_as_dicts_in_degrees_and_metres():
    rows = [
        {"joint": "theta", "a": 0, "alpha": 90, "d": 0.4, "theta": 0},
        {"joint": "d", "a": 0, "alpha": -90, "d": 0.25, "theta": 180, "low": 0, "high": 0.6},
        {"joint": "fixed", "a": 0.08, "alpha": 0, "d": 0, "theta": 0, "beta": 0.5},
    ]
    made = Arm.from_dh(rows, unit="m", angle="deg", name="crane")
    assert (made.name, made.unit, made.n_links, made.n_joints) == ("crane", "m", 3, 2)
    np.testing.assert_array_equal(made.limits, [[-np.inf, np.inf], [0, 0.6]])
    expected = paul(0, np.pi / 2, 0.4, 0.3) @ paul(0, -np.pi / 2, 0.35, np.pi) @ paul(0.08, 0, 0, 0, np.radians(0.5))
    np.testing.assert_allclose(made.forward([0.3, 0.1]), expected, atol=1e-15)


def test_letters_say_what_moves():
    made = Arm.from_dh(ROWS, joints="RFPR")
    assert [link.joint for link in made.links] == ["revolute", "fixed", "prismatic", "revolute"]
    assert made.n_joints == 3


def test_a_joint_that_follows_another_has_no_value(random):
    """theta of the second link is -q + 1.5 there (docs/arm-files.md); the sign of the third turns it round."""
    table = (
        "units: m rad\njoint, a, alpha, d, theta, couple, multiplier, offset, sign\n"
        "theta, 0.3, 0.5, 0, 0, -, -, -, 1\ntheta, 0.3, 0, 0.1, 0, 0, -1, 1.5, 1\ntheta, 0.1, 0.2, 0, 0, -, -, -, -1\n"
    )
    made = Arm.from_text(table)
    assert made.n_joints == 2
    q = random.uniform(-3, 3, (30, 2))
    for values, frame in zip(q, made.forward(q)):
        expected = paul(0.3, 0.5, 0, values[0]) @ paul(0.3, 0, 0.1, 1.5 - values[0]) @ paul(0.1, 0.2, 0, -values[1])
        np.testing.assert_allclose(frame, expected, atol=1e-15)
    assert_matrix_is_that_of_differences(made, q[0])
    # A of the blocks, joint by joint, is A of the engine
    answer = made.predict(q, np.zeros(made.n_parameters))
    np.testing.assert_allclose(made.error_matrix(q), answer.matrix, atol=1e-15)


def differences(arm, q, frame="base", offset=(0, 0, 0)):
    """A by central differences of the product of Eq. (4.1), each parameter of each link moved by itself."""
    links = np.array([[x.a, x.alpha, x.d, x.theta, x.beta] for x in arm.links])
    # theta and d with the joint values in: told by where a table without joints would be
    placed, value = links.copy(), iter(placed_values(arm, q))
    for i, link in enumerate(arm.links):
        if link.joint != "fixed":
            placed[i, 3 if link.joint == "revolute" else 2] += next(value)
    point = np.array([*offset, 1.0])

    def tool(changed):
        product = np.eye(4)
        for row in changed:
            product = product @ paul(*row)
        return product

    meant, columns = tool(placed), []
    for parameter in arm.parameters:
        at = ("a", "alpha", "d", "theta", "beta").index(parameter.name)
        step = 1e-6 * (1 if parameter.unit == "rad" else max(1.0, abs(placed).max()))
        frames = []
        for sign in (1, -1):
            moved = placed.copy()
            moved[parameter.link, at] += sign * step
            frames.append(tool(moved))
        motion = (frames[0] - frames[1]) / (2 * step)
        turned = motion[:3, :3] @ meant[:3, :3].T
        columns.append([*(motion @ point)[:3], turned[2, 1], turned[0, 2], turned[1, 0]])
    matrix = np.array(columns).T
    if frame == "tool":
        matrix = np.vstack([meant[:3, :3].T @ matrix[:3], meant[:3, :3].T @ matrix[3:]])
    return matrix


def placed_values(arm, q):
    """What is added to theta or d: q itself, but for the arm above, whose second joint follows the first."""
    return [q[0], 1.5 - q[0], -q[1]] if arm.n_joints == 2 and arm.n_links == 3 else q


def assert_matrix_is_that_of_differences(arm, q, **how):
    offset = how.get("tool_offset", (0, 0, 0))
    found = arm.error_matrix(q, **how)
    expected = differences(arm, q, how.get("frame", "base"), offset)
    assert found.shape == expected.shape == (6, arm.n_parameters)
    scale = np.abs(expected).max(axis=1, keepdims=True) + 1
    np.testing.assert_allclose(found / scale, expected / scale, atol=2e-9)


def test_the_error_matrix_is_the_derivative(arm, random):
    for q in random.uniform(-1, 1, (4, arm.n_joints)):
        assert_matrix_is_that_of_differences(arm, q)
        assert_matrix_is_that_of_differences(arm, q, frame="tool", tool_offset=(3, -20, 50))


@pytest.mark.parametrize("count", [0, 1, 7, 8, 9, 63, 64, 65, 200])
def test_a_pose_gives_the_same_bits_in_any_place(puma, random, count):
    q = random.uniform(-3, 3, (count, 6))
    together = puma.error_matrix(q)
    assert together.shape == (count, 6, puma.n_parameters)
    for alone, matrix in zip(q, together):
        assert puma.error_matrix(alone).tobytes() == matrix.tobytes()
    assert puma.forward(q).shape == (count, 4, 4)


def test_leading_axes_stay(puma, random):
    q = random.uniform(-1, 1, (2, 3, 6))
    assert puma.forward(q).shape == (2, 3, 4, 4)
    assert puma.error_matrix(q).shape == (2, 3, 6, puma.n_parameters)
    np.testing.assert_array_equal(puma.error_matrix(q)[1, 2], puma.error_matrix(q[1, 2]))
    np.testing.assert_array_equal(puma.forward(q[:, ::2])[1, 1], puma.forward(q[1, 2]))


def test_out_is_written_and_returned(puma, random):
    q = random.uniform(-1, 1, (5, 6))
    matrices, frames = np.full((5, 6, puma.n_parameters), np.nan), np.full((5, 4, 4), np.nan)
    assert puma.error_matrix(q, out=matrices) is matrices
    assert puma.forward(q, out=frames) is frames
    np.testing.assert_array_equal(matrices, puma.error_matrix(q))
    np.testing.assert_array_equal(frames, puma.forward(q))


def test_the_tool_offset_moves_the_point(puma):
    q = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6]
    meant = puma.forward(q)
    moved = puma.forward(q, tool_offset=[1, 2, 3])
    np.testing.assert_allclose(moved[:3, 3], (meant @ [1, 2, 3, 1])[:3], atol=1e-12)
    np.testing.assert_array_equal(moved[:3, :3], meant[:3, :3])


def test_integers_and_float32_are_numbers(puma):
    np.testing.assert_array_equal(puma.forward([0, 1, 0, -1, 0, 1]), puma.forward([0.0, 1.0, 0.0, -1.0, 0.0, 1.0]))
    np.testing.assert_array_equal(puma.forward(np.float32([0.5] * 6)), puma.forward([0.5] * 6))


# ---- files ----


def test_a_table(source):
    crane = Arm.from_table(source / "golden/armtol/crane.csv")
    assert (crane.name, crane.unit, crane.n_joints) == ("crane", "mm", 2)
    assert crane.title == "Column crane, #2"
    assert crane.source == "drawing 17, sheet 3"


def test_a_urdf_by_base_and_tip(source):
    panda = Arm.from_urdf(source / "tests/armtol/panda.urdf", "panda_link0", "panda_link7")
    assert (panda.unit, panda.n_joints) == ("m", 7)
    assert np.isfinite(panda.limits).all()


def test_links_have_names(source):
    """That of the joint in a URDF, and those of a table's column, which lists may use."""
    panda = Arm.from_urdf(source / "tests/armtol/panda.urdf", tip="panda_link7")
    assert panda.names[:2] == ["panda_joint1", "panda_joint2"]
    row = {"joint": "theta", "a": 1, "alpha": 0, "d": 0, "theta": 0}
    named = Arm.from_dh([{**row, "name": "upper"}, {**row, "name": "fore, arm"}, row])
    assert named.names == ["upper", "fore, arm", None]
    assert pickle.loads(pickle.dumps(named)).names == named.names
    answer = named.allocate([0, 1, 0], [0.1] * 6, weights={"upper.motors": 2})
    assert (
        answer.tolerances.tobytes()
        == named.allocate([0, 1, 0], [0.1] * 6, weights={"0.motors": 2}).tolerances.tobytes()
    )
    assert Arm.from_dh(ROWS).names == [None] * 4


def test_frames_far_off_are_laid_anew_unless_they_are_to_stay(source):
    far = source / "golden/armtol/far.csv"
    assert Arm.from_table(far).links != Arm.from_table(far, as_is=True).links


def test_copies_are_the_same_to_the_bit(arm, source):
    level = Arm.from_table(source / "golden/armtol/level.csv")
    far = Arm.from_table(source / "golden/armtol/far.csv", as_is=True)
    for one in (arm, level, far):
        for other in (pickle.loads(pickle.dumps(one)), copy.deepcopy(one), Arm.from_text(one.table(), as_is=True)):
            assert other.table() == one.table()
            assert other.links == one.links
            np.testing.assert_array_equal(other.limits, one.limits)


def test_the_craig_table_is_the_same_arm(arm, random):
    other = Arm.from_text(arm.table("craig"))
    q = random.uniform(-1, 1, (5, arm.n_joints))
    np.testing.assert_allclose(other.forward(q), arm.forward(q), atol=1e-10)


def test_builtin_arms_are_those_of_the_program(source):
    listed = (source / "golden/armtol/list-json").read_text()
    assert len(armtol.builtin_arms()) == 8
    assert all(f'"{name}"' in listed for name in armtol.builtin_arms())


# ---- what is wrong ----


@pytest.mark.parametrize(
    ("wrong", "error", "message"),
    [
        (lambda arm: arm.forward([0] * 5), ValueError, r"q: shape \(5,\), expected \(..., 6\)"),
        (lambda arm: arm.forward(1.0), ValueError, r"q: shape \(\)"),
        (lambda arm: arm.error_matrix(np.zeros((2, 7))), ValueError, r"q: shape \(2, 7\)"),
        (lambda arm: arm.forward(["a"] * 6), TypeError, "no type of real numbers"),
        (lambda arm: arm.forward([1j] * 6), TypeError, "complex128 is no type of real numbers"),
        (lambda arm: arm.forward([None] * 6), TypeError, "object is no type"),
        (lambda arm: arm.forward([0, 0, np.nan, 0, 0, 0]), ArmtolError, "pose 0: a value is not finite"),
        (lambda arm: arm.forward([[0] * 6, [np.inf] * 6]), ArmtolError, "pose 1: a value is not finite"),
        (lambda arm: arm.error_matrix([[0] * 6] * 70 + [[np.inf] * 6]), ArmtolError, "pose 70: a value is not finite"),
        (
            lambda arm: arm.error_matrix([0] * 6, frame="world"),
            ValueError,
            "frame: 'world', expected 'base' or 'tool'",
        ),
        (
            lambda arm: arm.error_matrix([0] * 6, tool_offset=[1, 2]),
            ValueError,
            r"tool_offset: shape \(2,\), expected \(3,\)",
        ),
        (lambda arm: arm.error_matrix([0] * 6, tool_offset=[1, 2, np.nan]), ArmtolError, "not finite"),
        (
            lambda arm: arm.forward([0] * 6, tool_offset=[1, 2, np.inf]),
            ArmtolError,
            "tool_offset: a value is not finite",
        ),
        (
            lambda arm: arm.forward([0] * 6, out=np.zeros((3, 4))),
            ValueError,
            r"out: shape \(3, 4\), expected \(4, 4\)",
        ),
        (
            lambda arm: arm.forward([0] * 6, out=np.zeros((4, 4), np.float32)),
            TypeError,
            "out: expected a numpy array of float64",
        ),
        (lambda arm: arm.forward([0] * 6, out=[[0] * 4] * 4), TypeError, "out: expected a numpy array"),
        (lambda arm: arm.forward([0] * 6, out=np.zeros((4, 4)).T), ValueError, "C-contiguous"),
        (lambda arm: arm.forward([0] * 6, out=np.broadcast_to(0.0, (4, 4))), ValueError, "out:"),
        (lambda arm: Arm.builtin("puma"), ArmtolError, "'puma' is no built-in arm; there are .*puma560"),
        (lambda arm: Arm.builtin(3), TypeError, "name"),
        (lambda arm: Arm.from_dh(ROWS, "denavit"), ArmtolError, "rows:1:8: .*denavit"),
        (lambda arm: Arm.from_dh(ROWS, unit="feet"), ArmtolError, "rows:2:.*feet"),
        (lambda arm: Arm.from_dh(ROWS[:, :3]), ValueError, r"rows: shape \(4, 3\), expected \(n, 4\)"),
        (lambda arm: Arm.from_dh(ROWS, joints="RR"), ValueError, "joints: 'RR', expected a letter for each of 4 rows"),
        (lambda arm: Arm.from_dh(ROWS, joints="RRRX"), ValueError, "joints: 'RRRX'"),
        (lambda arm: Arm.from_dh(ROWS * np.nan), ArmtolError, "rows:5:.*nan"),
        (lambda arm: Arm.from_dh([{"joint": "theta", "a": 1}]), ArmtolError, "alpha"),
        (lambda arm: Arm.from_dh([{"joint": "a\nb"}]), ValueError, "more than a line"),
        (lambda arm: Arm.from_dh(np.zeros((0, 4))), ArmtolError, "rows"),
        (lambda arm: Arm.from_text(""), ArmtolError, "text"),
        (lambda arm: Arm.from_text(b"units: m rad"), TypeError, "expected a text"),
        (lambda arm: Arm.from_text("x", where="a\0b"), ValueError, "null"),
        (lambda arm: Arm.from_table("/nowhere/arm.csv"), FileNotFoundError, "nowhere"),
        (lambda arm: Arm.from_table("/"), IsADirectoryError, "directory"),
        (lambda arm: arm.table("denavit"), ValueError, "convention: 'denavit'"),
    ],
)
def test_what_is_wrong_is_said(puma, wrong, error, message):
    with pytest.raises(error, match=message):
        wrong(puma)


def test_a_urdf_that_ends_twice_is_told_its_tips(source):
    with pytest.raises(ArmtolError, match='with tip: "panda_leftfinger"'):
        Arm.from_urdf(source / "tests/armtol/panda.urdf")
    with pytest.raises(ArmtolError, match="nothing"):
        Arm.from_urdf(source / "tests/armtol/panda.urdf", tip="nothing")
    with pytest.raises(ArmtolError, match="base and tip are for URDF files"):
        Arm.from_urdf(source / "golden/armtol/crane.csv", tip="hook")
    with pytest.raises(ValueError, match="snap"):
        Arm.from_urdf(source / "tests/armtol/panda.urdf", tip="panda_link7", snap=0.1)


def test_out_that_is_q_too_is_refused():
    one = Arm.from_dh([[0, 0, 0, 0]] * 16)
    memory = np.zeros(16)
    with pytest.raises(ValueError, match="shares memory"):
        one.forward(memory, out=memory.reshape(4, 4))
