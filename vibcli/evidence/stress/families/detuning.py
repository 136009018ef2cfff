"""cos Ωt − cos ωt over ω² − Ω²: nothing over nothing at resonance."""

import math
from typing import Any

import mpmath

from vibcli.evidence.stress.family import StressFamily, chain, powers


def scene(value: str) -> dict[str, Any]:
    """One mass on a spring under a load, from rest."""
    return {"parameters": {"m": "3 kg", "k": "70 N/m", "F": "5 N", "off": value, "Omega": "(1 - off)*sqrt(k/m)"},
            **chain(["m"], ["k"]), "forces": {"load": {"at": "m1", "force": "F*cos(Omega*t)"}},
            "answers": {"x1(60 s)": "1 cm"}}


def motion(off: Any, library: Any) -> Any:
    """F/m (cos Ωt − cos ωt)/(ω² − Ω²), at resonance F t sin(ωt)/(2mω), as it is written, by `math` or mpmath."""
    omega = library.sqrt(70) / library.sqrt(3)
    Omega = (1 - off) * omega
    if Omega == omega:
        return 5 * 60 * library.sin(omega * 60) / (6 * omega)
    return 5 * (library.cos(Omega * 60) - library.cos(omega * 60)) / (3 * (omega**2 - Omega**2))


def truth(value: str) -> tuple[list[Any], Any]:
    """Beside the motion at resonance, F t/(2mω)."""
    return [motion(mpmath.mpf(value), mpmath)], 50 / mpmath.sqrt(mpmath.mpf(70) / 3)


FAMILY = StressFamily("1 − Ω/ω", ("0", *powers(-16, -1)), scene, lambda value: [motion(float(value), math)], truth)
