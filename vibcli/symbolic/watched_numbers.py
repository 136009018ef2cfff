"""Numbers that remember what was decided by them: which comparisons of expressions came out how, and which values were
taken as they are. At other values of the parameters the same would be done where all of these come out the same."""

import operator
from collections.abc import Callable, Mapping, Sequence
from functools import partialmethod
from operator import itemgetter
from typing import Any

from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.expression_graph import reachable
from vibcli.symbolic.node import Node

Formula = float | Node | str | tuple[Any, ...]
SINGULAR = {operator.truediv: 1, operator.floordiv: 1, operator.mod: 1, operator.pow: 0}    # at zero of this argument


class Decisions:
    """{formula: how it came out}; a formula is a node, the name of a parameter, a
    number, or (function, formulas …). `lost`: was something
    decided of which no formula tells?"""

    def __init__(self) -> None:
        self._found: dict[Any, Any] = {}
        self._about: dict[tuple[str, ...], tuple[Any, ...]] = {}
        self.lost = False

    def watched(self, values: Mapping[str, float]) -> "WatchedValues":
        """Values of parameters, what is decided by which is kept here."""
        return WatchedValues(self, values)

    def keep(self, formula: Any, outcome: Any) -> Any:
        """An outcome, kept."""
        self._about.clear()
        return self._found.setdefault(formula, outcome)

    def lose(self) -> None:
        """Something is decided of which no formula tells."""
        self.lost = True

    def hold(self, before: Mapping[str, float], sample: Mapping[str, float],
             changed: tuple[str, ...] | None = None) -> bool:
        """Do all come out the same at a sample as at the one before, and does each parameter keep its sign? `changed`:
        the parameters whose values may be others."""
        if changed is None:
            changed = tuple(name for name, value in sample.items() if value != before[name])
        if self.lost or any((sample[name] > 0) != (before[name] > 0) for name in changed):
            return False
        nodes, compiled = self._about.get(changed) or self._hanging_on(changed)
        values = {**sample, **dict(zip(nodes, evaluate(nodes, Floats, sample), strict=True))} if nodes else sample
        try:
            return all(value(values) == outcome for value, outcome in compiled)
        except (ArithmeticError, ValueError):
            return False

    def _hanging_on(self, changed: tuple[str, ...]) -> tuple[tuple[Node, ...], list[tuple[Callable[..., bool], bool]]]:
        """(nodes, [(compiled formula, how it came out)]) of the formulas that hang on parameters."""
        found = [(formula, outcome) for formula, outcome in self._found.items()
                 if _names(formula).intersection(changed)]
        nodes = tuple(dict.fromkeys(node for formula, _ in found for node in _nodes(formula)))
        self._about[changed] = nodes, [(_compiled(formula), outcome) for formula, outcome in found]
        return self._about[changed]


class WatchedValues(dict[str, Any]):
    """{parameter: Watched}; `plain`: the same as floats."""

    def __init__(self, decisions: Decisions, values: Mapping[str, float]) -> None:
        super().__init__({name: Watched(value, name, decisions) for name, value in values.items()})
        self.plain, self._decisions = dict(values), decisions

    def watching(self, nodes: Sequence[Node], values: Sequence[float]) -> list[Any]:
        """The values of nodes, watched where they hang on parameters."""
        return [Watched(value, node, self._decisions) for node, value in zip(nodes, values, strict=True)]


class Watched:
    """A float with its formula. Comparisons are kept as they come out; where it is taken as a float, its value is."""

    __slots__ = ("_decisions", "_formula", "_value")

    def __init__(self, value: Any, formula: Any, decisions: Decisions) -> None:
        self._value, self._formula, self._decisions = value, formula, decisions

    def __float__(self) -> float:
        return float(self._decisions.keep(self._formula, self._value))

    def __bool__(self) -> bool:
        return bool(self._decisions.keep((operator.truth, self._formula), bool(self._value)))

    def __int__(self) -> int:
        return int(float(self))

    def __hash__(self) -> int:
        return hash(float(self))

    def __repr__(self) -> str:
        return repr(float(self))

    def __format__(self, form: str) -> str:
        return format(float(self), form)

    def __round__(self, digits: int | None = None) -> Any:
        return round(float(self), digits)

    def of(self, function: Callable[..., Any], *others: Any, swapped: bool = False) -> Any:
        """function(self, other), watched; where it has no value, what follows is lost."""
        parts = [(one._value, one._formula) if isinstance(one, Watched) else (one, one) for one in (self, *others)]
        if swapped:
            parts.reverse()
        try:
            value = function(*(value for value, _ in parts))
        except (ArithmeticError, ValueError):
            self._decisions.lose()
            raise
        if function in SINGULAR:
            self._decisions.keep((operator.truth, parts[SINGULAR[function]][1]), bool(parts[SINGULAR[function]][0]))
        formula = (function, *(formula for _, formula in parts))
        if isinstance(value, bool):
            return self._decisions.keep(formula, value)
        return Watched(value, formula, self._decisions)

    __abs__ = partialmethod(of, operator.abs)
    __neg__ = partialmethod(of, operator.neg)
    __pos__ = partialmethod(of, operator.pos)
    __lt__ = partialmethod(of, operator.lt)
    __le__ = partialmethod(of, operator.le)
    __gt__ = partialmethod(of, operator.gt)
    __ge__ = partialmethod(of, operator.ge)
    __eq__ = partialmethod(of, operator.eq)
    __ne__ = partialmethod(of, operator.ne)
    __add__ = partialmethod(of, operator.add)
    __sub__ = partialmethod(of, operator.sub)
    __mul__ = partialmethod(of, operator.mul)
    __truediv__ = partialmethod(of, operator.truediv)
    __pow__ = partialmethod(of, operator.pow)
    __mod__ = partialmethod(of, operator.mod)
    __floordiv__ = partialmethod(of, operator.floordiv)
    __radd__ = partialmethod(of, operator.add, swapped=True)
    __rsub__ = partialmethod(of, operator.sub, swapped=True)
    __rmul__ = partialmethod(of, operator.mul, swapped=True)
    __rtruediv__ = partialmethod(of, operator.truediv, swapped=True)
    __rpow__ = partialmethod(of, operator.pow, swapped=True)
    __rmod__ = partialmethod(of, operator.mod, swapped=True)
    __rfloordiv__ = partialmethod(of, operator.floordiv, swapped=True)


def _compiled(formula: Formula) -> Callable[..., Any]:
    """{name or node: value} ↦ the value of a formula."""
    if not isinstance(formula, tuple):
        return itemgetter(formula) if isinstance(formula, (str, Node)) else lambda values: formula
    function, *parts = formula
    if len(parts) == 1:
        only, = map(_compiled, parts)
        return lambda values: function(only(values))
    if not isinstance(parts[1], (tuple, str, Node)):
        left, right = _compiled(parts[0]), parts[1]
        return lambda values: function(left(values), right)
    left, right = map(_compiled, parts)
    return lambda values: function(left(values), right(values))


def _leaves(formula: Formula) -> list[float | Node | str]:
    return [leaf for part in formula[1:] for leaf in _leaves(part)] if isinstance(formula, tuple) else [formula]


def _nodes(formula: Formula) -> list[Node]:
    return [leaf for leaf in _leaves(formula) if isinstance(leaf, Node)]


def _names(formula: Formula) -> set[str]:
    """The parameters on which a formula hangs."""
    return {leaf for leaf in _leaves(formula) if isinstance(leaf, str)}.union(
        part.name for part in reachable(_nodes(formula)) if part.op == "symbol")
