"""Regions: what is proved there, against poses drawn from it, a closed form, and what the program printed."""

import json
import math
import os
import signal
import threading

import numpy as np
import pytest

from armtol import Arm, ArmtolError

WHERE = "q1=-1..1;q2=-2..-0.5;q3=0.5..2;q4=0..1;q5=0.5..1;q6=0..1"
LOW, HIGH = np.array([[-1, 1], [-2, -0.5], [0.5, 2], [0, 1], [0.5, 1], [0, 1]]).T
BLOCK = "q4=0..0;q5=0.5..0.5;q6=0..0;box=300..500,-100..100,0..300"


def errors(arm, q, tolerances):
    return np.abs(arm.error_matrix(q)) @ tolerances


def test_tolerances_hold_everywhere_in_it(puma, random):
    region = puma.region(WHERE, [1.0, 1.0, 1.0, None, None, None], gap=0.2, ignore_limits=True)
    tolerances = np.where(np.isfinite(region.tolerances), region.tolerances, 0)
    drawn = errors(puma, random.uniform(LOW, HIGH, (20_000, 6)), tolerances)[:, :3]
    assert region.ended == "gap"
    assert [x.name for x in region.enclosures] == ["dx", "dy", "dz"]
    for i, enclosure in enumerate(region.enclosures):
        assert drawn[:, i].max() <= enclosure.high <= enclosure.accuracy * (1 + 1e-9)
        np.testing.assert_allclose(errors(puma, enclosure.q, tolerances)[i], enclosure.low, rtol=1e-9)
        assert (enclosure.q >= LOW - 1e-9).all() and (enclosure.q <= HIGH + 1e-9).all()


def test_a_closed_form():
    """Two links in a plane, stretched, turning by more than a half: dx is (a + b) t + b t where the arm is along y."""
    arm = Arm.from_dh([[400, 0, 0, 0], [300, 0, 0, 0]])
    region = arm.region("q1=-3..3;q2=0..0", tolerances={"motors": 1e-3}, gap=1e-4)
    for enclosure in region.enclosures[:2]:
        assert 1.0 * (1 - 1.1e-4) <= enclosure.low <= 1.0 <= enclosure.high <= 1.0 * (1 + 1.1e-4)


def test_loads_bend_the_drives():
    """A link that turns in the plane its weight is in droops by c m g l cos q, and l cos q of that along gravity."""
    arm = Arm.from_dh([[0, math.pi / 2, 0, 0], [400, 0, 0, 0]])
    drives, droop = {"1.compliance": 1e-5}, 1e-5 * 5 * 9.80665 * 0.4 * 400 * math.cos(0.3) ** 2
    region = arm.region("q1=-3..3;q2=0.3..1", tolerances={"lengths": 0}, drives=drives, payloads=[2, 5])
    dz = region.enclosures[2]
    assert dz.name == "dz" and droop / 1.011 <= dz.low <= droop * (1 + 1e-9) and dz.high >= droop * (1 - 1e-9)
    np.testing.assert_allclose(np.abs(arm.predict([0, 0.3], {"lengths": 0}, drives=drives, payloads=[5]).sag[..., 2]),
                               droop, rtol=1e-4)


def test_given_tolerances_in_a_block(puma):
    region = puma.region(BLOCK, tolerances={"lengths": 0.01, "angles": 1e-5}, gap=0.5, ignore_limits=True)
    assert len(region.enclosures) == 6 and np.isinf([x.accuracy for x in region.enclosures]).all()
    at = puma.forward(region.q)[:, :3, 3]
    assert (at >= [300 - 1e-5, -100 - 1e-5, -1e-5]).all() and (at <= [500 + 1e-5, 100 + 1e-5, 300 + 1e-5]).all()
    assert len(region.to_frame()) == 6 and "<table>" in region._repr_html_()
    assert repr(region) == "<armtol.Region: puma560, 6 enclosures, ended by gap>"


