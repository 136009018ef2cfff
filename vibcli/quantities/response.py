"""Numbers of responses: values in time, extremes, steady amplitudes, decrements, and frequency responses."""

from math import isfinite, pi, tau

from vibcli.base.errors import PhysicsError
from vibcli.quantities.frequency_response import ERROR, wrapped
from vibcli.quantities.matrices import coordinate_number
from vibcli.quantities.quantity import PARTS
from vibcli.results import signal_features, steady_features
from vibcli.results.signals import LinearSignal
from vibcli.symbolic.derivatives import gradient
from vibcli.symbolic.syntax import QuantityRef

ANGLE = 0.7     # no phasor of an undamped scene is at right angles to it


def measure_response(problem, tree, args):
    """(value, relative error bound) of a number of a signal; `args`: its arguments that are numbers, by their place."""
    try:
        value = VALUES[tree.head](problem, tree, args)
        return value, max(ERROR, _doubt(problem, tree, args, value))
    except PhysicsError as error:
        if error.hint and "(x)" in error.hint:
            error.hint = error.hint.replace("(x)", f"({_found(problem, tree)})")
        raise


def _doubt(problem, tree, args, value):
    """The relative error of a number of a motion that was integrated: of a value in time and of an extreme its own, of
    others that of the motion up to the instant that is found, or up to its end; of a period by quadrature its own."""
    if problem.response.KIND != "full":
        return 0.0
    if tree.head == "period" and problem.response.by_quadrature(tree.args[0]) is not None:
        return problem.response.by_quadrature(tree.args[0])[1]
    if not problem.response.integrated:
        return 0.0
    if tree.head == "value":
        instant = args[1]
    elif tree.head in ("max", "min"):
        instant = _extreme(1 if tree.head == "max" else -1, 0)(problem, tree, args)
    else:
        until = value if tree.head in ("argmax", "argmin", "zero") else problem.response.known
        return problem.response.reaching(until).shared.of_state(until)
    return min(1.0, _signal(problem, tree).error(instant) / (abs(value) or 1e-300))


def _found(problem, tree):
    """The text of the signal that a quantity is asked of, or of that within it which is found: hints speak of x."""
    arg = tree.args[0]
    while isinstance(arg, QuantityRef) and arg.head in PARTS and not _is_found(problem, arg):
        arg = arg.args[0]
    return tree.text[arg.start - tree.start:arg.end - tree.start]


def _is_found(problem, arg):
    import numpy as np

    try:
        problem.response.signal(arg).values(np.zeros(1))
    except PhysicsError:
        return False
    return True


def _signal(problem, tree):
    return problem.response.signal(tree.args[0])


def _value(problem, tree, args):
    import numpy as np

    time = args[1]
    if not time >= 0 or not isfinite(time):
        raise PhysicsError(f"there is no motion at t = {time:.6g} s", "motions start at t = 0")
    return float(_signal(problem, tree).values(np.array([time]))[0])


def _inertia(problem, tree, args):
    """∂²T/∂q̇ᵢ∂q̇ⱼ at an instant of the motion."""
    import numpy as np

    from vibcli.mechanics.energies import kinetic

    scene = problem.scene
    i, j = (scene.v[coordinate_number(problem, index)] for index in tree.indices)
    zero = scene.table.zero
    node = gradient(gradient(kinetic(scene)).get(i, zero)).get(j, zero)
    return float(problem.response.state_signal(node).values(np.array([args[0]]))[0])


def _extreme(sense, which):
    def value(problem, tree, args):
        return _signal(problem, tree).extreme(0.0, problem.response.until, sense)[which]
    return value


def _linear(problem, tree):
    """The signal as a linear output of a small motion."""
    signal = _signal(problem, tree)
    if not isinstance(signal, LinearSignal):
        raise PhysicsError(f"'{tree.head}' is not found of {signal.KIND}", "ask for max(x), min(x) or values in time")
    return signal


