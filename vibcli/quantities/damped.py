"""Quantities of damped modes: eigenvalues and what is read off them, and complex shapes."""

from collections.abc import Callable, Sequence
from functools import partial
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import NotInLetters, PhysicsError
from vibcli.quantities.modal import (
    CLOSE,
    along,
    amplitude_as_asked,
    in_letters,
    largest,
    of_shape,
    one_degree,
    ten,
)
from vibcli.quantities.quantity import COMPLEX, PERIOD, Declaration, as_asked, counted, full_turn, in_floats, rounded

if TYPE_CHECKING:

    from vibcli.analyses.modal.damped_modes import DampedMode
    from vibcli.results.problem import Problem
    from vibcli.symbolic.expression import Table
    from vibcli.symbolic.node import Node
    from vibcli.symbolic.syntax import QuantityRef

TINY = 1e-5                         # of the largest amplitude


def _pair(problem: "Problem", tree: "QuantityRef") -> "list[DampedMode]":
    """The damped modes of an index, two where it is over-damped; a scene without dampers has none."""
    modes, number = problem.modal.damped, int(tree.indices[0])
    if modes is not None and problem.digits is not None:
        modes = problem.modal.damped_to(problem.digits)
    if modes is None:
        raise PhysicsError("nothing damps this scene: it has no damped modes", "add a damper")
    if not modes:
        raise PhysicsError("this scene has no damped modes: a wave that arrives at the damper dies",
                           "ask for responses in time")
    found = modes.numbered(number, number)
    if not found:
        raise PhysicsError(f"there is no damped mode {number}: this scene has "
                           f"{counted(modes[-1].index, 'damped mode')}", "ask for one that it has")
    return found


def _of_damped(attribute: str,
               words: str) -> "Callable[[Problem, QuantityRef, Sequence[Any]], tuple[Any, Any]]":
    def value(problem: "Problem", tree: "QuantityRef", args: "Sequence[Any]") -> "tuple[Any, Any]":
        pair = _pair(problem, tree)
        number = getattr(pair[0], attribute)
        if number is None:
            raise PhysicsError(f"damped mode {tree.indices[0]} has no {words}",
                               "see `vibcli frequencies` for what it has")
        error = max(one.bounds[attribute == "omega_d"] for one in pair)
        return as_asked(problem, number), rounded(problem, in_floats(problem, error))
    return value


_zeta = _of_damped("zeta", "damping ratio")


def _decrement(problem: "Problem", tree: "QuantityRef", args: Sequence[Any]) -> tuple[Any, Any]:
    zeta, error = _zeta(problem, tree, args)
    if _pair(problem, tree)[0].omega_d is None:
        raise PhysicsError(f"damped mode {tree.indices[0]} does not oscillate: it has no logarithmic decrement",
                           f"ask for decay[{tree.indices[0]}]")
    left = (1 - zeta) * (1 + zeta)
    return full_turn(problem) * zeta / left**0.5, 2 * error / in_floats(problem, left)


def _period(problem: "Problem", tree: "QuantityRef", args: Sequence[Any]) -> tuple[Any, Any]:
    mode, number = _pair(problem, tree)[0], tree.indices[0]
    if mode.omega_d is None:
        raise PhysicsError(f"damped mode {number} does not oscillate: it has no period", f"ask for decay[{number}]")
    omega_d, error = _of_damped("omega_d", "period")(problem, tree, args)
    return full_turn(problem) / omega_d, rounded(problem, error)


def _root(problem: "Problem", tree: "QuantityRef") -> "DampedMode":
    """The DampedMode of an eigenvalue, of two real ones the first or that which is asked for."""
    modes = _pair(problem, tree)
    i, which = tree.indices[0], int(tree.indices[1]) if tree.indices[1:] else 1
    if which > len(modes):
        what, hint = (("oscillates: its eigenvalues are a conjugate pair", f"ask for re and im of eigenvalue[{i}]")
                      if modes[0].omega_d else ("has one real eigenvalue", f"ask for eigenvalue[{i}]"))
        raise PhysicsError(f"damped mode {i} {what}", hint)
    return modes[which - 1]


def bound_of_part(problem: "Problem", tree: "QuantityRef", place: int) -> float:
    """The relative bound of Re λ (0) or Im λ (1)."""
    found: float = in_floats(problem, _root(problem, tree).bounds[place])
    return found