def test_the_same_as_the_program(source):
    expected = json.loads((source / "golden/armtol/scara-region-json").read_text())
    where = expected["region"]["asked"]
    for degrees in ("-30..30", "20..100"):
        low, high = (float(x) * math.pi / 180 for x in degrees.split(".."))
        where = where.replace(degrees, f"{low!r}..{high!r}")
    scara = Arm.builtin("scara")
    region = scara.region(where, [0.02, 0.02, None, None, None, 0.01 * math.pi / 180], method="rss")
    shown = [t * 180 / math.pi if x.unit == "rad" else t for t, x in zip(region.tolerances, scara.parameters)]
    assert [t if math.isfinite(t) else None for t in shown] == [x["tolerance"] for x in expected["parameters"]]
    for enclosure, wanted in zip(region.enclosures, expected["region"]["errors"], strict=True):
        scale = (lambda x: x * 180 / math.pi) if enclosure.name == "wz" else float
        assert (enclosure.name, scale(enclosure.low), scale(enclosure.high), enclosure.ended) == (
            wanted["name"], wanted["found"], wanted["bound"], wanted["ended_by"])  # fmt: skip
    assert region.n_worst == expected["region"]["worst_poses"]
    assert scara.forward(region.q)[:, :3, 3].tolist() == [x["tool"] for x in expected["poses"]]


def test_a_file_of_words_and_norms(source):
    region = Arm.builtin("scara").region(str(source / "golden/armtol/annulus.region"), {"xy": 0.02})
    assert [x.name for x in region.enclosures] == ["xy"]
    assert region.enclosures[0].high <= 0.02 * (1 + 1e-9)
    assert region.answer.verify(1000).within == 1000


def test_it_may_be_ended(puma):
    told = []

    def progress(still_open, boxes):
        told.append((still_open, boxes))
        return False

    region = puma.region(WHERE, tolerances={"lengths": 0.01}, gap=1e-6, ignore_limits=True, progress=progress)
    assert told and region.ended == "caller"
    few = puma.region(WHERE, tolerances={"angles": 1e-4}, gap=1e-6, most=1000, ignore_limits=True)
    assert few.ended == "most"


def test_what_progress_raises_is_raised(puma):
    def progress(still_open, boxes):
        raise KeyError("mine")

    with pytest.raises(KeyError, match="mine"):
        puma.region(WHERE, tolerances={"lengths": 0.01}, gap=1e-6, ignore_limits=True, progress=progress)


def test_ctrl_c_ends_it(puma):
    wide = "q1=-3..3;q2=-2..2;q3=-2..2;q4=-3..3;q5=-2..2;q6=-3..3"
    options = {"tolerances": {"angles": 1e-4}, "gap": 1e-6, "most": 10**9, "ignore_limits": True}
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        threading.Timer(0.2, os.kill, (os.getpid(), signal.SIGINT)).start()
        with pytest.raises(KeyboardInterrupt):
            puma.region(wide, {"r": 1.0, "w": 1.0}, **options)
    finally:
        signal.signal(signal.SIGINT, before)


@pytest.mark.parametrize(
    ("where", "options", "message"),
    [
        ("q9=0..1", {}, "region: .*q9"),
        ("box=1..2", {}, "region"),
        ("q1=2..1", {}, "region"),
        ("box=9000..9001,0..1,0..1", {}, "region: no pose is in it"),
        (WHERE, {"gap": 99}, "region: gap"),
        (WHERE, {"method": "sphere"}, "region: method sphere is for poses"),
    ],
)
def test_wrong_regions(puma, where, options, message):
    with pytest.raises(ArmtolError, match=message):
        puma.region(where, [1.0] * 6, ignore_limits=True, **options)


def test_numbers_out_of_range(puma):
    with pytest.raises(ValueError, match="most"):
        puma.region(WHERE, [1.0] * 6, most=-1)
    with pytest.raises(ValueError, match="null"):
        puma.region("q1=0..1\0", [1.0] * 6)
