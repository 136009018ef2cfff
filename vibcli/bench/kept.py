"""`make evidence`: comparisons of some scenes, as they are kept beside this file: a page of tables, curves, all points.

Each is what `vibcli bench FILE` gives; the machine is told, for times hold on it alone.
"""

import json
import platform
from importlib.metadata import version
from pathlib import Path
from typing import Any

from vibcli.bench import scenes
from vibcli.bench.trajectories import DOUBLE

FOLDER = Path(__file__).parent / "evidence"
LONG = 120.0            # s for the runs of one comparison: so long that curves reach their finest tolerances
PACKAGES = ("vibcli", "numpy", "scipy", "mpmath")
STIFF = [f"{10 ** (16 * place / 5):.17e}" for place in (0, 5, 2, 4, 1, 3)]
HEAVY = scenes.chain(3, ["1000", "20000", "3"]) + "dampers: {d: {c: 1e6 N*s/m, between: [ground, b2]}}\n"
ABSORBER = """\
title: A sharp peak
bodies: {a: {mass: 2 kg, slide: x}, b: {mass: 0.1 kg, slide: y}}
springs: {s: {k: 800 N/m, between: [ground, a]}, t: {k: 40 N/m, between: [a, b]}}
dampers: {d: {c: 0.002 N*s/m, between: [a, b]}}
forces: {F: {at: a, force: 1 N*sin(20 rad/s*t)}}
"""
DETUNED = """\
title: A thousand periods, almost at resonance
bodies: {a: {mass: 1 kg, slide: x}}
springs: {s: {k: 100 N/m, between: [ground, a]}}
forces: {F: {at: a, force: 1 N*cos(10.001 rad/s*t)}}
"""
RESONANT = """\
title: A steady push at resonance
bodies: {a: {mass: 1 kg, slide: x}, b: {mass: 2 kg, slide: y}}
springs: {s: {k: 500 N/m, between: [ground, a]}, t: {k: 400 N/m, between: [a, b]}}
forces: {F: {at: a, force: 1 N*cos(10 rad/s*t)}}
"""
SWINGING = f"title: A double pendulum that swings widely{DOUBLE}initial: {{p: 60 deg, r: 80 deg}}\nmotion: full\n"
BEAM = "beams: {arm: {length: 2 m, EI: 4 kN*m^2, mass_per_length: 3 kg/m, left: clamped, attached: [{at: 2 m, " \
       "mass: 3 kg}]}}\n"
KEPT = {        # {name: (title, scene, what is asked)}
    "stiff_chain": ("Eigenvalues: six masses, stiffness ratio 1e16", scenes.chain(6, STIFF, "3 kg"), "omega[1]"),
    "pendulum": ("Eigenvalues: a pendulum of 12 links", scenes.pendulum(12), "omega[1]"),
    "heavily_damped": ("Eigenvalues: a dashpot that all but holds a mass", HEAVY, "eigenvalue[1]"),
    "sharp_peak": ("Frequency response: a sharp peak", ABSORBER, "peak[2](frf[x, F]).value"),
    "thousand_periods": ("Linear response: 1,000 periods, detuned by 1e-4", DETUNED, "x(628 s)"),
    "at_resonance": ("Linear response: exactly at resonance, two degrees", RESONANT, "y(60 s)"),
    "double_pendulum": ("Nonlinear: a double pendulum, 5 s", SWINGING, "r(5 s)"),
    "cantilever": ("Members: a cantilever with a mass at its tip", BEAM, "omega[1]"),
}


def main() -> None:
    """Make them all, and write what is kept."""
    FOLDER.mkdir(exist_ok=True)
    parts: list[str] = [_head()]
    everything: dict[str, Any] = {"machine": machine(), "comparisons": {}}
    for name, (title, text, quantity) in KEPT.items():
        print(name, flush=True)
        page, curve, data = compared(text, quantity)
        (FOLDER / f"{name}.svg").write_bytes(curve)
        parts.append(f"## {title}\n\n![Run time over true error]({name}.svg)\n\n{page}")
        everything["comparisons"][name] = {"title": title, "scene": text, **data}
    (FOLDER / "README.md").write_text("\n\n".join(parts) + "\n", encoding="utf-8")
    (FOLDER / "evidence.json").write_text(json.dumps(everything, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")


def machine() -> dict[str, str]:
    """Where it was measured."""
    return {"system": platform.system(), "machine": platform.machine(), "python": platform.python_version(),
            **{name: version(name) for name in PACKAGES}}


def compared(text: str, quantity: str) -> tuple[str, bytes, dict[str, Any]]:
    """(the table in Markdown, the curves as SVG, all points) of a quantity of a scene."""
    from vibcli.api.source import problem_of, text_source
    from vibcli.api.values import quantity_asked
    from vibcli.evidence import told
    from vibcli.evidence.compared import evidence
    from vibcli.evidence.picture import figure, picture_of

    problem = problem_of(text_source(text))
    found = evidence(problem, [quantity_asked(problem.spec, quantity)], whole=LONG)
    if not found.compared:
        raise RuntimeError(found.left_out[0].why)
    return told.markdown(found.compared[0]), picture_of(figure(found.compared))("svg"), told.data(found)


def _head() -> str:
    told = ", ".join(f"{name} {value}" for name, value in machine().items())
    return ("# Run time against true error\n\nWritten by `make evidence`; how it is measured tells `vibcli explain "
            f"bench`. On: {told}.\nTimes hold on this machine alone, errors on any.")


if __name__ == "__main__":
    main()
