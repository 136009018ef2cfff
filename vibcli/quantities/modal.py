"""Quantities of modes: frequencies, shapes, damping, sensitivities and estimates."""

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.base import units
from vibcli.base.errors import NotInLetters, PhysicsError
from vibcli.quantities.matrices import entry_dimension
from vibcli.quantities.quantity import COMPLEX, PERIOD, ROUNDING, Declaration, as_asked, counted, full_turn, rounded

if TYPE_CHECKING:
    from fractions import Fraction

    import mpmath

    from vibcli.analyses.modal.stacked_modes import SwingingModes
    from vibcli.analyses.modal.undamped import Mode
    from vibcli.language.signal_names import SignalName
    from vibcli.language.spec import Spec
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node
    from vibcli.symbolic.syntax import QuantityRef


CLOSE, SHAPE, LOST = 1e-4, 1e-11, 6     # relative gap of eigenvalues below which shapes lose digits; their error; these


def _mode(problem: "Problem", tree: "QuantityRef") -> "Mode | SwingingModes":
    modes = problem.modal.modes if problem.digits is None else problem.modal.modes_to(problem.digits)
    number = int(tree.indices[0])
    if not modes:
        raise PhysicsError(f"there is no mode {number}: {problem.configuration.linear_system.why_modeless}",
                           "ask for decay[1] or eigenvalue[1]")
    found: Sequence[Mode | SwingingModes] = modes.numbered(number, number)
    if not found:
        raise PhysicsError(f"there is no mode {number}: this scene has {counted(len(modes), 'mode')}",
                           "ask for one that it has")
    return found[0]


def _oscillating(problem: "Problem", tree: "QuantityRef", what: str) -> "Mode | SwingingModes":
    mode, number = _mode(problem, tree), tree.indices[0]
    if mode.omega is None:
        raise PhysicsError(f"mode {number} is unstable: it has a growth rate, no {what}",
                           f"ask for growth_rate[{number}] or stable")
    return mode


def _omega(problem: "Problem", tree: "QuantityRef", args: Sequence[Any]) -> tuple[Any, Any]:
    mode = _oscillating(problem, tree, "frequency")
    return as_asked(problem, mode.omega), mode.error


def _frequency(problem: "Problem", tree: "QuantityRef", args: Sequence[Any]) -> tuple[Any, Any]:
    omega, error = _omega(problem, tree, args)
    return omega / full_turn(problem), rounded(problem, error)


def _period(problem: "Problem", tree: "QuantityRef", args: Sequence[Any]) -> tuple[Any, Any]:
    mode, number = _oscillating(problem, tree, "period"), tree.indices[0]
    if mode.rigid:
        raise PhysicsError(f"mode {number} is a rigid-body mode: it has no period", f"ask for omega[{number}]: 0 rad/s")
    return full_turn(problem) / as_asked(problem, mode.omega), rounded(problem, mode.error)


def _growth_rate(problem: "Problem", tree: "QuantityRef", args: Sequence[Any]) -> tuple[Any, Any]:
    mode, number = _mode(problem, tree), tree.indices[0]
    if mode.growth_rate is None:
        raise PhysicsError(f"mode {number} does not grow: it is not unstable", f"ask for omega[{number}]")
    return as_asked(problem, mode.growth_rate), mode.error


def largest(problem: "Problem", tree: "QuantityRef") -> float:
    """The largest angular frequency or growth rate."""
    return max((float(mode.omega or mode.growth_rate or 0.0) for mode in problem.modal.modes.shown()), default=0.0)


def ten(problem: "Problem", tree: "QuantityRef") -> float:
    """Of amplitudes and damping ratios a digit more is lost."""
    return 10.0


def _shape(problem: "Problem", tree: "QuantityRef", args: Sequence[Any]) -> tuple[Any, float]:
    from vibcli.language.member_signals import OF_COORDINATES
    from vibcli.language.signal_names import signal_name

    signal = problem.spec.coordinate_name(tree.indices[1]) or tree.indices[1]
    mode = problem.modal.told_apart(_mode(problem, tree))
    shape, placed = problem.modal.shape(mode), signal_name(signal)
    if placed.name in problem.spec.members and placed.kind not in OF_COORDINATES:
        return amplitude_as_asked(problem, *_along_member(problem, mode, placed))
    amplitude, error = amplitude_as_asked(problem, along(problem, shape, signal), shape)
    return amplitude, min(1.0, error * max(1.0, CLOSE / problem.modal.apart(mode)))


