"""Maps: against the closed form of two links, an answer a point, and what the program printed."""

import json
import math
import os
import signal
import threading

import matplotlib
import numpy as np
import pytest

from armtol import Arm, ArmtolError

matplotlib.use("Agg")

A, B = 0.4, 0.3


@pytest.fixture
def planar():
    return Arm.from_dh([[A, 0, 0, 0], [B, 0, 0, 0]], unit="m")


def test_the_worst_case_of_two_links(planar):
    """dx is |y| t1 + |B sin(q1 + q2)| t2, and dy likewise."""
    found = planar.map("xy", (-0.8, 0.8), (-0.7, 0.8), grid=(17, 11), tolerances={"1.theta": 1e-3, "0.theta": 2e-3})
    x, y = found.points[..., 0], found.points[..., 1]
    assert found.values.shape == (11, 17) and found.unit == "m"
    far = np.hypot(x, y)
    assert found.reached[(far < 0.65) & (far > 0.15)].all()
    assert not found.reached[(far > A + B + 1e-9) | (far < A - B - 1e-9)].any()
    q1, q2 = found.q[..., 0], found.q[..., 1]
    np.testing.assert_allclose(A * np.cos(q1) + B * np.cos(q1 + q2), np.where(found.reached, x, np.nan), atol=1e-9)
    dx = np.abs(y) * 2e-3 + np.abs(B * np.sin(q1 + q2)) * 1e-3
    dy = np.abs(x) * 2e-3 + np.abs(B * np.cos(q1 + q2)) * 1e-3
    np.testing.assert_allclose(found.values, np.where(found.reached, np.hypot(dx, dy), np.nan), rtol=1e-7)
    assert np.isnan(found.values[~found.reached]).all()
    assert not (found.joined_across & ~found.reached).any() and not (found.joined_up & ~found.reached).any()


def test_of_a_component_and_of_tolerances(planar):
    options = {"grid": (5, 5), "near": [0.3, 1.0]}
    found = planar.map("xy", (0.2, 0.5), (0.2, 0.4), what="tolerance", of="1.theta", accuracy=[1e-3] * 6, **options)
    alone = [planar.allocate(q, [1e-3] * 6).tolerances for q in found.q[found.reached]]
    k = [(x.link, x.name) for x in planar.parameters].index((1, "theta"))
    np.testing.assert_allclose(found.values[found.reached], [x[k] for x in alone], rtol=1e-9)
    turned = planar.map("xy", (0.2, 0.5), (0.2, 0.4), of="wz", tolerances={"motors": 1e-3}, **options)
    np.testing.assert_allclose(turned.values[turned.reached], 2e-3, rtol=1e-12)
    assert turned.unit == "rad"


def test_droop_is_that_of_the_program(source):
    level = Arm.from_table(source / "golden/armtol/level.csv")
    found = level.map("xz", (-0.8, 0.8), (-0.2, 0.8), grid=(9, 6), what="droop", payloads=[0, 5])
    lines = (source / "golden/armtol/map-level-tsv").read_text().splitlines()[2:]
    rows = [[math.nan if x == "-" else float(x) for x in line.split("\t")] for line in lines]
    frame = found.to_frame().to_numpy()
    np.testing.assert_allclose(frame[:, :3], [row[:3] for row in rows], atol=1e-15)  # the program shows them as typed
    shown = [[droop, *(x * 180 / math.pi for x in q)] for droop, *q in frame[:, 3:]]
    np.testing.assert_array_equal(shown, [row[4:] for row in rows])
    marks = found.reached + 2 * found.joined_across + 4 * found.joined_up
    assert marks.ravel().tolist() == [row[3] for row in rows]


def test_tolerances_are_those_of_the_program(source):
    expected = json.loads((source / "golden/armtol/map-puma560-json").read_text())
    puma, near = Arm.builtin("puma560"), [x * math.pi / 180 for x in (0, 45, -90, 0, 45, 0)]
    accuracy = [0.5, 0.5, 0.5] + [0.01 * math.pi / 180] * 3
    found = puma.map("xz", (-800, 800), (-400, 800), grid=(9, 7), what="tolerance", of="angles", near=near,
                     axes=puma.forward(near)[:3, :3], accuracy=accuracy)  # fmt: skip
    shown = [[None if math.isnan(x) else x * 180 / math.pi for x in row] for row in found.values]
    assert shown == expected["values"]
    assert found.reached.sum() == expected["reached"]


def test_it_is_drawn(planar):
    found = planar.map("xy", (-0.8, 0.8), (-0.8, 0.8), grid=(9, 9), tolerances={"motors": 1e-3})
    axes = found.plot()
    drawn = axes.collections[0].get_array()
    np.testing.assert_array_equal(drawn.filled(np.nan), found.values)
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("x, m", "y, m")
    assert axes.figure.axes[1].get_ylabel() == "worst of position, m"
    assert found.plot(axes) is axes
    assert repr(found) == f"<armtol.Map: worst of position, arm, {found.reached.sum()} of 81 points>"


def test_progress_may_end_it(planar):
    plane, options = ("xy", (-0.8, 0.8), (-0.8, 0.8)), {"tolerances": {"motors": 1e-3}}
    told = []
    whole = planar.map(*plane, progress=lambda done, total: told.append((done, total)), **options)
    part = planar.map(*plane, progress=lambda done, total: done < total // 4, **options)
    assert told and all(total == 61 * 61 for _, total in told)
    assert 0 < part.reached.sum() < whole.reached.sum()
    with pytest.raises(ZeroDivisionError):
        planar.map(*plane, progress=lambda done, total: 1 // 0, **options)


def test_ctrl_c_ends_it():
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT)).start()
        with pytest.raises(KeyboardInterrupt):
            Arm.builtin("panda").map("xz", (0, 850), (-300, 1150), grid=(2000, 2000), tolerances={"motors": 1e-3})
    finally:
        signal.signal(signal.SIGINT, before)


@pytest.mark.parametrize(
    ("changed", "message"),
    [
        ({"plane": "zx"}, "plane: 'zx', expected one of xy, xz, yz"),
        ({"across": (1, 0)}, "across: 1.0 to 0.0"),
        ({"up": (0, np.inf)}, "up: "),
        ({"grid": (1, 5)}, "grid: 1, 5"),
        ({"axes": np.ones((3, 3))}, "axes: expected axes"),
        ({"near": [np.nan, 0]}, "not finite"),
        ({"what": "price"}, "what: 'price'"),
        ({"of": "dw"}, "of: 'dw'"),
        ({"tolerances": None}, "tolerances: expected"),
        ({"what": "tolerance"}, "accuracy: expected"),
        ({"what": "tolerance", "of": "lengths,angles"}, "has lengths and angles"),
        ({"tolerances": [1.0]}, "tolerances: shape"),
        ({"tolerances": [-1.0] * 8}, "tolerances, column 0"),
    ],
)
def test_wrong_maps(planar, changed, message):
    wish = {"plane": "xy", "across": (0, 1), "up": (0, 1), "grid": (3, 3), "tolerances": {"motors": 1e-3}, **changed}
    with pytest.raises(ValueError, match=message):
        planar.map(**wish)


def test_names_that_nothing_has(planar):
    with pytest.raises(ArmtolError, match="^of: .*elbows"):
        planar.map("xy", (0, 1), (0, 1), what="tolerance", of="elbows", accuracy=[1.0] * 6)
