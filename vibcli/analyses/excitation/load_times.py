"""When what drives a scene changes, how slowly it swings and how long it takes to die out, whatever it drives: of each
function of the time alone in its expressions that is a sum of polynomials, exponentials and sines."""

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

from vibcli.analyses.excitation.decompose import forcing_of
from vibcli.analyses.transient.duration import fading
from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.symbolic.expression_graph import reachable

if TYPE_CHECKING:
    from vibcli.base.work import Work
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node


class LoadTimes(NamedTuple):
    """last: the last instant [s] at which one changes its form; speeds: their angular frequencies; fading: how long [s]
    they take from then on to die out."""

    last: float
    speeds: list[float]
    fading: float


def load_times(scene: "Scene", floats: Mapping[str, float], work: "Work") -> LoadTimes:
    """Those of a scene; floats: {name: number} of its parameters."""
    last, speeds, longest = 0.0, set(), 0.0
    left = list(_of_time(scene)) if scene.timed else []
    met = set(left)
    while left:
        node = left.pop()
        try:
            forces = forcing_of({0: node}, scene.time, floats, work=work)
        except PhysicsError:        # it has no such form: what it is a function of may have
            left += [part for part in _parts(node) if part.mask and part not in met]
            met.update(left)
            continue
        last = max(last, forces.last.start if forces.listed else 0.0)
        speeds |= forces.speeds
        longest = max(longest, fading(forces))
    return LoadTimes(last, sorted(speeds), longest)


def _of_time(scene: "Scene") -> "Iterator[Node]":
    """The largest expressions of the time alone, of the scene's own: what closes loops is none."""
    time, roots = scene.time, scene.contents.depends_on
    below, alone = reachable(roots), set()
    for node in below:
        if node is time or (not node.mask & ~time.mask and not (node.op == "symbol" and node.mask)
                            and all(part in alone for part in _parts(node))):
            alone.add(node)
    beside = {part for node in below if node not in alone for part in _parts(node)} | set(roots)
    return (node for node in beside if node.mask and node in alone)


def _parts(node: "Node") -> "Sequence[Node]":
    return [arg for arg, _ in node.args] if node.op in ("sum", "product") else node.args
