"""The element data of a system of which one coordinate is held: its frequencies are the zeros of the response there."""

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping

    from vibcli.mechanics.factored_system import FactoredSystem


def held(elements: "FactoredSystem", row: "Mapping[int, float]") -> "FactoredSystem":
    """With Σ row·q = 0: the coordinate with the largest share is a sum of the others."""
    out = max(row, key=lambda i: abs(row[i]))
    numbers = {i: k for k, i in enumerate(i for i in range(elements.n) if i != out)}
    shares = {i: -x / row[out] for i, x in row.items() if i != out}

    def over(old: "Mapping[int, Any]") -> dict[int, Any]:
        new = {numbers[i]: x for i, x in old.items() if i != out}
        for i, share in shares.items() if old.get(out) else ():
            new[numbers[i]] = new.get(numbers[i], 0) + old[out] * share
        return {i: x for i, x in new.items() if x}

    def rows(terms: "Iterable[tuple[Any, Mapping[int, Any]]]") -> list[tuple[Any, dict[int, Any]]]:
        return [(weight, over(row)) for weight, row in terms]

    def matrix(entries: "Mapping[tuple[int, int], Any]") -> dict[tuple[int, int], Any]:
        new: dict[tuple[int, int], Any] = {}
        for (i, j), x in entries.items():
            for k, y in over({i: 1.0}).items():
                for m, z in over({j: 1.0}).items():
                    new[k, m] = new.get((k, m), 0) + x * y * z
        return new

    pieces = [placed._replace(rows=tuple(map(over, placed.rows)), springs=rows(placed.springs))
              for placed in elements.pieces]
    parts: dict[str, Any] = {kind: rows(getattr(elements, kind)) for kind in ("inertias", "springs", "dampers")}
    parts |= {kind: matrix(getattr(elements, kind)) for kind in ("M", "C", "G", "K")}
    sizes = {(i, j): abs(x) for (i, j), x in parts["K"].items()}
    return elements.with_parts(n=elements.n - 1, K_size=sizes, rational_rows=None, pieces=pieces, **parts)
