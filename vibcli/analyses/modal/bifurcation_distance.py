"""How near an equilibrium is to a bifurcation: the condition number of its stiffness along the modes.

Along a mode x the stiffness xᵀKx is a sum of terms of both signs; the sum of their magnitudes over it is the factor by
which a relative change of the data grows in ω², and it has no bound where equilibria meet. A potential that is written
out is one term: there the change of xᵀKx over the size of the figure, from its derivatives, stands for them.
"""

import math
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from vibcli.analyses.modal.modal_analysis import ModalAnalysis
    from vibcli.analyses.modal.undamped import Mode
    from vibcli.mechanics.configuration import Configuration

NEAR = 1e6
LEAST, STEP = 6, 1e-2             # how many modes are looked at; the step of the differences
EPSILON = 2.0**-52


def stiffness_condition(modal: "ModalAnalysis") -> float:
    """The largest condition number over the modes of lowest frequency, rigid ones aside; 1 where nothing cancels, and
    where K is singular and its elements are known in floats alone (mechanics/degenerate.py); None where nothing has
    inertia."""
    from vibcli.analyses.modal.stability import inertless
    from vibcli.analyses.modal.undamped import factored

    if inertless(modal.configuration.element_data):
        return None
    if factored(modal.configuration.element_data) or modal.configuration.sources[0] is None:
        return 1.0
    modes = sorted((mode for mode in modal.modes.shown() if not mode.rigid), key=_rate)[:LEAST]
    return max((_condition(modal.configuration, mode) for mode in modes), default=1.0)


def bifurcation_warning(condition: float) -> str | None:
    """A sentence where the condition number is large, else None."""
    if condition is None or not condition > NEAR:
        return None
    return (f"near a bifurcation: the stiffness is nearly singular (condition {condition:.0e}); frequencies have about "
            f"{round(math.log10(condition / 2))} digits fewer than the data").replace("e+0", "e").replace("e+", "e")


def _rate(mode: "Mode") -> float:
    return float(mode.omega if mode.omega is not None else mode.growth_rate)


def _condition(configuration: "Configuration", mode: "Mode") -> float:
    """Σ |terms of xᴴKx| over |xᴴKx|."""
    elements, x = configuration.element_data, [complex(value) for value in mode.shape]
    springs = [k * abs(sum(a * x[i] for i, a in row.items())) ** 2 for k, row in elements.springs]
    others = {(i, j): (value * x[i].conjugate() * x[j]).real for (i, j), value in elements.K.items()}
    sizes = [value * abs(x[i]) * abs(x[j]) for (i, j), value in (elements.K_size or elements.K).items()]
    size = sum(map(abs, springs)) + sum(map(abs, sizes))
    left = abs(sum(springs) + sum(others.values()))
    return (size + _change(configuration, np.real(x))) / max(left, EPSILON * size) if size else 1.0


def _change(configuration: "Configuration", x: np.ndarray) -> float:
    """By how much xᵀKx changes over the size of the figure, as its first and second derivatives tell."""
    if configuration.system.is_linear or not any(configuration.system.linearisation.K):
        return 0.0
    from vibcli.mechanics.equilibrium.scaled_forces import typical_length
    from vibcli.mechanics.numeric_linearisation import in_numbers
    from vibcli.symbolic.evaluation import Floats

    names, at = configuration.scene.coordinates, configuration.equilibrium.values
    length = typical_length(configuration.numeric) or 1.0
    system, numeric = configuration.system, configuration.numeric
    unit = max(abs(a) / (length if system.dimension(name) else 1.0) for name, a in zip(names, x, strict=True))

    def along(step: float) -> float:
        moved = {name: at[name] + step * a / unit for name, a in zip(names, x, strict=True)}
        place = numeric.closed(at, {**at, **moved})
        K = in_numbers(system.linearisation, Floats, {**numeric.floats, **place}).elements.stiffness()
        found: float = sum(value * x[i] * x[j] for (i, j), value in K.items())
        return found

    before, here, after = (along(step) for step in (-STEP, 0.0, STEP))
    change = abs(after - before) / (2 * STEP) + abs(after - 2 * here + before) / (2 * STEP**2)
    return change if math.isfinite(change) else 0.0
