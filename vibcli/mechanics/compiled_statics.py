"""r(q), the sizes of its terms and K(q) of a system in floats, compiled where they are evaluated again and again: the
operations of `in_numbers` in the same order, so the same numbers."""

from collections.abc import Callable, Iterable, Mapping
from typing import TYPE_CHECKING, Any

from vibcli.mechanics.linearisation import Linearisation, nodes_of
from vibcli.mechanics.numeric_linearisation import ALIKE, in_numbers
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.evaluation_code import FloatSource
from vibcli.symbolic.expression_graph import evaluable
from vibcli.symbolic.floats import UNDEFINED

if TYPE_CHECKING:
    from vibcli.mechanics.numeric_system import NumericSystem
    from vibcli.symbolic.node import Node

OFTEN, LONGEST = 10, 5000      # evaluations before they are compiled; parts and entries of K of such as are not


class StaticForces:
    """Those of a NumericSystem along all its coordinates."""

    def __init__(self, numeric: "NumericSystem") -> None:
        self._numeric, self._code = numeric, numeric.system.statics_code
        self._constants: list[float] | None = None

    def at(self, position: Mapping[str, float]) -> tuple[list[float], list[float], list[list[float]]]:
        """(r, sizes of its terms, K) in a position; NaN for what has no value there."""
        function = self._code.function()
        if function is not None:
            if self._constants is None:
                self._constants = evaluate(self._code.constants, Floats, self._numeric.floats)
            try:
                found: tuple[list[float], list[float], list[list[float]]] = function(self._constants, position)
                return found
            except UNDEFINED:
                pass
        numbers = in_numbers(self._code.form, Floats, {**self._numeric.floats, **position})
        return numbers.residual, numbers.residual_size, numbers.elements.stiffness_array().tolist()


class StaticsCode:
    """The same at all values of the parameters; `constants`: what of it depends on these alone."""

    def __init__(self, form: Linearisation) -> None:
        self.form, self._times = form, 0
        self._function: Callable[..., Any] | None = None
        self.constants: list[Node] = []

    def function(self) -> Callable[..., Any] | None:
        """(constants, position) ↦ the values; None where they are not evaluated often, or too long."""
        if self._times <= OFTEN:
            self._times += 1
            if self._times > OFTEN:
                self._function = self._compiled()
        return self._function

    def _compiled(self) -> Callable[..., Any] | None:
        nodes = tuple(dict.fromkeys(nodes_of(self.form)))
        order = evaluable(nodes)
        if len(order) + self.form.n**2 > LONGEST:
            return None
        moving = [node for node in order if node.mask]
        used = {*nodes, *(part for node in moving for part in node.parts)}
        self.constants = [node for node in order if not node.mask and node in used]
        source = _Totals({node: f"k{i}" for i, node in enumerate(self.constants)})
        source.lines.append(f"[{','.join(source.slots.values())}]=k")
        for node in moving:
            source.add(node)
        return source.compiled("k,v", source.totals(self.form))


class _Totals(FloatSource):
    """Lines that add up r and K."""

    opening = closing = ""

    def __init__(self, slots: "Mapping[Node, str]") -> None:
        super().__init__(slots)
        self.products: dict[str, str] = {}

    def totals(self, form: Linearisation) -> str:
        """Write what adds up r, its sizes and K; how they are returned."""
        forces: dict[int, list[str]] = {i: [] for i in range(form.n)}
        stiffness: dict[tuple[int, int], list[str]] = {}
        for force, curvature, row in form.curved:
            for pair, second in curvature.items():
                stiffness.setdefault(pair, []).append(self._times(force, second))
            for i, slope in row.items():
                forces[i].append(self._times(force, slope))
        for part in form.K:
            for pair, node in part.items():
                stiffness.setdefault(pair, []).append(self.slots[node])
        for part in form.residual:
            for i, node in part.items():
                forces[i].append(self.slots[node])
        K = self._stiffness(form, stiffness)
        rows = [[K.get((i, j), "0.0") for j in range(form.n)] for i in range(form.n)]
        return ",".join(map(_listed, ([self._joined(["0.0", *terms], "+") for terms in forces.values()],
                                      [self._joined(["0.0", *map(_size, terms)], "+") for terms in forces.values()],
                                      map(_listed, rows))))

    def _stiffness(self, form: Linearisation, terms: Mapping[tuple[int, int], list[str]]) -> dict[tuple[int, int], str]:
        """{(i, j): slot} of K; what the forces make of it is evened out where it is symmetric but for rounding."""
        K = {pair: self._slot(self._joined(parts, "+")) for pair, parts in terms.items()}
        for i, j in [pair for pair in terms if pair[0] < pair[1] and terms[pair] != terms.get(pair[::-1])]:
            one, other = K[i, j], K.get((j, i)) or self._slot("0.0")
            sizes = [self._joined(list(map(_size, terms.get(pair, ["0.0"]))), "+") for pair in ((i, j), (j, i))]
            self.lines.append(f"if {one}!={other} and abs({one}-{other})<={ALIKE!r}*max({','.join(sizes)}):"
                              f"{one}={other}=({one}+{other})/2")
            K[j, i] = other
        for weight, row in [*form.springs, *(spring for piece in form.pieces for spring in piece.springs)]:
            for i, x in row.items():
                for j, y in row.items():
                    added = "*".join(self.slots[node] for node in (weight, x, y))
                    K[i, j] = self._slot(f"{K[i, j]}+{added}" if (i, j) in K else added)
        return K

    def _times(self, one: "Node", other: "Node") -> str:
        """The slot of a product, which is written once."""
        text = f"{self.slots[one]}*{self.slots[other]}"
        if text not in self.products:
            self.products[text] = self._slot(text)
        return self.products[text]

    def _slot(self, text: str) -> str:
        slot = f"y{len(self.lines)}"
        self.lines.append(f"{slot}={text}")
        return slot


def _size(text: str) -> str:
    return f"abs({text})"


def _listed(texts: Iterable[str]) -> str:
    return f"[{','.join(texts)}]"
