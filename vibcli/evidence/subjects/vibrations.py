"""What is read off the vibrations in a signal: how large they are and how they die out, their beats and envelopes."""

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import mpmath

from vibcli.base.errors import PhysicsError
from vibcli.evidence.reference import vibrations
from vibcli.evidence.reference.motion import small
from vibcli.evidence.reference.outputs import signal
from vibcli.evidence.subject import Subject, of_signal
from vibcli.symbolic.evaluation import evaluate, multiprecision
from vibcli.symbolic.parser import parse
from vibcli.symbolic.semantics import lower

if TYPE_CHECKING:
    from vibcli.evidence.reference.settled import TrueValues
    from vibcli.evidence.reference.vibrations import Vibrations
    from vibcli.results.problem import Problem
    from vibcli.symbolic.syntax import QuantityRef

KIND = "vibrations"
SENSES = {"max": 1, "min": -1, "argmax": 1, "argmin": -1}
READ: dict[str, Callable[..., Any]] = {       # of [(a, λ)], y = Re a e^{λt} = |a| cos(ωt − φ)
    "amplitude": lambda waves: abs(waves[0][0]),
    "phase": lambda waves: -mpmath.arg(waves[0][0]),
    "decrement": lambda waves: -2 * mpmath.pi * mpmath.re(waves[0][1]) / mpmath.im(waves[0][1]),
}


def of_one(problem: "Problem", tree: "QuantityRef") -> Subject:
    """amplitude(x), phase(x), decrement(x) of the one free vibration; time_to[f](x) and cycles_to[f](x)."""
    known = _of(problem, tree.args[0])
    look = READ.get(tree.head) or _falling(problem, tree)
    return _subject(problem, tree, "the one free vibration", vibrations.read(known, look, int(tree.head == "phase")))


def _falling(problem: "Problem", tree: "QuantityRef") -> Callable[[list[tuple[mpmath.mpc, mpmath.mpc]]], mpmath.mpf]:
    """The time in which it falls to a fraction, or the number of cycles in that."""
    fraction = exact(problem, parse(tree.indices[0]))

    def look(waves: "Sequence[tuple[mpmath.mpc, mpmath.mpc]]") -> mpmath.mpf:
        rate = waves[0][1]
        if not mpmath.re(rate) < 0 < fraction() < 1:
            raise PhysicsError("a reference is found of what falls to a fraction between 0 and 1")
        time = mpmath.log(fraction()) / mpmath.re(rate)
        return time if tree.head == "time_to" else time * mpmath.im(rate) / (2 * mpmath.pi)

    return look


def beats(problem: "Problem", tree: "QuantityRef") -> Subject:
    """beat_period(x) with what a load keeps up."""
    return _subject(problem, tree, "beats, by the difference of their frequencies",
                    vibrations.beat_period(_of(problem, tree.args[0])))


def of_envelope(problem: "Problem", tree: "QuantityRef") -> Subject:
    """A value, max, min, argmax, argmin or zero of envelope(x)."""
    known, until = _of(problem, tree.args[0].args[0]), mpmath.mpf(problem.response.until)
    if tree.head in SENSES:
        true = vibrations.envelope_extreme(known, until, SENSES[tree.head], tree.head.startswith("arg"))
    elif tree.head == "zero":
        true = vibrations.envelope_zero(known, until, int(tree.indices[0]))
    else:
        true = vibrations.envelope_at(known, exact(problem, tree.args[1]), until)
    return _subject(problem, tree, "the envelope of vibrations", true)


def exact(problem: "Problem", tree: Any) -> Callable[[], Any]:
    """Gives an expression of parameters, such as an instant, at the working precision."""
    node = lower(tree, problem.scene.table, lambda name, *_: problem.scene.parameters.nodes[name])

    def found() -> mpmath.mpf:
        numbers = multiprecision()
        return evaluate([node], numbers, problem.numeric.values(numbers))[0]

    return found


def _of(problem: "Problem", tree: "QuantityRef") -> "Vibrations":
    """The Vibrations in a signal."""
    if problem.response.KIND != "small" or problem.scene.pieces:
        raise PhysicsError("no reference is found of vibrations in this kind of motion")
    return vibrations.Vibrations(*signal(problem, small(problem), tree))


def _subject(problem: "Problem", tree: "QuantityRef", title: str, true: "TrueValues") -> Subject:
    return of_signal(KIND, problem, tree, title, true, None)
