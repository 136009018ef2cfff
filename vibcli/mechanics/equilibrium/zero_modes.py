"""What a zero frequency means: free motion, or a restoring force beyond the linear one.

Along a direction d in which K vanishes, V(q + t d) − V(q) at a few t tells a motion that costs no energy (a
rigid-body mode) from one that terms of third and higher order hold or drive away (V = x⁴, V = −x⁴, V = x³).
"""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from vibcli.mechanics.numeric_linearisation import in_numbers
from vibcli.symbolic.evaluation import Floats, evaluate

if TYPE_CHECKING:
    from vibcli.mechanics.configuration import Configuration

STEPS = (-0.1, -0.02, 0.02, 0.1)
ROUNDING = 1e-11
FREE, HELD, FALLING = "free", "held", "falling"


def zero_modes(configuration: "Configuration", rigid: Sequence[Any]) -> dict[int, str]:
    """{index of a mode without frequency: FREE, HELD or FALLING}."""
    if not configuration.system.is_linear:
        from vibcli.mechanics.equilibrium.families import freedom, learnt

        if freedom(configuration.equilibrium, learnt(configuration.numeric)) == len(rigid):    # on curved lines too
            return dict.fromkeys((mode.index for mode in rigid), FREE)
    return {mode.index: _along(configuration, mode.shape) for mode in rigid}


def _along(configuration, shape):
    scene, at = configuration.scene, configuration.equilibrium.values
    shape = [complex(x).real for x in shape]
    sizes = map(configuration.numeric.size_along, scene.coordinates)
    largest = max(abs(x) / size for x, size in zip(shape, sizes, strict=True))
    direction = {name: x / largest for name, x in zip(scene.coordinates, shape, strict=True)}

    def place(step):
        moved = {name: at[name] + step * x for name, x in direction.items()}
        return {**configuration.at_rest, **configuration.numeric.closed(at, {**at, **moved})}

    system = configuration.system
    gains = list((_gains if system.conservative else _work_done)(system, place, direction))
    if any(gain < 0 for gain in gains):
        return FALLING
    return HELD if any(gains) else FREE


def _gains(system, place, direction):
    """V(q + t d) − V(q) at each step; 0 where it is rounding."""
    scene = system.scene
    terms = [term.potential(scene) for term in scene.springs]
    terms += [-term.weight * term.s for term in scene.forces]
    terms += [term.potential(scene) for term in scene.weights] + [scene.energies["V"], -scene.energies["T"]]
    start = evaluate(terms, Floats, place(0.0))
    for step in STEPS:
        parts = [a - b for a, b in zip(evaluate(terms, Floats, place(step)), start, strict=True)]
        yield _or_none(sum(parts), sum(max(abs(part), abs(whole)) for part, whole in zip(parts, start, strict=True)))


def _work_done(system, place, direction):
    """t r(q + t d)·d at each step, where loads have no potential."""
    for step in STEPS:
        numbers = in_numbers(system.linearisation, Floats, place(step))
        rows = zip(numbers.residual, numbers.residual_size, direction.values(), strict=True)
        work, size = map(sum, zip(*((r * d * step, abs(s * d * step)) for r, s, d in rows), strict=True))
        yield _or_none(work, size)


def _or_none(value, size):
    return value if abs(value) > ROUNDING * size else 0
