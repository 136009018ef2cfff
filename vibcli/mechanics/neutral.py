"""What a zero frequency means: free motion, or a restoring force beyond the linear one.

Along a direction d in which K vanishes, V(q + t d) − V(q) at a few t tells a motion that costs no energy (a
rigid-body mode) from one that terms of third and higher order hold or drive away (V = x⁴, V = −x⁴, V = x³).
"""

from vibcli.algebra.evaluate import Floats, evaluate
from vibcli.algebra.rationals import HALF

STEPS = (-0.1, -0.02, 0.02, 0.1)
ROUNDING = 1e-11
FREE, HELD, FALLING = "free", "held", "falling"


def zero_modes(problem):
    """{index of a mode without frequency: FREE, HELD or FALLING}."""
    return {mode.index: _along(problem, mode.shape) for mode in problem.modes if mode.rigid}


def _along(problem, shape):
    scene, at = problem.scene, problem.equilibrium.values
    shape = [complex(x).real for x in shape]
    sizes = [1.0 if not problem.dimension(name) else problem.figure_size or 1.0 for name in scene.coordinates]
    largest = max(abs(x) / size for x, size in zip(shape, sizes, strict=True))
    terms = [term.force * term.s + term.weight * term.s * term.s * HALF for term in scene.springs]
    terms += [-term.weight * term.s for term in scene.forces]
    terms += [term.weight * term.s for term in scene.weights] + [scene.energies["V"], -scene.energies["T"]]
    rest = dict.fromkeys((node.name for node in scene.v), 0.0)

    def energies(step):
        moved = {name: at[name] + step * x / largest for name, x in zip(scene.coordinates, shape, strict=True)}
        moved = problem.closed(at, {**at, **moved})
        return evaluate(terms, Floats, {**problem.floats, **rest, **moved})

    start = energies(0.0)
    gains = []
    for step in STEPS:
        parts = [a - b for a, b in zip(energies(step), start, strict=True)]
        noise = ROUNDING * sum(max(abs(part), abs(whole)) for part, whole in zip(parts, start, strict=True))
        gains.append(0 if not abs(sum(parts)) > noise else sum(parts))
    if any(gain < 0 for gain in gains):
        return FALLING
    return HELD if any(gains) else FREE
