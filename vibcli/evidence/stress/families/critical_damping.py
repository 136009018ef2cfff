"""At ζ = 1 the two solutions of a free motion are one; next to it their difference is divided by almost nothing."""

from typing import Any

from vibcli.evidence.stress.family import StressFamily, chain, powers


def scene(value: str) -> dict[str, Any]:
    """One mass on a spring and a damper, drawn out and let go."""
    return {"parameters": {"m": "3 kg", "k": "70 N/m", "off": value, "c": "2*(1 - off)*sqrt(k*m)", "a": "1 cm"},
            **chain(["m"], ["k"], ["c"]), "initial": {"x1": "a"}, "answers": {"x1(0.7 s)": "1 cm"}}


FAMILY = StressFamily("1 − ζ", ("0", *powers(-16, -1)), scene, ("integrators", "DOP853", "1e-12"))