def _along_member(problem: "Problem", mode: "Mode", signal: "SignalName") -> tuple[float, list[float]]:
    """(amplitude of a signal of a place on a member, [how large it is elsewhere on the member])."""
    from vibcli.mechanics.inputs_outputs.displacements import signal_of_place
    from vibcli.symbolic.evaluation import Floats, evaluate

    scene = problem.scene.resting
    found, fields = signal_of_place(scene, signal), problem.modal.fields(mode)
    arithmetic, values = Floats, problem.configuration.at_rest
    if problem.digits is not None:
        arithmetic, values = problem.configuration.precise_rest(problem.digits)
    place, factor = evaluate([found.left.place + found.at, found.factor], arithmetic, values)
    unit, member = factor * problem.modal.scale(mode), found.member.name
    return fields.at(member, place)[found.order] * unit, [fields.size(member, found.order) * unit]


def _node(problem: "Problem", tree: "QuantityRef", args: Sequence[Any]) -> tuple[Any, float]:
    number, member, count = int(tree.indices[0]), tree.indices[1], int(tree.indices[2])
    mode = problem.modal.told_apart(_mode(problem, tree))
    fields = problem.modal.fields(mode)
    found = fields.node_places(member)
    if count > len(found):
        known = counted(len(found), "node") if found else "no node"
        raise PhysicsError(f"'{member}' has {known} in mode {number}, its ends and supports not counted",
                           "ask for one that it has" if found else "ask in a higher mode")
    place = found[count - 1]
    off = fields.size(member, 0) / float(abs(fields.at(member, place)[1]))
    exact = SHAPE if problem.digits is None else 10.0 ** (LOST - problem.digits)
    return place, min(1.0, exact * off / float(place))


def amplitude_as_asked(problem: "Problem", amplitude: "complex | mpmath.mpc",
                       shape: "Sequence[complex | mpmath.mpf]") -> "tuple[Any, float]":
    """(amplitude in a shape, relative error bound): a real number where it has no imaginary part. The error is a part
    of the largest amplitude, however small this one is."""
    beside = max(1.0, float(max(map(abs, shape)) / abs(amplitude))) if amplitude else 1.0
    if problem.digits is not None:
        return amplitude, beside * 10.0 ** (LOST - problem.digits)
    return complex(amplitude) if amplitude.imag else float(amplitude.real), beside * SHAPE


def _modal_mass(problem: "Problem", tree: "QuantityRef", args: Sequence[Any]) -> tuple[Any, float]:
    from vibcli.mechanics.inner_products import inner

    configuration, digits, mode = problem.configuration, problem.digits, problem.modal.told_apart(_mode(problem, tree))
    if getattr(mode, "motion", None) is not None:
        found = problem.modal.scale(mode) ** 2
        return as_asked(problem, found), 2 * (SHAPE if digits is None else 10.0 ** (LOST - digits))
    elements = configuration.element_data if digits is None else configuration.precise_system(digits)
    shape = problem.modal.shape(mode)
    if any(amplitude.imag for amplitude in shape):
        raise PhysicsError(f"the coordinates do not move in phase in mode {tree.indices[0]}: it has no modal mass",
                           f"ask for mode[{tree.indices[0]}] of a coordinate")
    found = inner(elements.inertias, elements.M, shape, shape).real
    return as_asked(problem, found), 2 * (SHAPE if digits is None else 10.0 ** (LOST - digits))


def _of_coordinates(spec: "Spec", tree: "QuantityRef") -> "Mapping[str, Fraction | int] | None":
    """Of an entry of M on its diagonal, where all coordinates measure the same."""
    measured = _measured(spec)
    return None if measured is None else entry_dimension("M", measured, measured)


