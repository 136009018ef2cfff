"""Small oscillations about a position: rows ∇s and weights of every element, in any arithmetic.

With s(q, t) the scalar functions of the scene, T = ½ Σ w ṡ², V = Σ (N s + ½ k s²) + Σ f s, Φ = ½ Σ c ṡ², δA = Σ F δs:

    M = Σ w ∇s ∇sᵀ + ∂²T/∂q̇²                C + G = Σ c ∇s ∇sᵀ + 2 Σ w ∇s (∂ₜ∇s)ᵀ − Σ ∇s (∂F/∂q̇)ᵀ + ∂²Φ/∂q̇² + …
    r = Σ P ∇s + ∂V/∂q − ∂T/∂q              P = N + k s,  f,  w ∂ₜₜs,  c ∂ₜs,  −F
    K = ∂r/∂q = Σ k ∇s ∇sᵀ + Σ P ∇²s + Σ w ∇s (∂ₜₜ∇s)ᵀ + Σ c ∇s (∂ₜ∇s)ᵀ − Σ ∇s (∂F/∂q)ᵀ + …

Σ P ∇²s is the geometric stiffness of preloads and weights (Kovacić & Radomirović 2018, ch. 2); r = 0 in equilibrium.
G is the skew part of what inertia multiplies the velocities with, C what dampers and loads do. Driven displacements
that oscillate are small like the coordinates: springs, dampers and steady loads are linear in them too, which leaves
them to the excitation; and so are loads that depend on the time, the F₀ in F₀ (1 − cos Ωt) included, which add nothing
to Σ P ∇²s unless it is steady, as where they turn with what they act on.
"""

from collections.abc import Iterable, Mapping, Sequence
from itertools import compress, product
from typing import TYPE_CHECKING, Any, TypeVar

from vibcli.base.errors import PhysicsError
from vibcli.mechanics.linearisation import Linearisation
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.node import BARS
from vibcli.symbolic.normal_form import TooLong, collected, expanded, reduced, textbook
from vibcli.symbolic.rationals import ONE

if TYPE_CHECKING:
    from fractions import Fraction

    from vibcli.mechanics.factored_system import PlacedPiece
    from vibcli.mechanics.linearisation import Key, Matrix, Row
    from vibcli.scene.energy_terms import AppliedLoad, Term
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node

    Kind = TypeVar("Kind", bound=Term)


def linearise(scene: Any, still: bool = False) -> Linearisation:
    """The Linearisation of a scene as functions of the coordinates; `still`: without any excitation, so that what
    depends on the time turns or drifts with a carrier."""
    number = {node: i for i, node in enumerate(scene.q)}
    inertias = scene.at_still("inertias") if still else scene.inertias
    dampers = scene.at_still("dampers")
    (inertias_on, inertias_about), (dampers_on, dampers_about) = (_by_sense(scene, terms) for terms in (
        inertias, dampers))
    moving, damping, springs, curved = _rows(inertias_on, number), _rows(dampers_on, number), [], []
    elastic: list[tuple[Node, Row]] = []
    steady, turning = _by_sense(scene, scene.at_still("springs"))
    for term in steady:
        row = row_of(term.s, number)
        (elastic if hasattr(term, "of_piece") else springs).append((term.weight, row))
        curved.append((term.force(scene), slopes_of(row, number), row))
    for term in scene.weights:
        row = row_of(term.s, number)
        curved.append((term.weight, slopes_of(row, number), row))
    found = Linearisation(len(scene.q), scene.table, moving, springs, damping, curved, *_written_out(scene, number),
                          _pieces(scene, number, elastic))
    for matrix, terms in ((found.M, inertias_about), (found.C, dampers_about)):
        for weight, row in _rows(terms, number):
            for i, j in product(row, repeat=2):
                matrix[i, j] = matrix.get((i, j), scene.table.zero) + weight * row[i] * row[j]
    for term in turning:
        slopes = row_of(term.potential(scene), number)
        found.residual.append(slopes)
        found.K.append(slopes_of(slopes, number))
    _loads(scene, found, number, scene.loads_at_still(), still)
    slips: dict[tuple[int, int], list[Node]] = {}
    if scene.timed:
        for kind, terms in (("inertias", inertias), ("dampers", dampers)):
            for term in terms:
                _driven(scene, found, number, term, kind, slips)
    _split(found, slips, found.G)
    return found


def _by_sense(scene: "Scene", terms: "Sequence[Kind]") -> "tuple[Sequence[Kind], Sequence[Kind]]":
    """Terms (whose s has slopes, whose s turns about, as |u| does: of ½ k s² that is not seen)."""
    if BARS.isdisjoint(scene.table.called):
        return terms, ()
    turns = [any(part.op == "call" and part.name == "sign" for part in reachable(list(gradient(term.s).values())))
             for term in terms]
    return list(compress(terms, (not one for one in turns))), list(compress(terms, turns))


