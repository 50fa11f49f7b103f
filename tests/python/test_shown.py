"""What notebooks show: HTML, data frames, plots."""

import html.parser

import matplotlib
import numpy as np
import pytest

import armtol

matplotlib.use("Agg")

Q = [0.0, 0.8, -1.6, 0.0, 0.8, 0.0]


class Cells(html.parser.HTMLParser):
    def __init__(self, text):
        super().__init__()
        self.rows, self.open = [], []
        self.feed(text)
        self.close()
        assert self.open == []

    def handle_starttag(self, tag, attributes):
        self.open.append(tag)
        if tag == "tr":
            self.rows.append([])
        if tag in ("td", "th"):
            self.rows[-1].append("")

    def handle_endtag(self, tag):
        assert self.open.pop() == tag

    def handle_data(self, data):
        if self.open[-1] in ("td", "th"):
            self.rows[-1][-1] += data


@pytest.fixture(scope="module")
def answer():
    return armtol.Arm.builtin("puma560").allocate(Q, [0.5, 0.5, 0.5, 2e-4, 2e-4, 2e-4])


def test_html_has_a_row_for_each(answer):
    rows = Cells(answer._repr_html_()).rows
    assert len(rows) == 1 + 24 + 1 + 6
    assert rows[1][:5] == ["0", "theta", "motor", "rad", f"{answer.tolerances[0]:.6g}"]
    assert len(Cells(answer.budget._repr_html_()).rows) == 1 + len(answer.budget.rows)
    assert len(Cells(answer.verify(1000)._repr_html_()).rows) == 1 + 6
    assert len(Cells(answer.arm._repr_html_()).rows) == 1 + 6
    run = armtol.hahn1987.adpta((200, 200, 0, 0), (0.5, 0.5, 0.5, 0.1, 0.1, 0.1), 0.1)
    assert len(Cells(run._repr_html_()).rows) == 1 + 6 + 4 + 2
    assert len(Cells(armtol.hahn1987.reproduce()._repr_html_()).rows) == 1 + 66


def test_html_is_escaped():
    arm = armtol.Arm.from_dh([[1, 0, 0, 0]], name="<b>&")
    assert "<b>" not in arm._repr_html_()
    assert "&lt;b&gt;&amp;" in arm._repr_html_()


def test_frames_hold_the_numbers(answer):
    frame = answer.to_frame()
    assert frame["tolerance"].tolist() == answer.tolerances.tolist()
    assert set(frame["set by"]) == {"accuracy"}
    assert answer.budget.to_frame()["dx"].sum() == pytest.approx(1)
    found = answer.verify(1000)
    assert found.to_frame()["50 %"].tolist() == found.quantiles[:, 0].tolist()
    run = armtol.hahn1987.adpta((200, 200, 0, 0), (0.5, 0.5, 0.5, 0.1, 0.1, 0.1), 0.1)
    assert run.to_frame()["rd"].tolist() == run.machining.tolist()
    assert (armtol.hahn1987.reproduce().to_frame()["verdict"].str.startswith("agrees")).all()


def test_plots_draw_the_numbers(answer):
    widths = [bar.get_width() for bar in answer.plot().patches]
    assert sorted(widths) == sorted(answer.tolerances)
    heights = [bar.get_height() for bar in answer.budget.plot().patches]
    assert sum(heights) == pytest.approx(6)
    found = answer.verify(1000)
    axes = found.plot()
    np.testing.assert_array_equal(axes.lines[0].get_ydata(), found.quantiles[:, 0] / answer.accuracy)
    assert answer.plot(axes) is axes


def test_texts(answer):
    assert repr(answer) == "<armtol.Answer: puma560, worst, 1 poses, 24 tolerances>"
    assert repr(answer.arm) == "<armtol.Arm puma560: 6 links, 6 joints, mm>"
    assert repr(answer.verify(10)) == "<armtol.Verification: 10 of 10 arms are within the accuracy>"
    assert repr(armtol.hahn1987.reproduce()) == "<66 of 66 published numbers reproduced>"
