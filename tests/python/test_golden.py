"""The same bits as the C program: golden/armtol, what `armtol --json` printed, held against the package.

The file's numbers read back as the doubles that they were; those in degrees are the radians' by one product and one
quotient, which Python does as C.
"""

import csv
import json
import math
import shlex

import numpy as np
import pytest

from armtol import Arm

NAMES = ["adeptone-json", "puma560-rss-json", "scara-sphere-json", "panda-poses-json", "crane-json", "ur5e-made-json",
         "level-loads-json", "far-json"]  # fmt: skip


def command(source, name):
    for line in (source / "golden/armtol/commands").read_text().splitlines():
        if line.startswith(f"{name}:"):
            return shlex.split(line.partition(":")[2])
    raise AssertionError(name)


def options_of(words):
    options = {"payload": []}
    words = iter(words)
    for word in words:
        key = word.removeprefix("--")
        if key in ("json", "degrees", "budget"):
            options[key] = True
        elif key == "payload":
            options[key].append([float(x) for x in next(words).split(",")])
        else:
            options[key] = next(words)
    return options


class Golden:
    """A golden question, asked by the package: numbers as the command line types them."""

    def __init__(self, source, name):
        self.folder = source / "golden/armtol"
        self.expected = json.loads((self.folder / name).read_text())
        first, *rest = command(source, name)
        self.options = options_of(rest)
        self.arm = Arm.from_table(self.folder / first) if first.endswith(".csv") else Arm.builtin(first)
        self.degrees = self.expected["units"]["angle"] == "deg"
        assert self.expected["units"]["length"] == self.arm.unit

    def taken(self, value, is_angle):
        return value * math.pi / 180 if is_angle and self.degrees else value

    def shown(self, value, is_angle):
        return value * 180 / math.pi if is_angle and self.degrees else value

    def components(self, values):
        return [self.shown(value, i >= 3) for i, value in enumerate(values)]

    def q(self):
        if "poses" in self.options:
            text = (self.folder / self.options["poses"]).read_text().splitlines()
            lines = [line.partition("#")[0].replace(",", " ").split() for line in text]
            rows = [[float(x) for x in line] for line in lines if line]
        else:
            rows = [[float(x) for x in self.options["joints"].split(",")]]
        turning = [link.joint == "revolute" for link in self.arm.links if link.joint != "fixed"]
        return [[self.taken(x, turns) for x, turns in zip(row, turning)] for row in rows]

    def accuracy(self):
        words = self.options["accuracy"].split(",")
        return [None if x == "-" else self.taken(float(x), i >= 3) for i, x in enumerate(words)]

    def arguments(self):
        options = self.options
        chosen = {
            "accuracy": self.accuracy(),
            "method": options.get("method", "worst"),
            "frame": options.get("frame", "base"),
        }
        if "tool-offset" in options:
            chosen["tool_offset"] = [float(x) for x in options["tool-offset"].split(",")]
        if options["payload"]:
            chosen["payloads"] = options["payload"]
        if "force" in options:
            chosen["force"] = [float(x) for x in options["force"].split(",")]
        if "compensated" in options:
            chosen["compensated"] = float(options["compensated"])
        return chosen

    def answer(self):
        if "tolerances" not in self.options:
            return self.arm.allocate(self.q(), **self.arguments())
        with (self.folder / self.options["tolerances"]).open() as file:
            table = {(row["link"], row["parameter"]): row for row in csv.DictReader(file)}
        rows = [table[str(x.link), x.name] for x in self.arm.parameters]
        return self.arm.predict(
            self.q(), [self.taken(float(x["tolerance"]), x["unit"] == "deg") for x in rows], **self.arguments()
        )


def same(found, expected):
    """As doubles; null is what has no bound."""
    return [None if not math.isfinite(x) else float(x) for x in found] == expected


@pytest.fixture(params=NAMES)
def golden(request, source):
    return Golden(source, request.param)


