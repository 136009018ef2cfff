"""The period of beats of a free motion, T = 2π/|ω₁ − ω₂|, of two modes whose rates others find, too."""

from typing import TYPE_CHECKING, Any

import mpmath

from vibcli.base.errors import PhysicsError
from vibcli.evidence.reference.settled import TrueValues
from vibcli.evidence.subject import MethodAnswer, Subject
from vibcli.evidence.subjects.eigenvalues import damped, natural
from vibcli.evidence.subjects.vibrations import beats
from vibcli.quantities.expression import measure
from vibcli.results.signal_features import beating, kept_up

if TYPE_CHECKING:
    from collections.abc import Sequence

    from vibcli.results.problem import Problem
    from vibcli.symbolic.syntax import QuantityRef

ALIKE = 1e-8        # relative: frequencies in floats and in more digits


def between_modes(problem: "Problem", tree: "QuantityRef") -> Subject:
    """Of the two modes that beat, by what finds all of them."""
    measure(problem, tree)          # refused where there are none
    if kept_up(problem.response.signal(tree.args[0])):
        return beats(problem, tree)
    subject = (damped if problem.modal.damps else natural)(problem, None)
    pair = beating(problem.response.signal(tree.args[0]))
    true = subject.true.values
    with mpmath.workdps(subject.true.working):
        places = [min(range(len(true)), key=lambda i: abs(mpmath.im(true[i]) - part.omega)) for part in pair]
        if any(abs(mpmath.im(true[i]) - part.omega) > ALIKE * part.omega for i, part in zip(places, pair, strict=True)):
            raise PhysicsError("no reference is found of beats with what a load keeps up")
        T = 2 * mpmath.pi / abs(mpmath.im(true[places[0]]) - mpmath.im(true[places[1]]))
    lost = int(mpmath.log10(T * pair[0].omega)) + 1

    def ours() -> MethodAnswer:
        value, bound = measure(problem.afresh(), tree)
        return MethodAnswer([value], bound)

    def error(found: "Sequence[Any]", known: TrueValues) -> float:
        with mpmath.workdps(known.working):
            value = found[0] if len(found) == 1 else _between(found, [true[i] for i in places])
            return float(abs(value / known.values[0] - 1))

    return subject._replace(asked=tree.text, title="beats of two modes, by the difference of their frequencies",
                            true=subject.true._replace(values=[T], digits=subject.true.digits - lost), ours=ours,
                            error=error)


def _between(found: "Sequence[complex]", rates: "Sequence[mpmath.mpc]") -> mpmath.mpf:
    """The period by the numbers found next to these rates."""
    one, two = (min(found, key=lambda x: abs(mpmath.mpmathify(x) - rate)) for rate in rates)
    apart = abs(mpmath.mpf(complex(one).imag) - mpmath.mpf(complex(two).imag))
    return 2 * mpmath.pi / apart if apart else mpmath.inf
