"""Two damped modes with one eigenvalue and one shape; beside it their eigenvalues part as the root of the distance.

det(λ² + λ C + K) with C = diag(2d, 0), K = [κ₀ + d²/2, −κ; −κ, κ₀ − d²/2], κ² = d² (κ₀ − d²/2), is the square
(λ² + d λ + κ₀ − d²/2)². Here d = 2 1/s, κ₀ = 102 1/s², κ = 20 1/s².
"""

from typing import Any

from vibcli.evidence.stress.family import StressFamily, chain, powers


def scene(value: str) -> dict[str, Any]:
    """Two masses on springs, joined by one, the first damped."""
    return {"parameters": {"off": value, "whole": "4 N*s/m", "c": "(1 + off)*whole"},
            **chain(["1 kg", "1 kg"], ["84 N/m", "20 N/m", "80 N/m"]),
            "dampers": {"d": {"c": "c", "between": ["ground", "m1"]}}, "answers": {"eigenvalue[1]": "1 s^-1"}}


FAMILY = StressFamily("distance", ("0", *powers(-16, -1)), scene, ("state_eigenvalues", "scipy eig", ""))
