"""λ = −ζω ± ω√(ζ² − 1): the slow root of heavy damping cancels in the textbook's formula."""

from typing import Any

from vibcli.evidence.stress.family import StressFamily, chain, powers


def scene(value: str) -> dict[str, Any]:
    """One mass on a spring and a damper."""
    return {"parameters": {"m": "3 kg", "k": "70 N/m", "zeta": value, "c": "2*zeta*sqrt(k*m)"},
            **chain(["m"], ["k"], ["c"]), "answers": {"eigenvalue[1]": "1 s^-1"}}


FAMILY = StressFamily("ζ", powers(-12, 8, 2), scene, ("state_eigenvalues", "scipy eig", ""))