def _amplitude(problem, tree, args):
    """Of the steady state that loads keep up, else of the free vibration."""
    signal = _linear(problem, tree)
    if not signal_features.kept_up(signal):
        return signal_features.amplitude(signal)
    if problem.signed and signal.motion.steady.period is None:
        return sum(_signed(X) for _, X in steady_features.harmonics(signal))
    return steady_features.amplitude(signal)


def _signed(X):
    """Re X e^{−iψ}: of a phasor that passes through zero along a line it changes its sign there."""
    from math import cos, sin

    return X.real * cos(ANGLE) + X.imag * sin(ANGLE)


def _phase(problem, tree, args):
    import cmath

    signal = _linear(problem, tree)
    if not signal_features.kept_up(signal):
        return wrapped(signal_features.from_the_start(signal).phase)
    found = steady_features.harmonics(signal)
    if len(found) != 1:
        raise PhysicsError(f"this steady state has no one phase: it holds {len(found) or 'no'} harmonics",
                           "ask for max(steady(x)), or its value at a time")
    return wrapped(-cmath.phase(found[0][1]) - 0.5 * pi)


def _harmonic(problem, tree, args):
    signal = _linear(problem, tree)
    if not signal_features.kept_up(signal):
        raise PhysicsError("no load that repeats itself drives this signal: it has no harmonics", "ask for max(x)")
    return abs(steady_features.harmonic(signal, int(tree.indices[0])))


def _over_a_period(which):
    """Of the steady state that loads keep up, else of the free vibrations that last."""
    def value(problem, tree, args):
        signal = _linear(problem, tree)
        if not signal_features.kept_up(signal):
            return getattr(signal_features, which)(signal)
        return getattr(signal.motion.steady, which)(signal.output)
    return value


def _final(problem, tree, args):
    return _signal(problem, tree).final()


def _overshoot(problem, tree, args):
    import numpy as np

    signal = _signal(problem, tree)
    start, final = signal.values(np.array([0.0]))[0], signal.final()
    if final == start:
        raise PhysicsError("the signal ends where it starts: it has no overshoot", "ask for max(x)")
    sense = 1 if final > start else -1
    top = signal.extreme(0.0, problem.response.until, sense)[1]
    return max(0.0, float((top - final) / (final - start)))


def _zero(problem, tree, args):
    number, signal = int(tree.indices[0]), _signal(problem, tree)
    found = signal.zeros(0.0, problem.response.until)
    if len(found) < number:
        until = problem.response.until
        raise PhysicsError(f"the signal passes through zero {len(found)} times until t = {until:.6g} s",
                           f"later ones, if there are any, are seen with a later end: find: [{{response: {{until: "
                           f"{2 * until:.3g} s}}}}]")
    return found[number - 1]


def _free(find, fraction=False):
    def value(problem, tree, args):
        signal = _linear(problem, tree)
        return find(signal, float(tree.indices[0])) if fraction else find(signal)
    return value


def _period(problem, tree, args):
    """Of the steady state that loads keep up, else of the free vibration."""
    if problem.response.KIND != "small":
        return problem.response.period(tree.args[0])
    signal = _linear(problem, tree)
    if signal_features.kept_up(signal):
        return tau / steady_features.fundamental(signal)
    return signal_features.free_period(signal)


VALUES = {
    "value": _value, "M": _inertia,
    "amplitude": _amplitude, "phase": _phase, "max": _extreme(1, 1), "min": _extreme(-1, 1),
    "argmax": _extreme(1, 0), "argmin": _extreme(-1, 0), "mean": _over_a_period("mean"), "rms": _over_a_period("rms"),
    "final": _final, "overshoot": _overshoot, "harmonic": _harmonic, "zero": _zero, "period": _period,
    "decrement": _free(signal_features.decrement), "beat_period": _free(signal_features.beat_period),
    "time_to": _free(signal_features.time_to, True), "cycles_to": _free(signal_features.cycles_to, True),
}
