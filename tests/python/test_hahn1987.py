"""The programs of 1987: the paper's numbers, the bytes of golden/, and errors."""

import numpy as np
import pytest

import armtol
from armtol import ArmtolError, hahn1987

ACCURACY, DELTA = (0.5, 0.5, 0.5, 0.1, 0.1, 0.1), 0.1


def test_all_66_numbers():
    found = hahn1987.reproduce()
    assert (found.reproduced, len(found)) == (66, 66)
    assert {number.program for number in found.numbers} == {"intella", "adpta"}


def test_correcting_an_erratum_changes_what_it_is_said_to_change():
    """errata.c says of each whether it changes results; `all` leaves fewer than 66."""
    for erratum in hahn1987.errata():
        found = hahn1987.reproduce(erratum.id)
        assert erratum.changes or found.reproduced == 66, erratum.id
    assert hahn1987.reproduce("all").reproduced < 66
    names = [erratum.id for erratum in hahn1987.errata()]
    assert hahn1987.reproduce(names).numbers == hahn1987.reproduce("all").numbers


@pytest.mark.parametrize("folder", ["1987", "corrected"])
@pytest.mark.parametrize("case", ["intella-1", "intella-2", "adpta-1", "adpta-2"])
def test_the_files_are_the_programs(source, folder, case):
    here = source / "golden" / folder / case
    words = [float(word) for word in (here / "input").read_text().split()]
    wish, accuracy, delta = words[:-7], words[-7:-1], words[-1]
    program = getattr(hahn1987, case.partition("-")[0])
    run = program(wish, accuracy, delta, fix="all" if folder == "corrected" else ())
    files = run.files()
    assert len(files) == 4
    for name, content in files.items():
        assert content == (here / f"{name}.1").read_text(), name


def test_the_numbers_of_a_run():
    """Case 1 of intella, as the paper prints it; A has the shape of the report's figures."""
    run = hahn1987.intella((200, 200, 0, 0, 1.57, 0), ACCURACY, DELTA)
    assert [f"{x:.6f}" for x in run.q[:3]] == ["1.571237", "1.063532", "-0.944167"]
    assert f"{run.angle_bound:.6f}" == "0.000370"
    assert f"{run.distance_bound:.6f}" == "0.035243"
    assert run.matrix.shape == run.ordered.shape == (6, len(run.matrix[0]))
    assert 0 < run.n_lengths < run.matrix.shape[1]
    assert sorted(map(tuple, run.matrix.T)) == sorted(map(tuple, run.ordered.T))
    assert (len(run.machining), len(run.motors), len(run.check)) == (8, 6, 6)


def test_corrected_bounds_are_those_of_the_engine():
    """With all errata corrected the sphere of the engine, which shares no stage after A, gives the same."""
    run = hahn1987.adpta((200, 200, 0, 0), ACCURACY, DELTA, fix="all")
    answer = armtol.Arm.builtin("adeptone").allocate(run.q, ACCURACY, method="sphere", delta=DELTA)
    np.testing.assert_allclose(answer.bounds, (run.distance_bound, run.angle_bound), rtol=1e-9)
    np.testing.assert_allclose(answer.matrix[0], run.matrix, atol=1e-9)


def test_words_on_the_stack():
    """Zeros where getj set nothing give fewer of the numbers (docs/lab-book/residue.md): adpta's A changes."""
    as_found = hahn1987.adpta((200, 200, 0, 0), ACCURACY, DELTA)
    zeros = hahn1987.adpta((200, 200, 0, 0), ACCURACY, DELTA, residue=(0, 0, 0))
    assert not np.array_equal(zeros.matrix, as_found.matrix)
    again = hahn1987.adpta((200, 200, 0, 0), ACCURACY, DELTA, fix="skew-residue")
    np.testing.assert_array_equal(zeros.matrix, again.matrix)


@pytest.mark.parametrize(
    ("wrong", "error", "message"),
    [
        (lambda: hahn1987.intella((2000, 0, 0, 0, 0, 0), ACCURACY, DELTA), ArmtolError, "intella: out of reach"),
        (
            lambda: hahn1987.intella((200, 200), ACCURACY, DELTA),
            ValueError,
            r"position: shape \(2,\), expected \(6,\)",
        ),
        (lambda: hahn1987.adpta((200, 200, 0, 0, 0, 0), ACCURACY, DELTA), ValueError, r"expected \(4,\)"),
        (lambda: hahn1987.adpta((200, np.nan, 0, 0), ACCURACY, DELTA), ArmtolError, "not finite"),
        (lambda: hahn1987.adpta((200, 200, 0, 0), ACCURACY[:3], DELTA), ValueError, "accuracy: shape"),
        (lambda: hahn1987.adpta((200, 200, 0, 0), [-1] * 6, DELTA), ArmtolError, "not greater than zero"),
        (lambda: hahn1987.adpta((200, 200, 0, 0), ACCURACY, 5), ArmtolError, "delta"),
        (lambda: hahn1987.adpta((200, 200, 0, 0), ACCURACY, DELTA, residue=[1]), ValueError, "residue: shape"),
        (
            lambda: hahn1987.adpta((200, 200, 0, 0), ACCURACY, DELTA, fix="typo"),
            ArmtolError,
            "fix: 'typo': no erratum has that name",
        ),
        (lambda: hahn1987.reproduce(["labels", "typo"]), ArmtolError, "'typo': no erratum"),
    ],
)
def test_what_is_wrong_is_said(wrong, error, message):
    with pytest.raises(error, match=message):
        wrong()
