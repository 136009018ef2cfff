"""What a scene that depends on time is when its excitation is left out.

M, C, G and K of the small oscillations must not depend on the time; what else does is excitation. Terms that hold the
time are dropped from the residual and from K after expansion, when those of rotating frames have cancelled; the rows of
M and C are taken at t = 0. Whether M, C, G, K then are those of every instant is tested at the equilibrium: periodic
coefficients (a shaken pivot) are refused by name.
"""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.mechanics.linearisation import Linearisation, at_position, residual_terms
from vibcli.mechanics.linearise import expanded_terms, load_at_rest, row_of, without_time
from vibcli.mechanics.numeric_linearisation import in_numbers
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.normal_form import collected
from vibcli.symbolic.rationals import ONE
from vibcli.symbolic.smoothed_functions import SmoothFloats

if TYPE_CHECKING:
    from vibcli.mechanics.configuration import Configuration
    from vibcli.mechanics.linearisation import Key
    from vibcli.scene.energy_terms import AppliedLoad
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node
    from vibcli.symbolic.variable_sets import VariableSet

INSTANTS, SAME = (0.137, 0.731, 1.933, 4.217), 1e-9
WORDS = {"M": "the inertia", "C": "the damping", "G": "the gyroscopic coupling", "K": "the stiffness"}


def steady(scene: "Scene", form: Linearisation) -> Linearisation:
    """The Linearisation without its excitation; that of a scene without time is returned as it is."""
    if not scene.timed:
        return form
    residual: dict[int, list[Node]] = {}
    stiffness: dict[tuple[int, int], list[Node]] = {}
    time, curved = scene.time.mask, []
    springs = _still_springs(form, time, stiffness)
    for force, curvature, row in form.curved:
        if any(node.mask & time for node in (*row.values(), *curvature.values())):
            _gather(residual, {i: force * slope for i, slope in row.items()})
            _gather(stiffness, {pair: force * second for pair, second in curvature.items()})
        else:
            curved.append((without_time(scene, force), curvature, row))
    at_start = at_position(form._replace(springs=[], curved=[], residual=[], K=[]), {scene.time: scene.table.zero})
    return at_start._replace(springs=springs, curved=curved, residual=_still_parts(scene, form.residual, residual),
                             K=_still_parts(scene, form.K, stiffness))


def _still_springs(form: Linearisation, time: "VariableSet | int",
                   stiffness: "dict[tuple[int, int], list[Node]]") -> "list[tuple[Node, dict[int, Node]]]":
    """The springs whose rows do not depend on the time; what the others add to K goes to {(i, j): [terms]}."""
    found = []
    for weight, row in form.springs:
        if any(node.mask & time for node in (weight, *row.values())):
            for i, x in row.items():
                for j, y in row.items():
                    stiffness.setdefault((i, j), []).append(weight * x * y)
        else:
            found.append((weight, row))
    return found


def _still_parts(scene: "Scene", parts: "Sequence[dict[Key, Node]]",
                 bucket: "dict[Key, list[Node]]") -> "list[dict[Key, Node]]":
    """The parts {key: expression} without the time, and what is left where those with it are added up."""
    time, found = scene.time.mask, []
    for part in parts:
        found.append({key: node for key, node in part.items() if not node.mask & time})
        _gather(bucket, {key: node for key, node in part.items() if node.mask & time})
    return [*found, _summed(scene, bucket)]


def _gather(bucket: "dict[Key, list[Node]]", entries: "Mapping[Key, Node]") -> None:
    for key, node in entries.items():
        bucket.setdefault(key, []).append(node)


def _summed(scene: "Scene", bucket: "Mapping[Key, list[Node]]") -> "dict[Key, Node]":
    found = {key: without_time(scene, scene.table.total(nodes)) for key, nodes in bucket.items()}
    return {key: node for key, node in found.items() if not node.is_zero}


def require_autonomous(configuration: "Configuration", values: Mapping[str, float]) -> None:
    """PhysicsError where M, C, G or K about a position depend on the time; `values`: {name: float} of all symbols."""
    scene = configuration.scene
    if scene.vibrating is not scene:
        from vibcli.mechanics.inputs_outputs.constraint_excitation import carried_into

        i = carried_into(configuration.with_inputs, values)
        if i is not None:
            raise _periodic(scene, i, "K")
    if not configuration.system.hangs_on_time:
        return
    loops, timed = scene.vibrating.loops, configuration.system.time_dependent_linearisation
    wanted = matrices_at(configuration.system.linearisation, values)
    for instant in INSTANTS:
        at = {**values, scene.time.name: instant}
        if loops is not None:
            at = loops.followed({**values, scene.time.name: 0.0}, at) or at
        found = matrices_at(timed, at)
        for key, size in (("M", None), ("C", None), ("G", None), ("K", found.pop("size"))):
            _compare(scene, key, wanted[key], found[key], size)


def matrices_at(form: Linearisation, values: Mapping[str, float]) -> dict[str, dict[tuple[int, int], float]]:
    numbers = in_numbers(form, SmoothFloats, values)
    found = dict(zip("MCGK", numbers.elements.matrices(), strict=True))
    return {**found, "size": numbers.elements.K_size}


def _compare(scene: "Scene", key: str, wanted: Mapping[tuple[int, int], float], found: Mapping[tuple[int, int], float],
             size: Mapping[tuple[int, int], float] | None) -> None:
    largest = max(map(abs, (*wanted.values(), *found.values())), default=0.0)
    for pair in {*wanted, *found}:
        scale = max(abs(found.get(pair, 0.0)), (size or {}).get(pair, 0.0), 1e-6 * largest)
        if not abs(found.get(pair, 0.0) - wanted.get(pair, 0.0)) <= SAME * scale:
            raise _periodic(scene, pair[0], key)


