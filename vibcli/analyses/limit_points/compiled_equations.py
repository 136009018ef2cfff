"""r(q, p), K = ∂r/∂q and ∂r/∂p compiled together from the shared expressions of a scene, one parameter an argument."""

from collections.abc import Mapping, Sequence
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from vibcli.mechanics.linearisation import Linearisation, residual_terms
from vibcli.symbolic.derivatives import gradient, substitute
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.numeric_code import Source, function

if TYPE_CHECKING:
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node


class CompiledEquilibrium:
    """Those of the coordinates in `rows` at t = 0; the others stay at `rest`."""

    def __init__(self, scene: "Scene", form: Linearisation, name: str, rows: Sequence[int], floats: Mapping[str, float],
                 rest: Mapping[str, float]) -> None:
        table, n = scene.table, len(rows)
        p, self.n = table.variable(f"{name} as it goes"), n
        terms = [residual_terms(form)[i] for i in rows]
        at = np.cumsum([0, *map(len, terms)]).tolist()
        self.parts, self.most = [slice(*ends) for ends in pairwise(at)], at[-1]
        nodes = _with_argument(scene, [node for row in terms for node in row], name, p)
        symbols = [*(scene.q[i] for i in rows), p]
        slopes = [gradient(table.total(nodes[at[i]:at[i + 1]])) for i in range(n)]
        found = [*nodes, *(row.get(symbol, table.zero) for row in slopes for symbol in symbols)]
        slots = {scene.time: "t", p: "p", **{q: f"q{i}" for i, q in enumerate(scene.q)},
                 **dict.fromkeys(scene.v, "0.0")}
        source = Source(slots, floats, None)
        texts = source.add(found)
        head = [f"({''.join(f'q{i},' for i in range(len(scene.q)))})=q", "t=0.0"]
        self._evaluate = function("q,p", head + source.lines, f"({','.join(texts)},)", source.called.values())
        self.rows, self.rest = list(rows), np.array([rest[q.name] for q in scene.q])

    def __call__(self, q: np.ndarray, p: float) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
        """(r, sizes of its terms, K, ∂r/∂p) at a place."""
        place = self.rest.copy()
        place[self.rows] = q
        with np.errstate(all="ignore"):
            values = np.array(self._evaluate(place, np.float64(p)), float)
        slopes, sizes = values[self.most:].reshape(self.n, self.n + 1), np.abs(values[:self.most])
        return (np.array([values[row].sum() for row in self.parts]), np.array([sizes[row].sum() for row in self.parts]),
                slopes[:, :-1], slopes[:, -1])


def _with_argument(scene: "Scene", nodes: "list[Node]", name: str, p: "Node") -> "list[Node]":
    """The expressions with a variable in place of a parameter, in what is defined by it too."""
    known = {scene.parameters.nodes[name]: p}
    for other in scene.parameters.order:
        if other in scene.parameters.definitions and other != name:
            _put(known, scene.parameters.nodes[other], scene.parameters.definitions[other])
    below = [part for part in reachable(nodes) if part in scene.table.definitions]
    for part in sorted(below, key=lambda part: part.index):
        _put(known, part, scene.table.definitions[part])
    return substitute(nodes, known)


def _put(known: "dict[Node, Node]", symbol: "Node", definition: "Node") -> None:
    if not known.keys().isdisjoint(reachable([definition])):
        known[symbol] = substitute([definition], known)[0]
