"""A verification in parts: the same bits as one, whatever the parts; what does not belong together is refused."""

import pickle

import numpy as np
import pytest

import armtol

Q = [0.0, 0.8, -1.6, 0.0, 0.8, 0.0]
ARMS = 50_000


@pytest.fixture
def answer(puma):
    return puma.allocate(Q, {"r": 0.5, "wx": 2e-4, "wy": 2e-4, "wz": 2e-4})


def bits(found):
    arrays = (found.quantiles, found.worst_drawn, found.worst_arm, found.worst_corner)
    return found.drawn, found.within, found.beyond, found.share_95, *(x.tobytes() for x in arrays)


def test_parts_in_any_order_are_the_whole(answer, random):
    cuts = [0, *np.sort(random.choice(np.arange(1, ARMS), 6, replace=False)).tolist(), ARMS]
    parts = [answer.tally(first, end - first, seed=3) for first, end in zip(cuts, cuts[1:])]
    random.shuffle(parts)
    whole = sum(parts)
    assert whole.ranges == ((0, ARMS),) and whole.drawn == ARMS
    assert bits(whole.verify(answer)) == bits(answer.verify(ARMS, seed=3))


def test_they_can_be_sent(answer):
    """Also to an answer that was made anew."""
    sent = pickle.loads(pickle.dumps(answer.tally(0, 20_000, threads=2)))
    again = armtol.Arm.builtin("puma560").allocate(Q, {"r": 0.5, "wx": 2e-4, "wy": 2e-4, "wz": 2e-4})
    assert bits((sent + again.tally(20_000, 10_000)).verify(again)) == bits(answer.verify(30_000))
    assert len(pickle.dumps(sent)) < 500_000
    assert repr(sent) == "<armtol.Tally: 20000 arms of seed 1987>"


def test_no_arms(answer):
    nothing = pickle.loads(pickle.dumps(answer.tally(7, 0)))
    assert nothing.ranges == () and nothing.drawn == 0
    assert bits((nothing + answer.tally(0, 1000)).verify(answer)) == bits(answer.verify(1000))


def test_arms_that_are_missing(answer):
    holed = pickle.loads(pickle.dumps(answer.tally(0, 1000) + answer.tally(3000, 1000)))
    assert holed.ranges == ((0, 1000), (3000, 1000))
    assert holed.verify(answer).drawn == 2000


def test_an_arm_counts_once(answer):
    with pytest.raises(ValueError, match="arm 900 is in two of them"):
        answer.tally(0, 1000) + answer.tally(900, 1000)


def test_what_does_not_belong_together(answer, puma):
    one = answer.tally(0, 1000)
    with pytest.raises(ValueError, match="seeds 1987 and 4"):
        one + answer.tally(1000, 1000, seed=4)
    with pytest.raises(armtol.ArmtolError, match=r"different questions \(.*accuracy"):
        one + puma.allocate(Q, [0.5] * 3 + [2e-4] * 3).tally(1000, 1000)
    other = puma.predict(Q, {"motors": 1e-4})
    with pytest.raises(armtol.ArmtolError, match="tolerances"):
        one.verify(other)
    with pytest.raises(TypeError):
        one + 1


def test_damage(answer):
    make, (version, data, *rest) = answer.tally(0, 1000).__reduce__()
    other = answer.tally(0, 999).__reduce__()[1][1]
    with pytest.raises(armtol.ArmtolError, match="damaged"):
        make(version, other, *rest)
    with pytest.raises(armtol.ArmtolError, match=r"drawn by armtol 0\.0\.9"):
        make("0.0.9", data, *rest)


def test_progress(answer):
    told = []
    answer.tally(0, ARMS, threads=1, progress=lambda done, total: told.append((done, total)))
    assert told[-1] == (ARMS, ARMS)
    part = answer.tally(100, 10**12, progress=lambda done, total: done < 30_000)
    (first, count), = part.ranges
    assert first == 100 and 30_000 <= count < 10**12
    with pytest.raises(ZeroDivisionError):
        answer.tally(0, 10**12, progress=lambda done, total: 1 // 0)


@pytest.mark.parametrize("wrong", [(-1, 5), (0, -1), (2**64 - 2, 5)])
def test_numbers_out_of_range(answer, wrong):
    with pytest.raises(ValueError, match="expected"):
        answer.tally(*wrong)
