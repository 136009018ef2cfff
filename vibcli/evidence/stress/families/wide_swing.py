"""A pendulum that almost stands on its head swings ever more slowly, and errors grow while it lingers there."""

from typing import Any

from vibcli.evidence.stress.family import StressFamily, powers


def scene(value: str) -> dict[str, Any]:
    """A pendulum let go near its upper position of rest; phi is counted from the lower one."""
    return {"parameters": {"m": "1 kg", "L": "1 m", "g": "9.81 m/s^2", "off": value, "start": "pi - off*(1 rad)"},
            "gravity": "g", "motion": "full",
            "bodies": {"mass": {"mass": "m", "at": ["0", "-L"], "pin": {"at": ["0", "0"], "by": "phi"}}},
            "initial": {"phi": "start"}, "answers": {"phi(8 s)": "1 rad"}}


FAMILY = StressFamily("angle from the top", powers(-1, -10, -1), scene, ("integrators", "DOP853", "1e-10"))