def _pieces(scene: "Scene", number: "dict[Node, int]",
            elastic: "list[tuple[Node, dict[int, Node]]]") -> "list[PlacedPiece]":
    """The PlacedPieces of members."""
    if not scene.pieces:
        return []
    from vibcli.mechanics.placed_pieces import placed_pieces

    return placed_pieces(scene.at_still("pieces"), lambda s: row_of(s, number), elastic)


def linearised_loads(scene: "Scene", terms: "Iterable[AppliedLoad]") -> Linearisation:
    """What some of the loads on a scene are of its Linearisation."""
    found = Linearisation(len(scene.q), scene.table, [], [], [], [], {}, {}, {}, {}, [], [], [])
    _loads(scene, found, {node: i for i, node in enumerate(scene.q)}, terms, False)
    return found


def _loads(scene: "Scene", found: Linearisation, number: "dict[Node, int]", terms: "Iterable[AppliedLoad]",
           still: bool) -> None:
    slips, turning, speeds = {}, {}, {v: i for i, v in enumerate(scene.v)}
    for term in terms:
        _loaded(scene, found, (number, speeds), term, slips, turning, still)
    found.K.append({pair: -without_time(scene, scene.table.total(nodes)) for pair, nodes in turning.items()})
    _split(found, slips, found.drag)


def _loaded(scene: "Scene", found: Linearisation, numbers: "tuple[dict[Node, int], dict[Node, int]]",
            term: "AppliedLoad", slips: "dict[tuple[int, int], list[Node]]",
            turning: "dict[tuple[int, int], list[Node]]", still: bool) -> None:
    """A force F with the virtual work F δs; `turning`: where its parts that hold the time add F ∂²s, of which that
    remains whose time cancels, as of a force that turns with what it acts on."""
    (number, speeds), rest = numbers, scene.rates_at_rest
    row = row_of(term.s, number)
    steady, turning_part, waving, _ = load_at_rest(scene, term)
    curvature, at_once = slopes_of(row, number), turning_part if still else turning_part + waving
    found.curved.append((turning_part - steady, curvature, row))
    if not at_once.is_zero:
        for pair, second in curvature.items():
            turning.setdefault(pair, []).append(at_once * second)
        found.residual.append({i: -(at_once * slope) for i, slope in row.items()})
    by_place, by_speed = row_of(term.weight, number), row_of(term.weight, speeds)
    found.K.append(_at_rest({(i, j): -(x * slope) for i, x in row.items() for j, slope in by_place.items()}, rest))
    for (i, j), node in _at_rest({(i, j): -(x * slope) for i, x in row.items() for j, slope in by_speed.items()},
                                 rest).items():
        slips.setdefault((i, j), []).append(node)


def _driven(scene: "Scene", found: Linearisation, number: "dict[Node, int]", term: "Term", kind: str,
            slips: "dict[tuple[int, int], list[Node]]") -> None:
    """What an inertia or a damper adds where its s(q, t) depends on the time explicitly."""
    first = gradient(term.s).get(scene.time)
    if first is None:
        return
    row = row_of(term.s, number)
    turning, weight = row_of(first, number), term.weight
    if kind == "dampers":
        force, bend = first, turning
    else:
        force = gradient(first).get(scene.time, scene.table.zero)
        bend = row_of(force, number)
        for i, x in row.items():
            for j, slope in turning.items():
                slips.setdefault((i, j), []).append(2 * weight * x * slope)
    found.curved.append((weight * force, slopes_of(row, number), row))
    found.K.append({(i, j): weight * x * slope for i, x in row.items() for j, slope in bend.items()})


def _split(found: Linearisation, slips: "Mapping[tuple[int, int], list[Node]]",
           skew_parts: "dict[tuple[int, int], Node]") -> None:
    """Adds the symmetric part of {(i, j): [terms]} to C, the skew part to `skew_parts`."""
    total = {pair: found.table.total(terms) for pair, terms in slips.items()}
    zero = found.table.zero
    for i, j in {tuple(sorted(pair)) for pair in total}:
        one, two = total.get((i, j), zero), total.get((j, i), zero)
        same, skew = textbook((one + two) / 2), textbook((one - two) / 2)
        for matrix, pairs in ((found.C, {(i, j): same, (j, i): same}), (skew_parts, {(i, j): skew, (j, i): -skew})):
            for pair, node in pairs.items():
                if not node.is_zero:
                    matrix[pair] = matrix.get(pair, zero) + node


def _rows(terms: "Sequence[Term]", number: "dict[Node, int]") -> "list[tuple[Node, dict[int, Node]]]":
    return [(term.weight, row_of(term.s, number)) for term in terms]


def row_of(s: Any, number: "Mapping[Node, int]") -> "dict[int, Node]":
    """{i: ∂s/∂xᵢ} by the symbols {xᵢ: i} in `number`."""
    return {number[x]: slope for x, slope in gradient(s).items() if x in number}


