"""Matrices given outright: M q̈ + C q̇ + K q = 0, the rows in the order of the coordinates."""

from typing import TYPE_CHECKING

from vibcli.language.fields import Element, Field
from vibcli.language.kinds import Many, Quantity

if TYPE_CHECKING:
    from vibcli.language.reader import Record
    from vibcli.scene.builder import Builder

_MATRIX = Many(Many(Quantity(), 1, 2000, "a row of entries"), 1, 2000, "a list of rows [[…], […]]")
ELEMENT = Element(
    "set of matrices",
    "M, C and K given outright, where a problem starts from them; rows follow `coordinates`. A part of C that is skew "
    "is gyroscopic. They add to what the elements of the scene contribute.",
    {
        "M": Field(_MATRIX, "mass matrix, symmetric"),
        "C": Field(_MATRIX, "damping matrix; its skew part is gyroscopic"),
        "K": Field(_MATRIX, "stiffness matrix, symmetric"),
    },
    example="given_matrices",
)


def build(record: "Record", scene: "Builder") -> None:
    """Add the entries of the matrices to the scene, after checking shape and symmetry."""
    names = list(scene.spec.coordinates)
    n = len(names)          # a scene that is opened has further ones, after these
    for key, rows in record.items():
        wrong = next((i for i, row in enumerate(rows) if len(row) != n), None)
        if len(rows) != n or wrong is not None:
            found = f"rows: {len(rows)}" if len(rows) != n else f"entries in row {wrong + 1}: {len(rows[wrong])}"
            scene.report(record.place(key), f"{key} does not fit the coordinates of the scene: {n}; its {found}",
                         f"write as many rows as coordinates, {n}, of {n} entries each")
            continue
        nodes = [[scene.lower(entry) for entry in row] for row in rows]
        for i in range(n):
            for j in range(i):
                if key != "C" and not scene.agree(nodes[i][j], nodes[j][i]):
                    scene.report(rows[i][j].where, f"{key} is not symmetric: entries ({i + 1}, {j + 1}) and "
                                 f"({j + 1}, {i + 1}) differ", _hint(key, *(names[k] for k in (i, j))))
        if key == "M" and not scene.parameters.free and _is_negative([list(map(scene.number, row)) for row in nodes]):
            scene.report(record.place(key), "M is not positive: some motion has negative kinetic energy",
                         "mind the signs; x'*M*x'/2 is the kinetic energy")
        scene.add_matrix(key, nodes)


def _hint(key: str, q: str, other: str) -> str:
    """What to write where a matrix is not symmetric."""
    same = "write the same in both places"
    return same if key == "M" else (f"{same}; what is skew in K has no energy: write it as a load, forces: "
                                    f"{{f: {{coordinate: {q}, value: …*{other}}}}}")


def _is_negative(rows: list[list[float]]) -> bool:
    """Does a symmetric matrix have a negative eigenvalue beyond rounding? By elimination with the largest pivots."""
    size = max(abs(row[i]) for i, row in enumerate(rows))
    left = list(range(len(rows)))
    while left:
        pivot = max(left, key=lambda i: rows[i][i])
        if rows[pivot][pivot] <= 1e-12 * size:
            return any(rows[i][j] < -1e-12 * size if i == j else abs(rows[i][j]) > 1e-12 * size
                       for i in left for j in left)
        left.remove(pivot)
        for i in left:
            factor = rows[i][pivot] / rows[pivot][pivot]
            for j in left:
                rows[i][j] -= factor * rows[pivot][j]
    return False
