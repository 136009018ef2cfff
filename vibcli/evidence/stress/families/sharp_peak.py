"""The peak of a frequency response is as narrow as its damping is small: a grid misses it."""

from typing import Any

from vibcli.evidence.stress.family import StressFamily, chain, powers


def scene(value: str) -> dict[str, Any]:
    """Two masses, the first driven; its second peak."""
    return {"parameters": {"m": "1 kg", "k": "100 N/m", "zeta": value, "c": "2*zeta*sqrt(k*m)", "F": "1 N",
                           "Omega": "3 rad/s"},
            **chain(["m", "m/2"], ["k", "k/3"], ["c", "c"]),
            "forces": {"load": {"at": "m1", "force": "F*cos(Omega*t)"}},
            "answers": {"peak[2](frf[x2, load]).value": "1 m/N"}}


FAMILY = StressFamily("ζ", powers(-2, -12, -1), scene, ("dense_grids", "grid with parabolas", "10000 points"))
