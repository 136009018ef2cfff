"""Near a dead point the piston hardly moves with the crank: its spring almost ceases to hold."""

from typing import Any

from vibcli.evidence.stress.family import StressFamily, powers


def scene(value: str) -> dict[str, Any]:
    """A crank, a rod without mass between it and a piston on a spring; phi is counted from the drawn position."""
    return {"parameters": {"J": "0.01 kg*m^2", "M": "1.5 kg", "r": "10 cm", "l": "26 cm", "k": "5 kN/m", "angle": value,
                           "px": "r*cos(angle)", "py": "r*sin(angle)", "b": "px + sqrt(l^2 - py^2)"},
            "points": {"P": {"body": "crank", "at": ["px", "py"]}, "A": {"body": "rod", "at": ["px", "py"]}},
            "bodies": {"crank": {"inertia": "J", "at": ["0", "0"], "pin": "phi"},
                       "piston": {"mass": "M", "at": ["b", "0"], "slide": "x"},
                       "rod": {"shape": "rod", "mass": "M/3", "from": ["b", "0"], "to": ["px", "py"],
                               "pin": {"at": "piston", "by": "psi"}}},
            "springs": {"s": {"k": "k", "between": ["piston", ["3*b", "0"]]}},
            "constraints": {"pin": {"join": ["P", "A"]}}, "answers": {"omega[1]": "1 rad/s"}}


FAMILY = StressFamily("angle of the crank", powers(-1, -12, -1), scene, ("assembled_modes", "scipy eigh", ""))
