"""The phase of a motion loses a digit with each ten times as many periods."""

import math
from typing import Any

import mpmath

from vibcli.evidence.stress.family import StressFamily, chain, powers


def scene(value: str) -> dict[str, dict[str, dict[str, list[str] | str] | str]]:
    """Three masses between two walls; the first is drawn out and let go."""
    return {"parameters": {"m": "1 kg", "k": "100 N/m", "a": "1 cm", "turns": value, "end": "turns*sqrt(m/k)"},
            **chain(["m"] * 3, ["k"] * 4), "initial": {"x1": "a"}, "answers": {"x3(end)": "1 cm"}}


def motion(turns: Any, library: Any) -> Any:
    """x₃ = a/2 Σ sin(iπ/4) sin(3iπ/4) cos(2 sin(iπ/8) √(k/m) t), by `math` or mpmath."""
    part = library.pi / 4
    return sum(library.sin(i * part) * library.sin(3 * i * part) * library.cos(2 * library.sin(i * part / 2) * turns)
               for i in (1, 2, 3)) / 200


def truth(value: str) -> tuple[list[mpmath.mpf], mpmath.mpf]:
    """At any number of turns."""
    return [motion(mpmath.mpf(value), mpmath)], mpmath.mpf("0.01")


FAMILY = StressFamily("ω t", powers(0, 12), scene, lambda value: [motion(float(value), math)], truth)
