"""Garbage is searched for where the process has grown, however few objects it is made of."""

import gc
from weakref import ref

import pytest

from vibcli.base import garbage


class Circle:
    def __init__(self):
        self.itself = self


@pytest.mark.parametrize(("held", "gone"), [((0, 0), False), ((garbage.GROWN + 1, 0), True), ((None, None), True),
                                            ((garbage.GROWN, 0), False)])
def test_what_was_left_goes_where_the_process_has_grown(held, gone, monkeypatch):
    told = iter(held)
    monkeypatch.setattr(garbage, "_resident", lambda: next(told))
    gc.freeze()         # what other tests keep is not looked through
    left = ref(Circle())
    garbage.Garbage().clear()
    assert (left() is None) is gone


def test_what_is_left_counts_from_the_last_search(monkeypatch):
    told, searches = iter((2 * garbage.GROWN, garbage.GROWN, 2 * garbage.GROWN, 2 * garbage.GROWN + 1, 0)), []
    monkeypatch.setattr(garbage, "_resident", lambda: next(told))
    monkeypatch.setattr(garbage.gc, "collect", lambda: searches.append(1))
    one = garbage.Garbage()
    for count in (1, 1, 2):
        one.clear()
        assert len(searches) == count


def test_the_system_tells_how_much_the_process_holds():
    held = garbage._resident()
    assert held is None or held > 1_000_000
