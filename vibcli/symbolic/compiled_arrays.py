"""Expressions of (t, q, q̇) compiled to functions of arrays over instants.

Parts that depend on the time alone are a function of their own, so that an iteration at fixed instants computes them
once. Compiled with named constants, the same code serves other data.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence, ValuesView
from copy import copy
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.symbolic.discontinuous_functions import PULSES
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.numeric_code import SWITCHED, Source, code, made

if TYPE_CHECKING:
    import numpy as np

    from vibcli.symbolic.node import Node


class Compiled:
    """Expressions of (t, q, v) as functions of arrays over instants: q and v are of shape (coordinates, instants).
    `switches`: {argument: slot}, shared by what is to be smooth; None where |u|, sign u, min and max may bend.
    `prepared(t)`: the parts that depend on the time alone, at the instants t; named: as of a Source."""

    def __init__(self, scene: Any, floats: Mapping[str, float], switches: "dict[Node, str] | None", nodes: Any,
                 named: bool = False) -> None:
        time = scene.time
        below = reachable(nodes)
        _require_known(below, time)
        outer = _outermost([part for part in below if part.mask == time.mask and part is not time], below, nodes)
        early = Source({time: "t"}, floats, None, named=named)
        prepared = _tuple(early.add(outer))
        slots = {time: "t", **{node: f"c{i}" for i, node in enumerate(outer)}}
        slots |= {node: f"{kind}{i}" for kind, symbols in (("q", scene.q), ("v", scene.v))
                  for i, node in enumerate(symbols)}
        late = Source(slots, floats, switches, early.constants, named)
        result = late.add(nodes)
        head = [f"{_tuple(f'{kind}{i}' for i in range(len(scene.q)))}={kind}" for kind in "qv"]
        if outer:
            head.append(f"{_tuple(f'c{i}' for i in range(len(outer)))}=c")
        if switches:
            head.append(f"{_tuple(switches.values())}=g[:{len(switches)}]")
        self.count, self.work, self.switches = len(nodes), len(late.lines), switches
        self._sources = early, late
        self._codes = (code("t", early.lines, prepared) if outer else None,
                       code("t,q,v,g,c", head + late.lines, _tuple(result)))
        if not named:
            self._fill({}, {})

    def _fill(self, *values: Mapping[str, float]) -> None:
        self.prepared, self._evaluate = (
            made(one, [*source.called.values(), *data.items()]) if one else _nothing
            for one, source, data in zip(self._codes, self._sources, values, strict=True))

    def of_data(self, floats: Mapping[str, float], changed: Callable[[float], float]) -> "Compiled":
        """The same, named, with other values of the parameters, each constant being changed."""
        found = copy(self)
        found._fill(*(source.values(floats, changed) for source in self._sources))
        return found

    def __call__(self, t: "np.ndarray", q: Any, v: "np.ndarray", g: "Sequence[float | np.ndarray] | np.ndarray" = (),
                 c: Any = None) -> "tuple[float | np.ndarray, ...]":
        """The values as a tuple of arrays; those of constants are floats. g: the senses of the switches."""
        return self._evaluate(t, q, v, g, self.prepared(t) if c is None else c)

    def rows(self, t: "np.ndarray", q: "np.ndarray", v: "np.ndarray",
             g: "Sequence[float | np.ndarray] | np.ndarray" = (), c: Any = None) -> "np.ndarray":
        """The same of shape (nodes, instants)."""
        import numpy as np

        found = np.empty((self.count, q.shape[1]))
        for i, value in enumerate(self(t, q, v, g, c)):
            found[i] = value
        return found


def _nothing(t: "np.ndarray") -> tuple[Any, ...]:
    """What depends on the time alone where nothing does."""
    return ()


def _tuple(texts: Iterator[Any] | Sequence[str] | ValuesView[Any]) -> str:
    return "(" + "".join(text + "," for text in texts) + ")"


def _require_known(below: "Sequence[Node]", time: "Node") -> None:
    """Pulses that repeat, impulses and records are functions of the time."""
    for part in below:
        if part.mask & ~time.mask and (part.name in part.table.records or
                                       (part.name in PULSES and part.name not in SWITCHED)):
            raise PhysicsError(f"{part.name} of what moves is not defined: it is a function of the time",
                               "write it of t, as in square(Omega*t)")


def _outermost(driven: "Sequence[Node]", below: "Sequence[Node]", nodes: "Sequence[Node]") -> "list[Node]":
    """Those of `driven` which something that is not driven is made of, or which are wanted themselves."""
    kept, inner = set(driven), set()
    for part in below:
        if part not in kept and part.mask:
            inner.update(arg for arg in part.parts if arg in kept)
    inner.update(node for node in nodes if node in kept)
    return sorted(inner, key=lambda node: node.index)