def _measured(spec: "Spec", slopes: bool = False) -> "Mapping[str, Fraction | int] | None":
    """The dimension of all motions that may be 1, of natural modes no slopes of beams; None where they differ."""
    found = [spec.dimensions.of(name) for name in spec.coordinates]
    for section in spec.members.values():
        found += [units.NONE if section == "shafts" else units.LENGTH]
        found += [units.NONE] if slopes and section == "beams" else []
    return found[0] if found and all(one == found[0] for one in found) else None


def of_shape(spec: "Spec", tree: "QuantityRef", slopes: bool = False) -> dict[str, Any] | None:
    """The dimension of an amplitude where all that may be 1 measures the same, `slopes` of beams too; else None."""
    from vibcli.quantities.signal_dimensions import name_dimension

    measured = _measured(spec, slopes)
    name = spec.coordinate_name(tree.indices[1]) or tree.indices[1]
    return None if measured is None else units.times(name_dimension(spec, name), measured, -1)


def along(problem: "Problem", shape: "Sequence[complex | mpmath.mpf]", signal: str) -> "complex | mpmath.mpf":
    """How far a signal moves where the coordinates move by `shape`: Σ (∂s/∂qᵢ) φᵢ."""
    from vibcli.language.signal_names import signal_name
    from vibcli.mechanics.inputs_outputs.displacements import displacement
    from vibcli.symbolic.derivatives import gradient
    from vibcli.symbolic.evaluation import Floats, evaluate

    scene = problem.scene.resting
    if signal in scene.coordinates:
        return shape[scene.coordinates.index(signal)]
    node = displacement(scene, signal)
    if node is None and signal_name(signal).name in problem.spec.members:
        raise PhysicsError(f"the shape between stations that '{signal}' asks for is found of undamped modes alone",
                           "ask for a place where something is attached, or for mode[1]")
    if node is None:
        raise PhysicsError(f"'{signal}' is a force: it has no amplitude in a mode", "ask for a place, turn or stretch")
    slopes, configuration = gradient(node), problem.configuration
    arithmetic, values = Floats, configuration.at_rest
    if problem.digits is not None:
        arithmetic, values = configuration.precise_rest(problem.digits)
    values = evaluate([slopes.get(q, scene.table.zero) for q in scene.q], arithmetic, values)
    return sum(slope * x for slope, x in zip(values, shape, strict=True))


def _sensitivity(problem: "Problem", tree: "QuantityRef", args: Sequence[Any]) -> tuple[float, float]:
    mode, (number, name) = _oscillating(problem, tree, "sensitivity"), tree.indices
    if mode.rigid:
        raise PhysicsError(f"mode {number} is a rigid-body mode: its frequency has no sensitivity",
                           "ask for that of a mode which oscillates")
    found = problem.modal.result("sensitivities")
    if name in found.refused:
        raise PhysicsError(found.refused[name], "see `vibcli solve --insight`")
    rate = found.omega[name][mode.index]
    if rate is None:
        raise PhysicsError(f"mode {number} coincides with another one, and they are gyroscopic",
                           "derivatives of such modes are not found")
    return rate, ROUNDING


def _estimate(which: str) -> Callable[..., Any]:
    def value(problem: "Problem", tree: "QuantityRef", args: "Sequence[Any]") -> "tuple[float, float]":
        found = problem.modal.result("estimates")
        return getattr(found, which), found.error
    return value


def _of_deflection(problem: "Problem", tree: "QuantityRef", args: Sequence[Any]) -> tuple[Any, float]:
    found = problem.modal.rayleigh_quotient(tree.indices[0], problem.digits)
    return as_asked(problem, found), ROUNDING if problem.digits is None else 10.0 ** (LOST - problem.digits)


def _ritz(problem: "Problem", tree: "QuantityRef", args: Sequence[Any]) -> tuple[float, float]:
    modes, number = problem.modal.result("ritz").modes, int(tree.indices[0])
    if number > len(modes):
        raise PhysicsError(f"there is no Ritz estimate {number}: `find` assumes {counted(len(modes), 'shape')}",
                           "assume more, or ask for one that there is")
    mode = modes[number - 1]
    if mode.omega is None:
        raise PhysicsError(f"the square of Ritz estimate {number} is negative: the equilibrium is unstable",
                           "ask for growth_rate[1] or stable")
    return mode.omega, ROUNDING


