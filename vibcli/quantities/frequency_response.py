"""Numbers of frequency responses: their values at a frequency, peaks, half-power points, fixed points."""

import cmath
from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.base import units
from vibcli.base.errors import LostDigits, PhysicsError
from vibcli.quantities.dimensions import checker
from vibcli.quantities.precise_numbers import found_response, settled_on_curve, settled_response
from vibcli.quantities.quantity import COMPLEX, ROUNDING, Declaration, one
from vibcli.quantities.signal_dimensions import input_dimension, output_dimension
from vibcli.results.signal_features import wrapped

if TYPE_CHECKING:
    from fractions import Fraction

    import mpmath

    from vibcli.language.spec import Spec
    from vibcli.results.frequency_response import FrequencyResponse
    from vibcli.results.problem import Problem
    from vibcli.symbolic.syntax import QuantityRef

    Dimension = Callable[[Spec, QuantityRef], Mapping[str, Fraction | int] | None]
    Value = Callable[[Problem, QuantityRef, Sequence[Any]], tuple[Any, float]]

MODAL = 1e-10      # relative, of the residues of a sum of modes


def _frf(problem: "Problem", tree: "QuantityRef", args: Sequence[float]) -> tuple[Any, float]:
    if not tree.args:
        raise PhysicsError(f"'{tree.text}' is a function of frequency", f"write {tree.text}(5 Hz)")
    try:
        found, error = problem.frequency_response(*tree.indices).at(args[0])
    except LostDigits as refusal:
        return found_response(problem, tree, refusal)
    if problem.rough:
        return found, error
    return settled_response(problem, tree, found, error)


def _modal_frf(problem: "Problem", tree: "QuantityRef", args: Sequence[Any]) -> tuple[Any, float]:
    count, *curve = tree.indices
    return problem.frequency_response(*curve).by_modes(int(count), args[0]), MODAL


def _truncation(problem: "Problem", tree: "QuantityRef", args: Sequence[Any]) -> tuple[Any, float]:
    count, *curve = tree.indices
    response = problem.frequency_response(*curve)
    exact, error = response.at(args[0])
    off = abs(response.by_modes(int(count), args[0]) - exact) / abs(exact)
    return off, min(1.0, (error + MODAL) / (off or 1.0))


def _complex_part(part: Callable[..., float],
                  place: int) -> "Value":
    """A part of a complex number, which its error may fall on whole however small it is; not of an eigenvalue."""
    def value(problem: "Problem", tree: "QuantityRef", args: "Sequence[Any]") -> "tuple[Any, float]":
        found, error = args[0]
        number = part(found)
        if tree.args[0].head == "eigenvalue" and number:
            from vibcli.quantities.damped import bound_of_part

            return number, bound_of_part(problem, tree.args[0], place)
        return number, error * abs(found) / (abs(number) or abs(found) or 1.0)
    return value


def _angle(sign: int) -> "Value":
    """The angle of a complex number times 1 or −1, which is off by as much as the number is of its size."""
    def value(problem: "Problem", tree: "QuantityRef", args: "Sequence[Any]") -> "tuple[Any, float]":
        found, error = args[0]
        angle = wrapped(sign * cmath.phase(found)) if problem.digits is None else _precise_angle(sign, found)
        return angle, error / (abs(angle) or 1.0)
    return value


def _precise_angle(sign: int, found: "mpmath.mpc") -> "mpmath.mpf":
    import mpmath

    angle = sign * mpmath.arg(found)
    return angle if angle > -mpmath.pi else +mpmath.pi


def _transmissibility(problem: "Problem", tree: "QuantityRef", args: Sequence[Any]) -> tuple[Any, float]:
    value, error = _frf(problem, tree, args)
    return abs(value), error


def _of_curve(find: "Callable[[FrequencyResponse, int, str], tuple[Any, Callable[[], Any]]]") -> "Value":
    """The value of what `find` gives with a function for its relative error."""
    def value(problem: "Problem", tree: "QuantityRef", args: "Sequence[Any]") -> "tuple[Any, float]":
        curve = problem.frequency_response(*tree.args[0].indices)
        found, error = find(curve, int(tree.indices[0]), tree.component)
        if problem.rough:
            return found, 0.0
        return settled_on_curve(problem, tree, found, min(1.0, max(ROUNDING, error())))
    return value


def _peak(curve: "FrequencyResponse", number: int, attribute: str) -> tuple[Any, Callable[[], Any]]:
    Omega, value, _ = curve.peak(number)
    if attribute != "Omega" and value is None:
        raise PhysicsError("an undamped peak has no bound", f"add damping, or ask for peak[{number}](…).Omega")
    if attribute == "Omega":
        return Omega, lambda: curve.error_of_peak(number)[0] / Omega
    return value, lambda: curve.error_of_peak(number)[1]


def _antiresonance(curve: "FrequencyResponse", number: int, attribute: str) -> tuple[Any, Callable[[], Any]]:
    Omega = curve.antiresonance(number)
    return Omega, lambda: curve.error_of_antiresonance(Omega) / Omega


