"""ω = 2 √(k/m) sin(i π/(2(n + 1))) of n masses between two walls."""

from typing import Any

import mpmath

from vibcli.evidence.stress.family import StressFamily, chain


def scene(value: str) -> dict[str, dict[str, dict[str, list[str] | str] | str]]:
    """n masses between two walls."""
    n = int(value)
    return {"parameters": {"m": "3 kg", "k": "700 N/m"}, **chain(["m"] * n, ["k"] * (n + 1)),
            "answers": {"omega[1]": "1 rad/s"}}


def truth(value: str) -> tuple[list[Any], Any]:
    """λ = iω."""
    n = int(value)
    scale = 2 * mpmath.sqrt(mpmath.mpf(700) / 3)
    return [mpmath.mpc(0, scale * mpmath.sin(i * mpmath.pi / (2 * (n + 1)))) for i in range(1, n + 1)], None


FAMILY = StressFamily("coordinates", ("2", "3", "5", "10", "20", "40", "41", "70", "100"), scene,
                ("assembled_modes", "scipy eigh", ""), truth)