def test_the_answer_is_that_of_the_program(golden):
    answer, expected = golden.answer(), golden.expected
    found = [golden.shown(t, x.unit == "rad") for t, x in zip(answer.tolerances, answer.parameters)]
    assert same(found, [x["tolerance"] for x in expected["parameters"]])
    assert [(x.link, x.name, x.role) for x in answer.parameters] == [
        (x["link"], x["parameter"], x["role"]) for x in expected["parameters"]
    ]
    for key, name in (
        ("worst", "worst_case"),
        ("deviation", "standard_deviation"),
        ("remainder", "remainder"),
        ("shift", "load"),
    ):
        values = golden.components([getattr(x, key) for x in answer.components])
        assert same(values, [x[name] for x in expected["components"]])
    assert same([x.binds for x in answer.components], [x["binds"] for x in expected["components"]])
    turning = [link.joint != "prismatic" for link in golden.arm.links]
    for part, wanted in zip(answer.parts, expected["parts"], strict=True):
        for key in ("distance", "angle", "motor", "drive"):
            value = getattr(part, key)
            is_angle = key == "angle" or (key != "distance" and turning[part.link])
            assert (key not in wanted) == math.isnan(value)
            assert key not in wanted or same([golden.shown(value, is_angle)], [wanted[key]])
    if expected["method"] == "sphere":
        bounds = [answer.delta, answer.bounds[0], golden.shown(answer.bounds[1], True)]
        assert bounds == [expected["delta"], expected["distance_bound"], expected["angle_bound"]]


def test_where_the_tool_is(golden):
    offset = golden.arguments().get("tool_offset")
    frames = golden.arm.forward(golden.q(), tool_offset=offset)
    assert frames[:, :3, 3].tolist() == [pose["tool"] for pose in golden.expected["poses"]]


def test_the_matrix_is_that_of_the_answer(golden):
    """To the bit, but for what rounding left of a 0."""
    arguments = golden.arguments()
    matrix = golden.arm.error_matrix(golden.q(), frame=arguments["frame"], tool_offset=arguments.get("tool_offset"))
    cleared = golden.answer().matrix
    kept = cleared != 0
    assert kept.mean() > 0.2
    assert (matrix[kept] == cleared[kept]).all()
    assert np.abs(matrix[~kept]).max(initial=0) < 1e-9


def test_loads_budget_and_verification(golden):
    answer, expected = golden.answer(), golden.expected
    for place, wanted in enumerate(expected.get("loads", ())):
        pose, load = wanted["pose"] - 1, wanted["load"] - 1
        assert place == pose * answer.sag.shape[1] + load
        assert golden.components(answer.sag[pose, load]) == wanted["droop"]
        assert [answer.moments[pose, load, x["link"]] for x in wanted["joints"]] == [
            x["moment"] for x in wanted["joints"]
        ]
    if "budget" in expected:
        rows = answer.budget.rows
        assert [(x.link, x.role, list(x[2:])) for x in rows] == [
            (x["link"], x["role"], x["shares"]) for x in expected["budget"]
        ]
    if "verification" in expected:
        wanted = expected["verification"]
        found = answer.verify(wanted["asked"], wanted["seed"])
        assert (found.drawn, found.within, found.beyond) == (wanted["drawn"], wanted["within"], wanted["beyond"])
        assert list(found.share_95) == wanted["share_95"]
        for i, component in enumerate(wanted["components"]):
            assert same([golden.shown(x, i >= 3) for x in found.quantiles[i]], component["quantiles"])
            assert same([golden.shown(found.worst_drawn[i], i >= 3)], [component["worst_drawn"]])
            assert same([golden.shown(found.worst_corner[i], i >= 3)], [component["worst_corner"]])
            assert component["worst_drawn"] is None or found.worst_arm[i] == component["worst_arm"]


def test_sag_alone_is_that_of_the_answer(source):
    golden = Golden(source, "level-loads-json")
    chosen = {key: golden.arguments()[key] for key in ("payloads", "force", "compensated")}
    sag = golden.arm.sag(golden.q()[0], **chosen)
    assert sag.shape == (2, 6)
    assert [golden.components(row) for row in sag] == [x["droop"] for x in golden.expected["loads"]]
