"""K of a column is what the load leaves of its stiffness: next to the critical load almost nothing."""

from vibcli.evidence.stress.family import StressFamily, powers


def scene(value: str) -> dict[str, dict[str, dict[str, dict[str, list[str] | str] | list[str] | str] | str]]:
    """Two rods, the one on the other, held by torsion springs; P_cr = (3 − √5)/2 k/L, L of each."""
    return {"parameters": {"m": "1 kg", "L": "0.5 m", "k": "20 N*m/rad", "off": value,
                           "P": "(1 - off)*(3 - sqrt(5))/2*k/L"},
            "points": {"Q": {"body": "low", "at": ["0", "L"]}, "A": {"body": "top", "at": ["0", "2*L"]}},
            "bodies": {"low": {"shape": "rod", "mass": "m", "from": ["0", "0"], "to": ["0", "L"],
                               "pin": {"at": ["0", "0"], "by": "phi"}},
                       "top": {"shape": "rod", "mass": "m", "from": ["0", "L"], "to": ["0", "2*L"],
                               "pin": {"at": "Q", "by": "psi"}}},
            "springs": {"foot": {"torsion": "k", "between": ["ground", "low"]},
                        "joint": {"torsion": "k", "between": ["low", "top"]}},
            "forces": {"load": {"at": "A", "force": ["0", "-P"]}}, "answers": {"omega[1]": "1 rad/s"}}


FAMILY = StressFamily("1 − P/P_cr", powers(-1, -14, -1), scene, ("assembled_modes", "scipy eigh", ""))
