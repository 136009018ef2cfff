"""A sum of stiffnesses loses the soft one: 1 + 1e16 == 1e16."""

from vibcli.evidence.stress.family import StressFamily, chain, powers


def scene(value: str) -> dict[str, dict[str, dict[str, list[str] | str] | str]]:
    """Six masses that hang one on the other."""
    return {"parameters": {"m": "2 kg", "k": "300 N/m", "ratio": value},
            **chain(["m"] * 6, ["k", "ratio*k"] * 3), "answers": {"omega[1]": "1 rad/s"}}


FAMILY = StressFamily("ratio of the springs", powers(0, 20, 2), scene, ("assembled_modes", "scipy eigh", ""))
