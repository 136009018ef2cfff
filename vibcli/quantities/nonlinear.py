"""How the frequency of free motions hangs on their amplitude, and where two equilibria meet as a parameter changes."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from vibcli.base import units
from vibcli.quantities.products import powers_in
from vibcli.quantities.quantity import SIGNAL, Declaration, as_asked, measured, rounded, unit

if TYPE_CHECKING:
    from vibcli.language.spec import Spec
    from vibcli.results.problem import Problem
    from vibcli.symbolic.node import Node
    from vibcli.symbolic.syntax import QuantityRef


def _backbone(problem: "Problem", tree: "QuantityRef", args: Sequence[Any]) -> tuple[float, float]:
    return problem.free_motions.omega(int(tree.indices[0]), tree.args[0], args[1])


def _fold(problem: "Problem", tree: "QuantityRef", args: Sequence[Any]) -> tuple[float, float]:
    found = problem.limit_loads(tree.indices[1]).limit_point(int(tree.indices[0]))
    return as_asked(problem, found.value), rounded(problem, found.error)


def _at_fold(problem: "Problem", tree: "QuantityRef", args: Sequence[Any]) -> tuple[float, float]:
    value, error = problem.limit_loads(tree.indices[1]).at_limit_point(int(tree.indices[0]), tree.args[0])
    return as_asked(problem, value), rounded(problem, error)


def _kappa(problem: "Problem", tree: "QuantityRef", args: Sequence[Any]) -> tuple[Any, float]:
    digits, ((name, _),) = problem.digits, powers_in(problem.spec, tree.indices[1], 2)
    return measured(problem.free_motions.kappa(int(tree.indices[0]), name, digits, unit(problem)),
                    10.0**-digits if digits else 0.0)


def _kappa_in_letters(problem: "Problem", tree: "QuantityRef") -> "Node":
    return problem.free_motions.kappa_in_letters(int(tree.indices[0]))


def _dimension(spec: "Spec", tree: "QuantityRef") -> Any:
    """Over the square of the coordinate."""
    (name, _), = powers_in(spec, tree.indices[1], 2)
    return units.times(units.NONE, spec.dimensions.of(name), -2)


QUANTITIES = {
    "backbone": Declaration(
        "factor κ of the square of the amplitude A of a coordinate, half its range, in the angular frequency "
        "ω ≈ ωᵢ(1 + κA²) of small free motions of family i (Lindstedt and Poincaré), of several degrees of freedom in "
        "numbers and away from internal resonances 1:1, 1:2, 1:3; with two brackets "
        "`backbone[1](x)(10 cm)` is the angular frequency at an amplitude", None, _kappa,
        ("number", "square"), dimension=_dimension, symbolic=_kappa_in_letters, several=True),
    "backbone()": Declaration(
        "angular frequency of the free motion of family i in which a signal has this amplitude, half its range, about "
        "the equilibrium; dampers are left out, and there is none under loads in time", "rad/s", _backbone, ("number",),
        ("signal", "amplitude"), several=True),
    "fold": Declaration(
        "value of a parameter p at which two equilibria meet and vanish (limit point, limit load, snap-through): the "
        "k-th of those that the equilibrium passes when it is followed as p grows and falls, by ascending |p|, equal "
        "ones once; of the sign that p has, of both signs where p has `sign: any`; branchings, where equilibria cross, "
        "are no folds; fold[1, p](x) is the coordinate or signal x there", None, _fold, ("number", "parameter"),
        several=True, dimension=lambda spec, tree: spec.dimensions.of(tree.indices[1])),
    "fold()": Declaration(
        "a coordinate or signal in the equilibrium of that fold", SIGNAL, _at_fold, ("number", "parameter"),
        ("signal",), several=True),
}
