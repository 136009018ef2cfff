"""Frequency responses at a frequency, their peaks, antiresonances and half-power points."""

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import mpmath

from vibcli.base.errors import PhysicsError
from vibcli.evidence.reference import frequency_response as reference
from vibcli.evidence.reference import member_responses, rated_members
from vibcli.evidence.reference.settled import relative_error
from vibcli.evidence.subject import ALONE, MethodAnswer, Subject
from vibcli.evidence.subjects.eigenvalues import natural
from vibcli.quantities.cycle_count import counts_cycles
from vibcli.quantities.expression import measure, number_of
from vibcli.symbolic.evaluation import evaluate, multiprecision
from vibcli.symbolic.semantics import lower
from vibcli.symbolic.syntax import QuantityRef, parts_of

if TYPE_CHECKING:
    from vibcli.evidence.reference.settled import TrueValues
    from vibcli.results.problem import Problem

TITLES = {"peak": "peak", "antiresonance": "antiresonance", "half_power": "half-power point"}


def at_frequency(problem: "Problem", tree: QuantityRef) -> Subject:
    """frf[x, F](Ω), a complex number, or transmissibility[x, F](Ω), its size."""
    if not tree.args:
        raise PhysicsError(f"'{tree.text}' is a function of frequency", f"write {tree.text}(5 Hz)")
    known, cycles = _asked_elsewhere(problem, tree.args[0]), counts_cycles(problem.spec, tree.args[0])
    node = lower(tree.args[0], problem.scene.table, lambda name, primes, part: problem.scene.table.parameter(
        name, positive=False) if name in known else problem.scene.parameters.nodes[name])

    def Omega() -> Any:
        found, = evaluate([node], multiprecision(), {**problem.numeric.values(multiprecision()), **known})
        return 2 * mpmath.pi * found if cycles else found

    (signal, driver), value = tree.indices, number_of(problem, tree.args[0])
    read: Callable[..., Any] = abs if tree.head == "transmissibility" else complex
    data: tuple[Any, ...]
    if problem.configuration.linear_system.pieces:
        kind, true, data = _of_members(problem, signal, driver, Omega)
    else:
        kind, true = "response", reference.value(problem, signal, driver, Omega)
        with mpmath.workdps(30):
            data = reference.in_floats(reference.transfer(problem, signal, driver)),
    if tree.head == "transmissibility":
        with mpmath.workdps(true.working):
            true = true._replace(values=[abs(true.values[0])])
    return _subject(problem, tree, kind, "frequency response at a frequency", true, (*data, value, read))


def _of_members(problem: "Problem", signal: str, driver: str,
                Omega: Callable[[], Any]) -> "tuple[str, TrueValues, tuple[Any, ...]]":
    """(kind, TrueValues, what finite elements are given)."""
    def unit() -> "dict[int, mpmath.mpf]":
        return member_responses.given_by(problem, driver)(Omega())

    if problem.spec.get("damping") is None:
        return ("member response", member_responses.value(problem, signal, driver, Omega),
                (*member_responses.driven_in_floats(problem, signal, unit), None))
    true = rated_members.at_frequency(problem, signal, Omega, unit, mpmath.mpc)
    return "rated response", true, (*member_responses.driven_in_floats(problem, signal, unit, True),
                                    rated_members.damping_of(problem, signal))


def _asked_elsewhere(problem: "Problem", tree: QuantityRef) -> dict[str, mpmath.mpf]:
    """{omega[1]: number …} of what a frequency is made of besides parameters."""
    found = {}
    for part in parts_of(tree).quantities:
        if part.head not in ("omega", "frequency") or len(part.indices) > 1:
            raise PhysicsError("its frequency is another quantity, of which a reference would be needed first")
        true = natural(problem, part).true
        with mpmath.workdps(true.working):
            rate = mpmath.im(true.values[int(part.indices[0]) - 1])
            found[part.text] = rate / (2 * mpmath.pi) if part.head == "frequency" else rate
    return found


def of_curve(problem: "Problem", tree: QuantityRef) -> Subject:
    """peak[i](frf[x, F]).value or .Omega, antiresonance[i](frf[x, F]), half_power[i](frf[x, F])."""
    indices, number, feature = tree.args[0].indices, int(tree.indices[0]), tree.component or tree.head
    near, _ = measure(problem, tree)        # refuses a peak without bound, or one that there is not
    if tree.head == "antiresonance":
        true = reference.antiresonance(problem, *indices, near)
        number = true.about
    elif tree.head == "half_power":
        true = reference.half_power(problem, *indices, number)
    else:
        true = reference.peak(problem, *indices, number, feature == "Omega")
    with mpmath.workdps(30):
        curve = reference.in_floats(reference.transfer(problem, *indices))
    return _subject(problem, tree, "peak", f"{TITLES[tree.head]} of a frequency response", true,
                    (curve, number, feature))


def of_part(problem: "Problem", tree: QuantityRef) -> Subject:
    """re, im, arg or phase of frf[x, F](Ω), by that complex number."""
    if getattr(tree.args[0], "head", None) != "frf":
        raise PhysicsError(ALONE)
    return at_frequency(problem, tree.args[0])


def _subject(problem: "Problem", tree: QuantityRef, kind: str, title: str, true: "TrueValues",
             data: tuple[Any, ...]) -> Subject:
    def ours() -> MethodAnswer:
        value, bound = measure(problem.afresh(), tree)
        return MethodAnswer([value], float(bound))

    return Subject(kind, tree.text, title, problem, true, ours, data, relative_error)
