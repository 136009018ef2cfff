"""`make fuzz`: each kind can be drawn, and what escapes is told so that it can be drawn again."""

import pytest
from fuzz import many


@pytest.mark.parametrize("kind", many.KINDS)
def test_a_few_of_each_kind(kind):
    assert many.failures(kind, 20, "31") == []
    assert many.drawn(kind, "31", 7) == many.drawn(kind, "31", 7)


@pytest.mark.parametrize("kind", many.KINDS)
def test_what_escapes_is_told(kind, monkeypatch, capsys):
    def spoilt(dice):
        return 1 / (dice.random() > 0.5)

    monkeypatch.setitem(many.KINDS, kind, spoilt)
    failed = [number for number, _ in many.failures(kind, 20, "1")]
    assert 3 < len(failed) < 17
    assert many.main("20", "1", kind) == 1
    out = capsys.readouterr().out
    assert f"{kind} 1:{failed[0]}\nTraceback" in out and out.endswith(f"{kind}: 20, {len(failed)} failed\n")
    assert many.main(kind, f"1:{failed[0]}") == 0
    assert "ZeroDivisionError" in capsys.readouterr().out


def test_a_command_that_leaves_by_a_fault_of_ours_is_a_failure(monkeypatch):
    monkeypatch.setattr(many, "run", lambda args: 101)
    assert len(many.failures("scenes", 3, "1")) == 3