def one_degree(problem: "Problem") -> "list[Node]":
    """M, C, K of a scene with one coordinate, in letters."""
    if len(problem.scene.q) != 1 or problem.scene.pieces:
        raise NotInLetters("this is found in letters for one degree of freedom")
    M, C, _, K = problem.symbolic.matrices
    zero = problem.scene.table.zero
    return [matrix.get((0, 0), zero) for matrix in (M, C, K)]


def in_letters(form: "Callable[..., Node]") -> "Callable[[Problem, QuantityRef], Node]":
    """`form(m, c, k, omega, table)` of a scene with one coordinate."""
    def symbolic(problem: "Problem", tree: "QuantityRef") -> "Node":
        from vibcli.symbolic.normal_form import textbook
        from vibcli.symbolic.radicals import root

        if tree.indices != ("1",):
            raise NotInLetters(f"'{tree.text}' is found in numbers")
        m, c, k = one_degree(problem)
        return form(m, c, k, root(textbook(k / m), [problem.scene.sample]), problem.scene.table)
    return symbolic


QUANTITIES = {
    "omega": Declaration(
        "natural angular frequency of mode i, the dampers left out", "rad/s", _omega, ("mode",), size=largest,
        several=True, at_once=True, symbolic=in_letters(lambda m, c, k, omega, table: omega)),
    "frequency": Declaration(
        "natural frequency of mode i", "Hz", _frequency, ("mode",), size=largest, several=True, at_once=True,
        symbolic=in_letters(lambda m, c, k, omega, table: omega / (2 * table.pi))),
    "period": Declaration(
        "period of mode i; period(x): of the motion of a signal", "s", _period, ("mode",), several=True,
        at_once=True, kind=PERIOD, symbolic=in_letters(lambda m, c, k, omega, table: 2 * table.pi / omega)),
    "growth_rate": Declaration(
        "growth rate of unstable mode i", "1/s", _growth_rate, ("mode",), size=largest, several=True),
    "mode": Declaration(
        "amplitude of a coordinate or signal in mode i, the first coordinate that moves being 1, where none does the "
        "largest displacement of the first member that moves", None, _shape,
        ("mode", "signal"), size=ten, kind=COMPLEX, dimension=of_shape),
    "node": Declaration(
        "place of the k-th node of mode i on a member, from its left end, ends and supports not counted", "m", _node,
        ("mode", "member", "node"), size=lambda problem, tree: 1.0),
    "modal_mass": Declaration(
        "φᵀMφ of mode i, ∫ μ φ² dx of members included, the first coordinate that moves being 1, where none does the "
        "largest displacement of the first member that moves: a mass, or a moment of inertia", None, _modal_mass,
        ("mode",), dimension=_of_coordinates, several=True,
        symbolic=in_letters(lambda m, c, k, omega, table: m)),
    "sensitivity": Declaration(
        "derivative of the natural angular frequency of mode i by a parameter p that is not defined by others, the "
        "shift of the equilibrium included", None, _sensitivity, ("mode", "parameter"),
        dimension=lambda spec, tree: units.times(units.RATE, spec.dimensions.of(tree.indices[1]), -1)),
    "rayleigh": Declaration(
        "Rayleigh's estimate of omega[1] by the static deflection, an upper bound; rayleigh[x^2]: of a scene with one "
        "member, whose deflection is that function of the place x from its left end, what holds to it going along",
        "rad/s", _estimate("rayleigh")),
    "rayleigh[]": Declaration(
        "rayleigh[x^2]: Rayleigh's quotient of a scene with one member whose deflection (of shafts its turn) is that "
        "function of the place x from its left end, an upper bound of omega[1]; what holds to it goes along", "rad/s",
        _of_deflection, ("shape",)),
    "dunkerley": Declaration("Dunkerley's estimate of omega[1], a lower bound", "rad/s", _estimate("dunkerley")),
    "ritz": Declaration(
        "Ritz's estimate of omega[i] by the shapes that `find` assumes, an upper bound", "rad/s", _ritz, ("mode",)),
}
