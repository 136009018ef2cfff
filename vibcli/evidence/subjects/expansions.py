"""Coefficients of energies expanded about an equilibrium, and what of forces the geometry of springs makes."""

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, cast

from vibcli.evidence.reference.differences import Function, coefficient, true_coefficient
from vibcli.evidence.reference.static_positions import equations, resting_place
from vibcli.evidence.subject import BY_DIFFERENCES, Subject, of_number
from vibcli.mechanics.configuration import Configuration
from vibcli.mechanics.energies import kinetic, potential
from vibcli.quantities import equilibrium
from vibcli.quantities.expression import measure
from vibcli.quantities.index_kinds import HIGHEST
from vibcli.quantities.products import powers_in
from vibcli.quantities.quantity import about_which, declared
from vibcli.symbolic.derivatives import gradient
from vibcli.symbolic.evaluation import Floats, evaluate, multiprecision

if TYPE_CHECKING:
    import mpmath

    from vibcli.results.problem import Problem
    from vibcli.symbolic.running_errors import RunningErrors
    from vibcli.symbolic.syntax import QuantityRef

FORCES = "of what the geometry of a spring adds to a restoring force"


def of_energy(problem: "Problem", tree: "QuantityRef") -> Subject:
    """V[x^2], T[x^2*x'^2]."""
    return _subject(problem, tree, 0, _energy, "of an energy expanded about the equilibrium")


def of_correction(problem: "Problem", tree: "QuantityRef") -> Subject:
    """stiffness_correction[s, x^3], by the forces of the spring alone."""
    return _subject(problem, tree, 1, _correction, FORCES)


def _subject(problem: "Problem", tree: "QuantityRef", index: int,
             made: "Callable[[Problem, QuantityRef, list[str], Any, dict[str, float | mpmath.mpf]], Any]",
             title: str) -> Subject:
    measure(problem, tree)          # refused where there is none
    asked, which = about_which(tree)
    one = problem if which is None else equilibrium.about(problem, int(which))
    powers = powers_in(problem.spec, asked.indices[index], HIGHEST)
    names = [name + "'" * primes for name, primes in powers]
    units = [one.scene.unit_of(name) for name, _ in powers]
    static = equations(one.configuration)

    def function() -> Function:
        arithmetic = multiprecision()
        known = one.numeric.values(arithmetic)
        place = {**known, **resting_place(one.configuration, static, known)}
        return cast("Function", made(one, asked, names, arithmetic, place))

    size = declared(asked).size(one, asked) or 1.0
    true = true_coefficient(function, list(powers.values()), units, size)
    plain = made(one, asked, names, Floats, one.configuration.at_rest)

    def estimate(step: float) -> float:
        return cast("float", coefficient(plain, list(powers.values()), [step * unit for unit in units]))

    return of_number(BY_DIFFERENCES, one, tree, title, true, estimate, abs(float(true.values[0])) or size,
                     lambda: problem.about(Configuration(problem.numeric)))


def moved(problem: "Problem", names: Sequence[str], arithmetic: Any, rest: Mapping[str, Any]
          ) -> Callable[[Sequence[Any]], Mapping[str, Any]]:
    """Gives {name: number} of everything where some of it is moved by so much."""
    scene = problem.scene.resting
    known = {**{v.name: arithmetic.number(0) for v in scene.v}, **rest, scene.time.name: arithmetic.number(0)}
    return lambda by: {**known, **{name: known[name] + x for name, x in zip(names, by, strict=True)}}


def _energy(problem: "Problem", asked: "QuantityRef", names: list[str], arithmetic: "RunningErrors",
            rest: "dict[str, float | mpmath.mpf]") -> "Callable[..., float | mpmath.mpf]":
    scene = problem.scene.resting
    node, there = {"V": potential, "T": kinetic}[asked.head](scene), moved(problem, names, arithmetic, rest)
    return lambda by: evaluate([node], arithmetic, there(by))[0]


def _correction(problem: "Problem", asked: "QuantityRef", names: list[str], arithmetic: "RunningErrors",
                rest: "dict[str, float | mpmath.mpf]") -> Callable[[Sequence[Any]], Any]:
    """F(s) ∂s/∂x − F(s₀ + s′ξ) (∂s/∂x)₀ of the spring with the deflection s, along the first of the coordinates."""
    scene, at = problem.scene.resting, moved(problem, names, arithmetic, rest)
    terms = scene.terms_of(asked.indices[0], "springs", "laws")
    s, force = tension(scene, terms[0])
    if len(terms) > 1:              # without free length
        s = scene.table.sqrt(scene.table.total(term.s * term.s for term in terms))
    slopes = [gradient(s).get(scene.symbol(name), scene.table.zero) for name in names]
    s0, *first = evaluate([s, *slopes], arithmetic, at([0] * len(names)))

    def along(by: Sequence[Any]) -> Any:
        known = at(by)
        there, slope = evaluate([s, slopes[0]], arithmetic, known)
        straight = s0 + sum(x * y for x, y in zip(first, by, strict=True))
        return force(arithmetic, known, there) * slope - force(arithmetic, known, straight) * first[0]

    return along


def tension(scene: Any, term: Any) -> tuple[Any, Callable[..., Any]]:
    """(its deflection, F(arithmetic, {name: number}, deflection), of a damper a rate) of a term of V or Φ."""
    if hasattr(term, "integral"):
        return term.s, lambda arithmetic, known, s: evaluate(
            [term.derivative], arithmetic, {**known, term.x.name: s})[0]

    def force(arithmetic: Any, known: Mapping[str, Any], s: Any) -> Any:
        N, k = evaluate([term.offset or scene.table.zero, term.weight], arithmetic, known)
        return N + k * s

    return term.s, force
