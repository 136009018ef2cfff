"""Work within a number of calls: what takes more is given up, the same on every machine; nothing is left behind."""

import signal
import sys
import threading

import pytest
from support.counting import calls

from vibcli.base.work import Work
from vibcli.symbolic.time_limit import within

FEW, MANY = 100, 10**9


def step():
    return 1


def forever():
    while True:
        step()


@pytest.fixture(autouse=True)
def no_tracing_is_left():
    before = sys.gettrace()
    yield
    assert sys.gettrace() is before


def test_work_that_is_done():
    assert within(MANY, lambda: 3, None) == 3


@pytest.mark.parametrize("allowed", [10, 100])
def test_work_is_given_up_after_so_many_calls(allowed):
    done = []
    assert within(allowed, lambda: [done.append(step()) for _ in range(1000)], "given up") == "given up"
    assert allowed - 3 <= len(done) <= allowed
    assert within(1003, lambda: sum(step() for _ in range(500)), "given up") == 500


def test_the_end_is_not_lost_in_a_generator_that_is_closed(monkeypatch):
    """Whatever number of calls is left where it is."""
    swallowed = []
    monkeypatch.setattr(sys, "unraisablehook", swallowed.append)

    def work():
        for _ in range(5):
            begun = (step() for _ in range(3))
            next(begun)
            del begun
        return [step() for _ in range(FEW)]

    assert [within(allowed, work, None) for allowed in range(1, FEW)] == [None] * (FEW - 1)
    assert not swallowed
    assert within(FEW, lambda: sum(1 for _ in iter(int, 1)), "given up") == "given up"


def test_the_nearer_end_counts():
    assert within(FEW, lambda: within(MANY, forever, "inner"), "outer") == "outer"
    assert within(MANY, lambda: within(FEW, forever, "inner"), "outer") == "inner"


def test_the_outer_end_still_comes_after_an_inner_one():
    def work():
        within(FEW, forever, None)
        forever()
    assert within(10 * FEW, work, "outer") == "outer"
    assert within(MANY, lambda: [within(FEW, forever, i) for i in range(3)], None) == [0, 1, 2]
    assert within(2 * FEW, lambda: [within(FEW, forever, i) for i in range(3)], "outer") == "outer"


def test_what_is_given_up_is_noted_by_the_work_under_way():
    work = Work()
    with work.task("a closed form"):
        assert within(FEW, lambda: within(MANY, forever, "inner"), "outer") == "outer"
    assert work.cut


def test_errors_get_through():
    with pytest.raises(ZeroDivisionError):
        within(MANY, lambda: 1 / 0, None)
    before = signal.signal(signal.SIGINT, signal.default_int_handler)       # ignored in what a shell put behind it
    try:
        with pytest.raises(KeyboardInterrupt):
            within(MANY, lambda: signal.raise_signal(signal.SIGINT), None)
    finally:
        signal.signal(signal.SIGINT, before)


def test_what_catches_every_exception_does_not_catch_the_end():
    def work():
        try:
            forever()
        except Exception:
            return "caught"
    assert within(FEW, work, "given up") == "given up"


def test_whoever_traces_goes_on_tracing():
    found, count = calls(within, MANY, lambda: [step() for _ in range(50)], None)
    assert found == [1] * 50 and 50 <= count < 60
    assert calls(within, FEW, forever, "given up")[0] == "given up"


def test_other_threads_are_bounded_too():
    found = []
    thread = threading.Thread(target=lambda: found.append(within(FEW, forever, "given up")))
    thread.start()
    thread.join()
    assert found == ["given up"]
