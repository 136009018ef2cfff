"""A double pendulum let go at wide angles: its motion forgets where it began."""

from typing import Any

from vibcli.evidence.stress.family import StressFamily


def scene(value: str) -> dict[str, Any]:
    """Two pendulums, the one at the other, followed for so long."""
    return {"parameters": {"m": "1 kg", "L": "1 m", "g": "9.81 m/s^2", "end": f"{value} s"},
            "gravity": "g", "motion": "full", "points": {"Q": {"body": "one", "at": ["0", "-L"]}},
            "bodies": {"one": {"mass": "m", "at": ["0", "-L"], "pin": {"at": ["0", "0"], "by": "phi"}},
                       "two": {"mass": "m", "at": ["0", "-2*L"], "pin": {"at": "Q", "by": "psi"}}},
            "initial": {"phi": "2 rad", "psi": "2.5 rad"},
            "answers": {"psi(end)": "1 rad"}}


FAMILY = StressFamily("seconds", ("0.5", "1", "2", "4", "8", "12", "16"), scene, ("integrators", "DOP853", "1e-10"))
