"""A conservative gyroscopic system neither grows nor decays, however fast it turns."""

from typing import Any

from vibcli.evidence.stress.family import StressFamily, powers


def scene(value: str) -> dict[str, Any]:
    """Two directions of a mass on a turning table, held by unlike springs; what the centrifugal force softens is left
    out, as by a rotor beside its discs."""
    return {"parameters": {"m": "2 kg", "k": "300 N/m", "turning": value, "h": "2*turning*sqrt(k*m)"},
            "coordinates": {"x": "along the first springs", "y": "along the second springs"},
            "matrices": {"M": [["m", "0"], ["0", "m"]], "C": [["0", "-h"], ["h", "0"]],
                         "K": [["k", "k/7"], ["k/7", "2*k"]]},
            "answers": {"omega[1]": "1 rad/s"}}


FAMILY = StressFamily("Ω/ω", powers(-6, 8), scene, ("state_eigenvalues", "scipy eig", ""))
