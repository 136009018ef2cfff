"""Work within a time: late work is given up, no timer stays, interrupts get through."""

import signal
import threading
from itertools import count

import pytest

from vibcli.algebra.bounded import SMALL, within

SOON, NEVER = 0.02, 3600


def forever():
    for _ in count():
        pass


def running():
    return signal.getitimer(signal.ITIMER_REAL)[0]


@pytest.fixture(autouse=True)
def no_timer_is_left():
    before = signal.getsignal(signal.SIGALRM), running()
    yield
    assert (signal.getsignal(signal.SIGALRM), running()) == before


def test_work_in_time():
    assert within(NEVER, lambda: 3, None) == 3


def test_late_work_is_given_up():
    assert within(SOON, forever, "late") == "late"


def test_the_nearer_end_counts():
    assert within(SOON, lambda: within(NEVER, forever, "inner"), "outer") == "outer"
    assert within(NEVER, lambda: within(SOON, forever, "inner"), "outer") == "inner"


def test_the_outer_end_still_comes_after_an_inner_one():
    def work():
        within(SOON, forever, None)
        forever()
    assert within(10 * SOON, work, "outer") == "outer"
    assert within(NEVER, lambda: [within(SOON, forever, i) for i in range(3)], None) == [0, 1, 2]


def test_errors_get_through():
    with pytest.raises(ZeroDivisionError):
        within(NEVER, lambda: 1 / 0, None)
    with pytest.raises(KeyboardInterrupt):
        within(NEVER, lambda: signal.raise_signal(signal.SIGINT), None)


def test_what_catches_every_exception_does_not_catch_the_end():
    def work():
        try:
            forever()
        except Exception:
            return "caught"
    assert within(SOON, work, "late") == "late"


def test_a_timer_that_runs_already_keeps_its_handler():
    rung = []
    before = signal.signal(signal.SIGALRM, lambda *_: rung.append(True))
    try:
        signal.setitimer(signal.ITIMER_REAL, 5 * SOON)
        assert within(SOON, forever, "late") == "late"
        assert 0 < running() <= 5 * SOON
        while not rung:
            pass
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)


@pytest.mark.parametrize("size, expected", [(SMALL, "done"), (SMALL + 1, "late")])
def test_other_threads_do_small_work_only(size, expected):
    found = []
    thread = threading.Thread(target=lambda: found.append(within(NEVER, lambda: "done", "late", size)))
    thread.start()
    thread.join()
    assert found == [expected]


def test_without_timers_only_small_work_is_done(monkeypatch):
    monkeypatch.delattr(signal, "setitimer")
    assert within(NEVER, lambda: "done", "late", SMALL) == "done"
    assert within(NEVER, lambda: "done", "late", SMALL + 1) == "late"
