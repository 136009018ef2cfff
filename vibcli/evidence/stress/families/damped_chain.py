"""Strong dampers leave eigenvalues that are very small beside others that are very large."""

from typing import Any

from vibcli.evidence.stress.family import StressFamily, chain, powers


def scene(value: str) -> dict[str, Any]:
    """Three unlike masses; two springs and one mass between them are damped."""
    return {"parameters": {"m": "2 kg", "k": "300 N/m", "part": value, "c": "part*sqrt(k*m)"},
            **chain(["m", "2*m", "m/3"], ["k", "2*k", "k/2"], ["c", "c/7", "3*c"]),
            "answers": {"eigenvalue[1]": "1 s^-1"}}


FAMILY = StressFamily("c/√(k m)", powers(-12, 8, 2), scene, ("state_eigenvalues", "scipy eig", ""))