def _eigenvalue(problem: "Problem", tree: "QuantityRef", args: Sequence[Any]) -> tuple[Any, float]:
    mode = _root(problem, tree)
    if problem.digits is not None:
        return mode.eigenvalue if mode.omega_d else mode.eigenvalue.real, mode.error
    return complex(mode.eigenvalue) if mode.omega_d else float(mode.eigenvalue.real), mode.error


def _shape(problem: "Problem", tree: "QuantityRef", args: Sequence[Any]) -> tuple[Any, float]:
    """In more digits, if there are any, where another eigenvalue is close: the error grows with 1/gap. An amplitude
    that is tiny beside the largest has a larger part of that one's error."""
    signal = problem.spec.coordinate_name(tree.indices[1]) or tree.indices[1]
    mode, lost, known = _pair(problem, tree)[0], 1.0, 0.0
    apart = problem.modal.apart(mode)
    if apart < CLOSE:
        told = mode if problem.digits is not None else problem.modal.told_apart(mode)
        mode, lost, known = told, CLOSE / apart if told is mode else 1.0, 4 * mode.error / apart * (told is mode)
    shape = problem.modal.shape(mode)
    amplitude, error = amplitude_as_asked(problem, along(problem, shape, signal), shape)
    most = max(float(abs(x)) for x in shape)
    return amplitude, min(1.0, known + error * max(lost, TINY * most / (float(abs(amplitude)) or most)))


def _omega_d(m: "Node", c: "Node", k: "Node", omega: "Node", table: "Table") -> "Node":
    from vibcli.symbolic.normal_form import textbook

    return table.sqrt(textbook(k / m - c * c / (4 * m * m)))


def _eigenvalue_in_letters(problem: "Problem", tree: "QuantityRef") -> "Node":
    """−δ ± √(δ² − ω²), −K/C without inertia."""
    from vibcli.symbolic.normal_form import textbook

    if tree.indices not in (("1", "1"), ("1", "2")):
        raise NotInLetters(f"'{tree.text}' is found in numbers", "ask for eigenvalue[1,1] or eigenvalue[1,2]")
    m, c, k = one_degree(problem)
    if m.is_zero and not c.is_zero and tree.indices[1] == "1":
        return textbook(-k / c)
    if m.is_zero or not problem.scene.number(c / m) > 0:
        raise NotInLetters(f"'{tree.text}' is found in numbers")
    delta = textbook(c / (2 * m))
    root = problem.scene.table.sqrt(textbook(delta * delta - k / m))
    return root - delta if tree.indices[1] == "1" else -root - delta


QUANTITIES = {
    "zeta": Declaration(
        "damping ratio of damped mode i, by ascending |λ|", "1", _zeta, ("mode",), size=ten, several=True, at_once=True,
        symbolic=in_letters(lambda m, c, k, omega, table: c / (2 * m * omega))),
    "omega_d": Declaration(
        "damped angular frequency of damped mode i", "rad/s", _of_damped("omega_d", "damped frequency"), ("mode",),
        size=largest, several=True, at_once=True, symbolic=in_letters(_omega_d)),
    "period_d": Declaration(
        "period of damped mode i, 2π/ω_d", "s", _period, ("mode",), several=True, at_once=True, kind=PERIOD,
        symbolic=in_letters(lambda m, c, k, omega, table: 2 * table.pi / _omega_d(m, c, k, omega, table))),
    "decay": Declaration(
        "decay ζω of damped mode i: −Re λ, or −(λ₁ + λ₂)/2 where it is over-damped", "1/s",
        _of_damped("decay", "decay"), ("mode",), size=largest, several=True, at_once=True),
    "eigenvalue": Declaration(
        "eigenvalue of damped mode i, λ = −δ + i ω_d: use re, im, abs or arg of it; of an over-damped one j is 1 or 2, "
        "of its two real eigenvalues by ascending |λ|", "1/s", _eigenvalue, ("mode", "root"), kind=COMPLEX, spare=1,
        several=True, symbolic=_eigenvalue_in_letters),
    "mode_d": Declaration(
        "complex amplitude φ of a coordinate or signal in damped mode i, q = Re φ e^{λt}, the first coordinate that "
        "moves being 1, of members alone the first of their places that moves: use re, im, abs or arg of it", None,
        _shape, ("mode", "signal"), size=ten, kind=COMPLEX, dimension=partial(of_shape, slopes=True)),
    "decrement[]": Declaration("logarithmic decrement of damped mode i, 2πζ/√(1 − ζ²)", "1", _decrement, ("mode",),
                               several=True, at_once=True),
}