def slopes_of(row: Any, number: Any) -> "dict[tuple[int, int], Node]":
    """{(i, j): ∂rowᵢ/∂xⱼ} by the symbols {xⱼ: j} in `number`."""
    return {(i, number[x]): second for i, slope in row.items() for x, second in gradient(slope).items() if x in number}


def _written_out(scene: "Scene", number: "dict[Node, int]"
                 ) -> "tuple[Matrix, Matrix, Matrix, Matrix, list[Matrix], list[Row]]":
    """What `energies` and `matrices` add: M, C, G, no drag, K, the residual."""
    speeds = {node: i for i, node in enumerate(scene.v)}
    rest = scene.rates_at_rest
    T, V, Phi = (scene.energies[key] for key in ("T", "V", "Phi"))
    momentum, force = row_of(T, speeds), row_of(Phi, speeds)
    M = _at_rest(slopes_of(momentum, speeds), rest)
    C = _at_rest(slopes_of(force, speeds), rest)
    slips = _at_rest(slopes_of(momentum, number), rest)
    G = {pair: slips.get(pair, scene.table.zero) - slips.get(pair[::-1], scene.table.zero)
         for pair in set(slips) | {(j, i) for i, j in slips}}
    G = {pair: node for pair, node in G.items() if not node.is_zero}
    conservative = [row_of(V, number), {i: -slope for i, slope in row_of(T, number).items()}]
    drag = [force]
    if scene.timed:
        drag.append({i: gradient(p)[scene.time] for i, p in momentum.items() if scene.time in gradient(p)})
        for pair, node in _at_rest(slopes_of(drag[1], speeds), rest).items():
            C[pair] = C.get(pair, scene.table.zero) + node
    K = [_at_rest(slopes_of(part, number), rest) for part in (*conservative, *drag)]
    residual = [_at_rest(part, rest) for part in (*conservative, *drag)]
    for key, rows in scene.matrices.items():
        _outright(scene, (M, C, G, K, residual), key, rows)
    return M, C, G, {}, K, residual


def _outright(scene: "Scene", parts: "tuple[Matrix, Matrix, Matrix, list[Matrix], list[Row]]", key: str,
              rows: "Sequence[list[Node]]") -> None:
    """Adds to M, C, G, K and the residual a matrix that the scene gives outright: M, K, or C = sym C + G."""
    M, C, G, K, residual = parts
    pairs = [(i, j) for i in range(len(rows)) for j in range(len(rows))]
    if key == "K":
        K.append({(i, j): rows[i][j] for i, j in pairs if not rows[i][j].is_zero})
        residual.append({i: scene.table.total(q * k for q, k in zip(scene.q, row, strict=False))
                         for i, row in enumerate(rows)})
        return
    for matrix, sign in [(M if key == "M" else C, 1)] + [(G, -1)] * (key == "C"):
        for i, j in pairs:
            half = (rows[i][j] + sign * rows[j][i]) / 2
            if not half.is_zero:
                matrix[i, j] = matrix.get((i, j), scene.table.zero) + half


def _at_rest(entries: "Mapping[Key, Node]", rest: "dict[Node, Node]") -> "dict[Key, Node]":
    values = substitute(list(entries.values()), rest) if entries else ()
    return {key: node for key, node in zip(entries, values, strict=True) if not node.is_zero}


def without_time(scene: "Scene", node: "Node") -> "Node":
    """The terms of an expression that do not depend on the time."""
    time = scene.time.mask
    if not node.mask & time:
        return node
    return collected(scene.table, {monomial: value for monomial, value in expanded_terms(scene, node).items()
                                   if not any(atom.mask & time for atom, _ in monomial)})


def load_at_rest(scene: "Scene", term: "AppliedLoad") -> "tuple[Node, Node, Node, Node]":
    """A load in four parts: (the steady one, that in it which turns with the frames that carry it and so holds the
    time, what waves in the one in time, the constant beside it). Of F₀ (1 − cos Ωt) these are −F₀ cos Ωt and F₀."""
    rest = scene.rates_at_rest
    force, steady_part = substitute([term.weight, term.steady], rest)
    parts = steady_part.args if steady_part.op == "sum" else ((steady_part, ONE),)
    turning = scene.table.sum(*((node, c) for node, c in parts if node.mask & scene.time.mask))
    constant = without_time(scene, force - steady_part)
    return steady_part, turning, force - steady_part - constant, constant


def expanded_terms(scene: "Scene", node: "Node") -> "dict[tuple[tuple[Node, Fraction | int], ...], Fraction | int]":
    try:
        return reduced(expanded(node))
    except (TooLong, ZeroDivisionError):
        raise PhysicsError("the terms of this scene that depend on time are too long to be told from those that do not",
                           "describe the driven motion in fewer steps") from None
