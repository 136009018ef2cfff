"""Quantities of modes: frequencies, shapes, damping, sensitivities and estimates."""

from math import sqrt, tau

from vibcli.base.errors import PhysicsError
from vibcli.language.signals import coordinate_name
from vibcli.mechanics.inputs_outputs.displacements import displacement
from vibcli.quantities.quantity import ROUNDING
from vibcli.symbolic.derivatives import gradient
from vibcli.symbolic.evaluation import Floats, evaluate


def _mode(problem, indices):
    modes = problem.modal.modes
    number = int(indices[0])
    if not modes:
        raise PhysicsError(f"there is no mode {number}: without its dampers nothing would hold what has no "
                           "inertia in this scene",
                           "ask for decay[1] or eigenvalue[1]")
    if number > len(modes):
        raise PhysicsError(f"there is no mode {number}: this scene has {_counted(len(modes), 'mode')}",
                           "ask for one that it has")
    return modes[number - 1]


def _counted(count, noun):
    return f"one {noun}" if count == 1 else f"{count} {noun}s"


def _oscillating(problem, indices, what):
    mode = _mode(problem, indices)
    if mode.omega is None:
        raise PhysicsError(f"mode {indices[0]} is unstable: it has a growth rate, no {what}",
                           f"ask for growth_rate[{indices[0]}] or stable")
    return mode


def _omega(problem, indices, attribute):
    mode = _oscillating(problem, indices, "frequency")
    return float(mode.omega), mode.error


def _frequency(problem, indices, attribute):
    mode = _oscillating(problem, indices, "frequency")
    return float(mode.omega) / tau, mode.error


def _period(problem, indices, attribute):
    mode = _oscillating(problem, indices, "period")
    if not mode.omega:
        raise PhysicsError(f"mode {indices[0]} is a rigid-body mode: it has no period",
                           f"ask for omega[{indices[0]}]: 0 rad/s")
    return tau / float(mode.omega), mode.error


def _growth_rate(problem, indices, attribute):
    mode = _mode(problem, indices)
    if mode.growth_rate is None:
        raise PhysicsError(f"mode {indices[0]} does not grow: it is not unstable", f"ask for omega[{indices[0]}]")
    return float(mode.growth_rate), mode.error


def _shape(problem, indices, attribute):
    mode = _mode(problem, indices[:1])
    amplitude = _along(problem, problem.modal.shape(mode), coordinate_name(problem.spec, indices[1]) or indices[1])
    return complex(amplitude) if isinstance(amplitude, complex) and amplitude.imag else float(amplitude.real), 1e-11


def _along(problem, shape, signal):
    """How far a signal moves where the coordinates move by `shape`: Σ (∂s/∂qᵢ) φᵢ."""
    scene = problem.scene.resting
    if signal in scene.coordinates:
        return shape[scene.coordinates.index(signal)]
    node = displacement(scene, signal)
    if node is None:
        raise PhysicsError(f"'{signal}' is a force: it has no amplitude in a mode", "ask for a place, turn or stretch")
    slopes = gradient(node)
    values = evaluate([slopes.get(q, scene.table.zero) for q in scene.q], Floats, problem.configuration.at_rest)
    return sum(slope * x for slope, x in zip(values, shape, strict=True))


def damped_mode(problem, indices):
    """The damped mode of an index; a scene without dampers has none."""
    modes = problem.modal.damped
    if modes is None:
        raise PhysicsError("nothing damps this scene: it has no damped modes", "add a damper")
    number = int(indices[0])
    found = [mode for mode in modes if mode.index == number]
    if not found:
        raise PhysicsError(f"there is no damped mode {number}: this scene has "
                           f"{_counted(modes[-1].index, 'damped mode')}", "ask for one that it has")
    return found[0]


def _of_damped(attribute_name, words):
    def value(problem, indices, attribute):
        mode = damped_mode(problem, indices)
        number = getattr(mode, attribute_name)
        if number is None:
            raise PhysicsError(f"damped mode {indices[0]} has no {words}", "see `vibcli frequencies` for what it has")
        return float(number), mode.error
    return value


def _eigenvalue(problem, indices, attribute):
    mode = damped_mode(problem, indices)
    return complex(mode.eigenvalue), mode.error


def _decrement(problem, indices, attribute):
    zeta, error = VALUES["zeta"](problem, indices, attribute)
    if not zeta < 1:
        raise PhysicsError(f"damped mode {indices[0]} does not oscillate: it has no logarithmic decrement",
                           f"ask for decay[{indices[0]}]")
    return tau * zeta / sqrt((1 - zeta) * (1 + zeta)), 4 * error


def _sensitivity(problem, indices, attribute):
    mode, name = _oscillating(problem, indices[:1], "sensitivity"), indices[1]
    if mode.rigid:
        raise PhysicsError(f"mode {indices[0]} is a rigid-body mode: its frequency has no sensitivity",
                           "ask for that of a mode which oscillates")
    found = problem.modal.sensitivities
    if name in found.refused:
        raise PhysicsError(found.refused[name], "see `vibcli solve --insight`")
    rate = found.omega[name][mode.index]
    if rate is None:
        raise PhysicsError(f"mode {indices[0]} coincides with another one, and they are gyroscopic",
                           "derivatives of such modes are not found")
    return rate, ROUNDING


def _estimate(which):
    def value(problem, indices, attribute):
        return getattr(problem.modal.estimates, which), ROUNDING
    return value


VALUES = {
    "omega": _omega, "frequency": _frequency, "period": _period, "growth_rate": _growth_rate, "mode": _shape,
    "zeta": _of_damped("zeta", "damping ratio"), "omega_d": _of_damped("omega_d", "damped frequency"),
    "decay": _of_damped("decay", "decay"), "eigenvalue": _eigenvalue, "decrement": _decrement,
    "sensitivity": _sensitivity, "rayleigh": _estimate("rayleigh"), "dunkerley": _estimate("dunkerley"),
}
