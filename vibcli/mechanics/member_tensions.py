"""The tension of beams and strings in the plane in equilibrium, as they bend and stretch there.

Members that keep their length are cut open at their stations. With the force F along each coordinate, cuts included,
the conditions G that hold them together have multipliers, Σ λₖ ∂Gₖ/∂q = F along what is not cut, and a station pulls
with F − Σ λₖ ∂Gₖ/∂t; of a beam that stretches N is EA Δ/l beside its preload.
"""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from vibcli.base.named_tuple import NamedTuple
from vibcli.scene.member_tensions import along_pieces, force_along, is_held_along, placed_members
from vibcli.symbolic.derivatives import gradient
from vibcli.symbolic.evaluation import Floats, evaluate

if TYPE_CHECKING:
    from vibcli.elements.member import Member
    from vibcli.mechanics.configuration import Configuration
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node


class TensionAtRest(NamedTuple):
    """Of each piece of a member the tension at its left end: that `found` in equilibrium and that in its stiffness,
    `drawn`. `size`: of the forces that make it."""

    member: Any
    found: list[float]
    drawn: list[float]
    size: float


def tensions_at_rest(configuration: "Configuration") -> list[TensionAtRest]:
    """Those of all beams and strings in the plane."""
    members = placed_members(configuration.scene)
    found = _of_stretches([member for member in members if member.stretching], configuration)
    kept = [member for member in members if not member.stretching and member.stations]
    return found + _of_cuts(kept, configuration) if kept else found


def _of_stretches(members: "Sequence[Member]", configuration: "Configuration") -> list[TensionAtRest]:
    """Of beams that stretch."""
    scene, at = configuration.scene, configuration.at_rest
    found = []
    for member in members:
        parts = [evaluate([stretch, mean, tension], Floats, at) for (stretch, mean), (tension, *_)
                 in zip(member.stretch_forces(scene), member.tensions, strict=True)]
        found.append((member, [stretch - (mean - tension) for stretch, mean, tension in parts],
                      [tension for *_, tension in parts]))
    size = max((abs(x) for _, *both in found for part in both for x in part), default=0.0)
    return [TensionAtRest(*one, size) for one in found]


def _of_cuts(members: "Sequence[Member]", configuration: "Configuration") -> list[TensionAtRest]:
    """Of members that keep their length."""
    forces, ties, size = _cut_open(configuration)
    found = []
    for member in members:
        nodes = [_preload(member, configuration.scene), _last(member, configuration.scene)]
        nodes += [node for piece in member.tensions for node in piece]
        preload, last, *rest = evaluate(nodes, Floats, configuration.at_rest)
        drawn, spans = rest[::3], list(zip(rest[1::3], rest[2::3], strict=True))
        tie = ties.get(member.name, last if member.tie is not None else None)
        pieces = along_pieces(forces[member.name], tie, preload, spans, 0.0)
        found.append(TensionAtRest(member, [x + 0.0 for x in pieces], drawn, size))
    return found


def _last(member: "Member", scene: "Scene") -> "Node":
    """The tension of the last piece that is given, or that statics finds: of a string that is pressed too."""
    given = member.name in (scene.setting.variant.tensions or {})
    return member.tensions[-1][0] if given or member.tie is None else member.tie


def _preload(member: "Member", scene: "Scene") -> "Node":
    return scene.lower(member.record["preload"]) if "preload" in member.record else scene.table.zero


def _cut_open(configuration: "Configuration") -> tuple[dict[str, list[float | None]], dict[str, float], float]:
    """({member: force along each station, None where it is held}, {member: λ of what both its ends are held to}, the
    largest force); a λ that the conditions leave open is left out."""
    import numpy as np

    from vibcli.mechanics.inputs_outputs.reactions import OPEN, solved
    from vibcli.mechanics.static_preload import take_over

    scene = take_over(configuration.scene.with_open_members(), configuration.system.preloads).resting
    members = {member.name: member for member in placed_members(scene) if member.stretches}
    ties = {name: gap for name, member in members.items() if is_held_along(member)
            and (gap := member.stations[-1].along - member.stations[0].along).mask}
    cuts = {t: i for i, t in enumerate(t for member in members.values() for t in member.stretches if t is not None)}
    q = [x for x in scene.q if x not in cuts] + list(cuts)
    conditions = [gradient(node) for node in (*ties.values(), *(constraint.node for constraint in scene.constraints))]
    nodes = [force_along(scene, x) for x in q]
    slopes = [row.get(x, scene.table.zero) for row in conditions for x in q]
    flat = evaluate([*nodes, *slopes], Floats, _at_rest(scene, configuration, cuts))
    n = len(q) - len(cuts)
    F, G = np.array(flat[:len(q)]), np.array(flat[len(q):]).reshape(len(conditions), len(q))
    multipliers, loose = solved(G[:, :n], -F[:n], scene.units_of([x.name for x in q[:n]]))
    at_cuts = (F - multipliers @ G)[n:]
    forces = {name: [None if t is None else float(at_cuts[cuts[t]]) for t in member.stretches]
              for name, member in members.items()}
    found = {name: float(multipliers[k]) for k, name in enumerate(ties) if np.abs(loose[:, k]).max(initial=0.0) <= OPEN}
    return forces, found, float(max(np.abs(F).max(initial=0.0), np.abs(multipliers).max(initial=0.0)))


def _at_rest(scene: "Scene", configuration: "Configuration", cuts: "Mapping[Node, int]") -> dict[str, float]:
    """{symbol: float} of the scene cut open in equilibrium."""
    rest = configuration.scene.resting
    names = [x.name for x in scene.q if x not in cuts]
    values = evaluate([rest.symbol(name) for name in names], Floats, configuration.at_rest)
    return {**configuration.numeric.floats, **dict(zip(names, values, strict=True)),
            **dict.fromkeys((t.name for t in cuts), 0.0), scene.time.name: 0.0,
            **dict.fromkeys((v.name for v in scene.v), 0.0)}
