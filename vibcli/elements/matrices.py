"""Matrices given outright: M q̈ + C q̇ + K q = 0, the rows in the order of the coordinates."""

from vibcli.fields import Element, Field, Many, Quantity

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


def build(record, scene):
    """Add the entries of the matrices to the scene, after checking shape and symmetry."""
    n = len(scene.coordinates)
    for key, rows in record.values.items():
        wrong = next((i for i, row in enumerate(rows) if len(row) != n), None)
        if len(rows) != n or wrong is not None:
            found = f"{len(rows)} rows" if len(rows) != n else f"{len(rows[wrong])} entries in row {wrong + 1}"
            scene.report(record.place(key), f"{key} has {found}, the scene has {n} coordinates",
                         f"write {n} rows of {n} entries each")
            continue
        nodes = [[scene.lower(entry) for entry in row] for row in rows]
        for i in range(n):
            for j in range(i):
                if key != "C" and not scene.agree(nodes[i][j], nodes[j][i]):
                    scene.report(rows[i][j].where, f"{key} is not symmetric: entries ({i + 1}, {j + 1}) and "
                                 f"({j + 1}, {i + 1}) differ", "write the same in both places")
        scene.add_matrix(key, nodes)
