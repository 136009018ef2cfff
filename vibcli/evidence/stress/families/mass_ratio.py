"""Heavy masses beside light ones spread the frequencies as stiff springs do."""

from vibcli.evidence.stress.family import StressFamily, chain, powers


def scene(value: str) -> dict[str, dict[str, dict[str, list[str] | str] | str]]:
    """Six masses that hang one on the other."""
    return {"parameters": {"m": "2 kg", "k": "300 N/m", "ratio": value},
            **chain(["m", "ratio*m"] * 3, ["k"] * 6), "answers": {"omega[1]": "1 rad/s"}}


FAMILY = StressFamily("ratio of the masses", powers(0, 20, 2), scene, ("assembled_modes", "scipy eigh", ""))