def _half_power(curve: "FrequencyResponse", number: int, attribute: str) -> tuple[Any, Callable[[], Any]]:
    peak, side = (number + 1) // 2, (number + 1) % 2
    Omega = curve.half_power_of(peak)[side]
    return Omega, lambda: curve.errors_of_half_power(peak)[side] / Omega


def _fixed_point(problem: "Problem", tree: "QuantityRef", args: Sequence[Any]) -> tuple[float, float]:
    number, damper = tree.indices
    curve = problem.frequency_response(*tree.args[0].indices)
    point = _numbered(curve.fixed_points(damper), int(number), "fixed point")
    off, relative = curve.error_of_fixed_point(damper, point.Omega)
    error = off / point.Omega if tree.component == "Omega" else relative
    return getattr(point, tree.component), min(1.0, max(ROUNDING, error))


def _numbered(items: Sequence[Any], number: int, noun: str) -> Any:
    if number > len(items):
        raise PhysicsError(f"this frequency response has {len(items) or 'no'} {noun}{'s' * (len(items) != 1)}",
                           "ask for one that it has")
    return items[number - 1]


def _ratio(spec: "Spec", tree: "QuantityRef") -> "Mapping[str, Fraction | int] | None":
    """The dimension of an output over that of an input."""
    output, driver = output_dimension(spec, tree.indices[-2]), input_dimension(spec, tree.indices[-1])
    return None if output is None or driver is None else units.times(output, driver, -1)


def _of_argument(spec: "Spec", tree: "QuantityRef") -> "Mapping[str, Fraction | int]":
    return units.RATE if tree.component == "Omega" else checker(spec).dimension(tree.args[0])


def _size(problem: "Problem", tree: "QuantityRef") -> float:
    """Of a response at a frequency; of one as a function it is 0."""
    from vibcli.quantities.expression import measure

    return abs(measure(problem, tree)[0]) if tree.args else 0.0


def _size_of_argument(problem: "Problem", tree: "QuantityRef") -> float:
    return _size(problem, tree.args[0])


def _of_response(about: str, unit: str | None, value: Callable[..., Any], indices: tuple[str, ...] = ("number",),
                 components: tuple[str, ...] = ("",),
                 dimension: "Dimension | None" = None) -> Declaration:
    return Declaration(about, unit, value, indices, ("response",), components, dimension, _size_of_argument)


def _of_value(about: str, value: Callable[..., tuple[float, float]], unit: str | None = None,
              size: Callable[..., float] = _size_of_argument) -> Declaration:
    return Declaration(about, unit, value, args=("complex",), dimension=_of_argument, size=size)


QUANTITIES = {
    "frf": Declaration(
        "complex frequency response of a signal to a unit of a force, of a driven point or body or of the generalised "
        "force on a coordinate: use abs, arg, re, im or phase of it", None, _frf, ("output", "input"), ("Omega",),
        dimension=_ratio, size=_size, kind=COMPLEX, optional=True),
    "transmissibility": Declaration(
        "ratio of amplitudes |frf|", None, _transmissibility, ("output", "input"), ("Omega",), dimension=_ratio,
        size=_size, optional=True),
    "modal_frf": Declaration(
        "the same as a sum of so many modes that oscillate, and of what moves freely", None, _modal_frf,
        ("number", "output", "input"), ("Omega",), dimension=_ratio, kind=COMPLEX),
    "truncation": Declaration(
        "how far such a sum of modes is off, |modal_frf − frf|/|frf|", "1", _truncation, ("number", "output", "input"),
        ("Omega",), size=one),
    "peak": _of_response(
        "i-th peak of |frf|: its place Ω, or its value", None, _of_curve(_peak), components=("Omega", "value"),
        dimension=_of_argument),
    "antiresonance": _of_response(
        "Ω of the i-th zero of the response, or minimum where it is damped", "rad/s",
        _of_curve(_antiresonance)),
    "half_power": _of_response(
        "Ω at which |frf| is 1/√2 of a peak: 1 and 2 below and above the first peak, 3 and 4 the second", "rad/s",
        _of_curve(_half_power)),
    "fixed_point": _of_response(
        "i-th point through which |frf| passes whatever the damper d is, all else being without damping: its place Ω, "
        "or its value", None, _fixed_point, ("number", "damper"), ("Omega", "value"), _of_argument),
    "quality": _of_response(
        "quality of the i-th peak, Ω/(Ω₂ − Ω₁) by its half-power points", "1",
        _of_curve(lambda curve, i, _: (curve.quality(i), lambda: curve.error_of_quality(i)))),
    "arg": _of_value("angle of a complex frequency response, eigenvalue or shape", _angle(1), "rad", size=one),
    "re": _of_value("real part of the same", _complex_part(lambda value: value.real, 0)),
    "im": _of_value("imaginary part of the same", _complex_part(lambda value: value.imag, 1)),
    "phase(frf)": _of_value("lag −arg of a frequency response", _angle(-1), "rad",
                            size=one),
}
