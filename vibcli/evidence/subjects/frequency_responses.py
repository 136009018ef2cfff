"""Frequency responses at a frequency, and their peaks."""

import math
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import mpmath

from vibcli.base.errors import PhysicsError
from vibcli.evidence.reference import frequency_response as reference
from vibcli.evidence.reference import member_responses, steady_state
from vibcli.evidence.reference.settled import relative_error
from vibcli.evidence.subject import ALONE, MethodAnswer, Subject
from vibcli.quantities.cycle_count import counts_cycles
from vibcli.quantities.expression import argument_in_letters, measure, number_of
from vibcli.symbolic.evaluation import evaluate, multiprecision
from vibcli.symbolic.syntax import NameRef, QuantityRef, parts_of

if TYPE_CHECKING:
    from vibcli.results.problem import Problem


READ: dict[str, Callable[[float], Callable]] = {        # of X about a middle
    "amplitude": lambda middle: abs, "rms": lambda middle: lambda X: math.sqrt(middle**2 + abs(X) ** 2 / 2)}


def at_frequency(problem: "Problem", tree: QuantityRef) -> Subject:
    """frf[x, F](Ω), a complex number, or transmissibility[x, F](Ω), its size."""
    if not tree.args:
        raise PhysicsError(f"'{tree.text}' is a function of frequency", f"write {tree.text}(5 Hz)")
    if parts_of(tree.args[0]).quantities:
        raise PhysicsError("its frequency is another quantity, of which a reference would be needed first")
    node, cycles = argument_in_letters(problem, tree.args[0]), counts_cycles(problem.spec, tree.args[0])

    def Omega() -> Any:
        found, = evaluate([node], multiprecision(), problem.numeric.values(multiprecision()))
        return 2 * mpmath.pi * found if cycles else found

    members = bool(problem.configuration.linear_system.pieces)
    read: Callable = abs if tree.head == "transmissibility" else complex
    with mpmath.workdps(30):
        if members:
            curve = member_responses.in_floats(member_responses.transfer(problem, *tree.indices))
        else:
            curve = reference.in_floats(reference.transfer(problem, *tree.indices))
    signal, driver = tree.indices
    true = (member_responses.value if members else reference.value)(problem, signal, driver, Omega)
    if tree.head == "transmissibility":
        with mpmath.workdps(true.working):
            true = true._replace(values=[abs(true.values[0])])
    return _subject(problem, tree, "member response" if members else "response", "frequency response at a frequency",
                    true, (curve, number_of(problem, tree.args[0]), read))


def peak(problem: "Problem", tree: QuantityRef) -> Subject:
    """peak[i](frf[x, F]).value or .Omega"""
    indices, number = tree.args[0].indices, int(tree.indices[0])
    measure(problem, tree)          # refuses a peak without bound, or one that there is not
    true = reference.peak(problem, *indices, number, tree.component == "Omega")
    with mpmath.workdps(30):
        curve = reference.in_floats(reference.transfer(problem, *indices))
    data = curve, number, tree.component == "Omega"
    return _subject(problem, tree, "peak", "peak of a frequency response", true, data)


def of_part(problem: "Problem", tree: QuantityRef) -> Subject:
    """re, im, arg or phase of frf[x, F](Ω), by that complex number."""
    inner = tree.args[0] if tree.args else None
    if getattr(inner, "head", None) != "frf":
        raise PhysicsError(ALONE)
    return at_frequency(problem, inner)


def amplitude(problem: "Problem", tree: QuantityRef) -> Subject:
    """amplitude(x) or rms(x) of a coordinate or a rate of it, under loads of one frequency."""
    if problem.response.KIND != "small":
        raise PhysicsError("no reference is found of steady states of this kind of motion")
    signal = tree.args[0]
    if not isinstance(signal, NameRef) or signal.name not in problem.scene.coordinates or signal.primes > 2:
        raise PhysicsError("a reference of steady states is found of coordinates and their rates alone")
    known = steady_state.driven(problem)
    true = steady_state.feature(known, signal.name, signal.primes, tree.head)
    with mpmath.workdps(30):
        exact, Omega = steady_state.transfer(known, signal.name, signal.primes)
        middle = steady_state.middle(known, signal.name, signal.primes) if tree.head == "rms" else 0
    data = reference.in_floats(exact), float(Omega), READ[tree.head](float(middle))
    return _subject(problem, tree, "response", "steady state under loads of one frequency", true, data)


def _subject(problem, tree, kind, title, true, data):
    def ours() -> MethodAnswer:
        value, bound = measure(problem.afresh(), tree)
        return MethodAnswer([value], float(bound))

    return Subject(kind, tree.text, title, problem, true, ours, data, relative_error)
