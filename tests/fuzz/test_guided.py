"""`make fuzz` guided by what code is reached: what its kinds begin with, and where it cannot be done."""

import importlib.util

import pytest
from fuzz import guided


@pytest.mark.parametrize("kind", guided.KINDS)
def test_nothing_escapes_from_the_first_bytes_of_each_kind(kind):
    first = guided.seeds(kind)[:3]
    assert len(first) == 3
    for data in (*first, b"", b"\x00\xff{", first[0][:-1]):
        guided.KINDS[kind](data)


def test_what_escapes_is_a_failure(monkeypatch, capsys):
    monkeypatch.setattr(importlib.util, "find_spec", lambda name: name)
    monkeypatch.setattr(guided, "ended", lambda kind, *_: (kind == "solve", "b'x'\nTraceback"))
    assert guided.main("5", "1") == 1
    assert capsys.readouterr().out.endswith("solve, by what they reach: 5, b'x'\nTraceback\n")
    assert guided.main("5", "1", "documents") == 0


def test_without_atheris_it_is_said(monkeypatch, capsys):
    monkeypatch.setattr(importlib.util, "find_spec", lambda name: None)
    assert guided.main("5", "1") == 0 and "atheris is not installed" in capsys.readouterr().out
