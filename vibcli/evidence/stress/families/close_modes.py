"""Alike masses on alike springs, joined by weak ones: their motion hangs on gaps of frequencies far below these."""

import math
from typing import Any

import mpmath

from vibcli.evidence.stress.family import StressFamily, chain, powers


def scene(value: str) -> dict[str, dict[str, dict[str, list[str] | str] | str]]:
    """Two masses; the first is drawn out and gives its motion to the second, at the half of which it is asked."""
    return {"parameters": {"m": "1 kg", "k": "400 N/m", "gap": value, "a": "1 cm", "end": "pi/2/gap*sqrt(m/k)"},
            **chain(["m", "m"], ["k", "gap*k", "k"]), "initial": {"x1": "a"}, "answers": {"x2(end)": "1 cm"}}


def motion(gap: Any, library: Any) -> Any:
    """x₂ = a/2 (cos ω₁ t − cos ω₂ t), ω₂ = √(1 + 2 gap) ω₁, by `math` or mpmath."""
    turns = library.pi / 2 / gap
    return (library.cos(turns) - library.cos(library.sqrt(1 + 2 * gap) * turns)) / 200


def truth(value: str) -> tuple[list[Any], Any]:
    """At any gap."""
    return [motion(mpmath.mpf(value), mpmath)], mpmath.mpf("0.01")


FAMILY = StressFamily("gap/ω", powers(-1, -12, -1), scene, lambda value: [motion(float(value), math)], truth)