def _periodic(scene: "Scene", i: int, key: str) -> PhysicsError:
    """What moves on steadily has a rest beside it, perhaps, in coordinates that are measured from it."""
    name, hint = scene.coordinates[i], ("its full equations are those of `vibcli equations`, its motion from `initial` "
                                        "that of motion: full")
    if not all(scene.rate(node).mask & scene.time.mask for node in scene.driven.values()):
        return PhysicsError(f"{WORDS[key]} of '{name}' depends on the time: in this coordinate there are no natural "
                            "frequencies", "measure it from what moves on steadily, as in `by: phi + Omega*t` with "
                            f"`coordinates: [phi]`, where it can be at rest beside it; else {hint}")
    return PhysicsError(f"{WORDS[key]} of '{name}' depends on the time: there are no natural frequencies",
                        f"such a motion is excited through its parameters; {hint}")


def excitation(scene: "Scene", form: Linearisation, position: "Mapping[Node, Node]") -> "dict[int, Node]":
    """{i: Q(t)}: what drives coordinate i of the small oscillations about a position ({symbol: node}), in letters.

    Of the residual it is the terms that hold the time, as the others are in equilibrium; of driven displacements and
    of loads in time it is the whole, the constants in them included, as the equilibrium is that of the scene with all
    of them left out.
    """
    place = {symbol: node for symbol, node in position.items() if symbol is not scene.time}
    rows, constants, found = residual_terms(at_position(form, place)), _shaken(scene), {}
    _begun(scene, constants)
    for i, terms in enumerate(rows):
        node = with_time(scene, _negative(scene, terms))
        if i in constants:
            node = _whole(scene, node + _negative(scene, substitute(constants[i], place)))
        if not node.is_zero:
            found[i] = node
    return found


def _negative(scene: "Scene", terms: "Sequence[Node]") -> "Node":
    """−Σ terms, with f·δ(t − t₁) as f(t₁)·δ(t − t₁)."""
    total = scene.table.sum(*((term, -ONE) for term in terms))
    if "impulse" not in scene.table.called:
        return total
    from vibcli.symbolic.delta_functions import at_impulses

    return at_impulses(total, scene.time)


def _whole(scene: "Scene", node: "Node") -> "Node":
    return collected(scene.table, expanded_terms(scene, node)) if node.mask & scene.time.mask else node


def with_time(scene: "Scene", node: "Node") -> "Node":
    """The terms of an expression that depend on the time."""
    time = scene.time.mask
    if not node.mask & time:
        return scene.table.zero
    return collected(scene.table, {monomial: value for monomial, value in expanded_terms(scene, node).items()
                                   if any(atom.mask & time for atom, _ in monomial)})


def _begun(scene: "Scene", found: "dict[int, list[Node]]") -> None:
    """Adds the terms of the residual that are the constants in loads in time: −F₀ ∂s/∂q of F₀ (1 − cos Ωt) along s."""
    number = {q: i for i, q in enumerate(scene.q)}
    for term in scene.loads_at_still():
        constant = load_at_rest(scene, term)[3]
        if not constant.is_zero:
            _gather(found, {i: -(constant * slope) for i, slope in row_of(term.s, number).items()})


def _shaken(scene: "Scene") -> "dict[int, list[Node]]":
    """{i: terms} of the residual that are linear in the driven displacements u(t): Σ ∂(P ∂s/∂q)/∂u u of springs,
    Σ c ∂s/∂q ∂s/∂u u̇ of dampers, and −Σ ∂(F ∂s/∂q)/∂u u of steady loads that turn or move with what is driven."""
    found, number = {}, {q: i for i, q in enumerate(scene.q)}
    if not scene.shaken:
        return found
    held = scene.held_drives
    for kind in ("springs", "dampers", "forces") if scene.oscillating else ():
        for term in scene.shaken[kind]:
            term = _steady_part(scene, term) if kind == "forces" else term
            parts = reachable([term.s, term.weight])
            here = [symbol for symbol in scene.oscillating if symbol in parts]
            slopes = gradient(term.s)
            for q, i in number.items():
                for symbol in here if q in slopes else ():
                    part = _slope_by(scene, term, slopes[q], symbol, kind)
                    found.setdefault(i, []).append(substitute([part], held)[0] * _function(scene, symbol, kind))
    return found


def _steady_part(scene: "Scene", term: "AppliedLoad") -> "AppliedLoad":
    """A load without its part in time, at rest."""
    load = term.weight if term.offset is None else term.offset
    weight, = substitute([load], scene.rates_at_rest)
    return term._replace(weight=weight, offset=None)


def _slope_by(scene: "Scene", term: Any, slope: "Node", symbol: "Node", kind: str) -> "Node":
    """What multiplies u(t), or u̇(t) of a damper."""
    stand_in = scene.table.variable(symbol.name + " small")
    s, row, weight = substitute([term.s, slope, term.weight], {symbol: stand_in})
    if kind == "dampers":
        part = term.weight * row * gradient(s).get(stand_in, scene.table.zero)
    elif kind == "forces":
        part = -gradient(weight * row).get(stand_in, scene.table.zero)
    else:
        part = gradient(term._replace(s=s).force(scene) * row).get(stand_in, scene.table.zero)
    return substitute([part], {stand_in: symbol})[0]


def _function(scene: "Scene", symbol: "Node", kind: str) -> "Node":
    node = scene.driven[symbol]
    return scene.rate(node) if kind == "dampers" else node
