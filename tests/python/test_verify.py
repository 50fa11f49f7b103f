"""Arms drawn at random: threads, progress, Ctrl-C, and the interpreter's lock."""

import os
import signal
import threading
import time

import numpy as np
import pytest

Q = [0.0, 0.8, -1.6, 0.0, 0.8, 0.0]
ENDLESS = 10**12


@pytest.fixture
def answer(puma):
    return puma.allocate(Q, [0.5, 0.5, 0.5, 2e-4, 2e-4, 2e-4])


def test_threads_change_nothing(answer):
    one, two, all_of_them = (answer.verify(50_000, seed=3, threads=threads) for threads in (1, 2, None))
    assert one.quantiles.tobytes() == two.quantiles.tobytes() == all_of_them.quantiles.tobytes()
    assert one.worst_arm.tobytes() == two.worst_arm.tobytes()
    assert one.drawn == 50_000
    assert one.quantiles.tobytes() != answer.verify(50_000, seed=4).quantiles.tobytes()


def test_progress_is_told_to_the_end(answer):
    told = []
    answer.verify(50_000, threads=1, progress=lambda done, total: told.append((done, total)))
    assert told[-1] == (50_000, 50_000)
    assert [done for done, _ in told] == sorted(done for done, _ in told)
    assert len(told) > 3


def test_progress_that_is_false_ends_it_and_keeps_what_there_is(answer):
    found = answer.verify(ENDLESS, progress=lambda done, total: done < 30_000)
    assert 30_000 <= found.drawn < ENDLESS
    assert found.within == found.drawn


def test_what_progress_raises_is_raised(answer):
    def progress(done, total):
        raise KeyError("mine")

    with pytest.raises(KeyError, match="mine"):
        answer.verify(ENDLESS, progress=progress)


@pytest.fixture
def interruptible():
    """A shell has what it runs in the background ignore SIGINT, and Python keeps to that."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


def test_ctrl_c_ends_it(answer, interruptible):
    """Without a progress of the caller's, too."""
    timer = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
    began = time.monotonic()
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        answer.verify(ENDLESS)
    assert time.monotonic() - began < 10
    assert answer.verify(1000).drawn == 1000


def test_other_threads_run_meanwhile(answer):
    counted = 0
    done = threading.Event()

    def count():
        nonlocal counted
        while not done.is_set():
            counted += 1
            time.sleep(0.001)

    counter = threading.Thread(target=count)
    counter.start()
    before = counted
    answer.verify(3_000_000, threads=1)
    during = counted - before
    done.set()
    counter.join()
    assert during > 20


def test_answers_on_several_threads(puma, random):
    """Questions, verifications and tables at once give what they give alone."""
    poses = random.uniform(-1, 1, (8, 6))

    def work(q):
        answer = puma.allocate(q, [0.5] * 3 + [1e-3] * 3, weights={"motors": 2})
        return (
            answer.tolerances.tobytes(),
            answer.verify(5000).quantiles.tobytes(),
            type(puma).from_text(puma.table()).table(),
        )

    alone = [work(q) for q in poses]
    together = [None] * len(poses)

    def place(i):
        together[i] = work(poses[i])

    threads = [threading.Thread(target=place, args=(i,)) for i in range(len(poses))]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert together == alone


def test_the_search_of_corners_alone(answer):
    found = answer.verify(0)
    assert found.drawn == 0
    np.testing.assert_allclose(found.worst_corner, answer.worst, rtol=1e-3)


@pytest.mark.parametrize("wrong", [{"n": -1}, {"seed": -1}, {"seed": 2**64}, {"threads": 0}])
def test_numbers_out_of_range(answer, wrong):
    with pytest.raises(ValueError, match="expected"):
        answer.verify(**wrong)


def test_counts_have_to_be_whole(answer):
    with pytest.raises(TypeError):
        answer.verify(10.5)
