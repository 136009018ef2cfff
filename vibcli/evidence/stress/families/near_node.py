"""A mode is hardly driven by a force near its node: two large terms cancel in its part of the motion."""

from typing import Any

from vibcli.evidence.stress.family import StressFamily, chain, powers


def scene(value: str) -> dict[str, Any]:
    """Three masses between walls, the middle one driven at √(2k/m), where the second mode would have its resonance."""
    return {"parameters": {"m": "1 kg", "k": "100 N/m", "off": value, "c": "0.001*sqrt(k*m)", "F": "1 N",
                           "Omega": "sqrt(2*k/m)"},
            **chain(["m", "m", "(1 + off)*m"], ["k"] * 4, ["c", "c", "c", "c"]),
            "forces": {"load": {"at": "m2", "force": "F*cos(Omega*t)"}},
            "answers": {"frf[x2, load](Omega)": "1 m/N"}}


FAMILY = StressFamily("distance from the node", powers(-1, -15, -2), scene, ("one_frequency", "numpy solve", ""))
