"""Random chains of bar and beam pieces with springs, masses and oscillators, and the same in finite elements."""

import random

import numpy as np

from vibcli.bench.random_members import bar_element, beam_element
from vibcli.mechanics.factored_system import FactoredSystem, PlacedPiece
from vibcli.numerics.pieces.piece import Piece


def at_rest(piece, rows):
    """The springs that span what a piece resists at rest."""
    def combined(*parts):
        found = {}
        for factor, row in parts:
            for i, x in row.items():
                found[i] = found.get(i, 0.0) + factor * x
        return found

    size = piece.length
    if piece.order == 2:
        return [(piece.tension / size, combined((1, rows[1]), (-1, rows[0])))]
    sway = combined((1, rows[2]), (-1, rows[0]), (-size / 2, rows[1]), (-size / 2, rows[3]))
    springs = [(12 * piece.bending / size**3, sway), (piece.bending / size, combined((1, rows[3]), (-1, rows[1])))]
    return springs + ([(piece.tension / size, combined((1, rows[2]), (-1, rows[0])))] if piece.tension else [])


def random_members(seed):
    """A FactoredSystem of one to four pieces in a row."""
    draw = random.Random(seed)
    beams, count = draw.random() < 0.6, draw.randint(1, 4)
    rows, springs, masses = [], [], []
    n = 0
    for node in range(count + 1):
        ends = []
        for way in range(2 if beams else 1):
            held = draw.random() < (0.35 if node in (0, count) else 0.05 if way else 0.2)
            ends.append({} if held else {n: 1.0})
            n += not held
        rows.append(ends)
    even, alike = draw.random() < 0.3, draw.random() < 0.4
    pieces, usual = [], (10 ** draw.uniform(-1, 1), 10 ** draw.uniform(-1, 1))
    for i in range(count):
        size = 1.0 if even else draw.uniform(0.2, 2)
        stiff, inertia = usual if alike else (10 ** draw.uniform(-2, 2), 10 ** draw.uniform(-1, 1))
        pull = draw.uniform(-3, 10) * stiff / size**2 if draw.random() < 0.3 else 0.0
        bed = 10 ** draw.uniform(-1, 1) * stiff / size**4 if draw.random() < 0.2 else 0.0
        piece = (Piece(size, stiff, pull, 0.0, inertia, 0.0, bed) if beams
                 else Piece(size, 0.0, stiff, 0.0, inertia, 0.0, bed))
        ends = (*rows[i], *rows[i + 1])
        pieces.append(PlacedPiece("member", float(i), piece, ends, at_rest(piece, ends)))
    for end in [end for ends in rows for end in ends if end]:
        if draw.random() < 0.4:
            springs.append((10 ** draw.uniform(-1, 2), end))
        if draw.random() < 0.4:
            masses.append((10 ** draw.uniform(-1, 1), end))
    for ends in rows:
        if ends[0] and draw.random() < 0.25:
            masses.append((10 ** draw.uniform(-1, 1), {n: 1.0}))
            springs.append((10 ** draw.uniform(-1, 2), {n: 1.0} | {i: -x for i, x in ends[0].items()}))
            n += 1
    return FactoredSystem(n, masses, springs, pieces=pieces)


def squares_by_finite_elements(system, count, parts=20):
    """The lowest eigenvalues ω² with so many elements a piece, each a little too high."""
    n, elements = system.n, []
    for placed in system.pieces:
        piece, half = placed.piece, placed.piece.order // 2
        size, left = piece.length / parts, list(placed.rows[:half])
        for part in range(parts):
            right = list(placed.rows[half:])
            if part < parts - 1:
                right = [{n + way: 1.0} for way in range(half)]
                n += half
            if half == 2:
                matrices = beam_element(size, piece.bending, piece.tension, piece.inertia, piece.foundation)
                elements.append((left + right, *matrices))
            else:
                matrices = bar_element(size, piece.tension, piece.inertia, piece.foundation)
                elements.append(([*left, *right, {n: 1.0}], *matrices))
                n += 1
            left = right
    elements += [([row], np.array([[k]]), np.zeros((1, 1))) for k, row in system.springs]
    elements += [([row], np.zeros((1, 1)), np.array([[m]])) for m, row in system.inertias]
    stiffness, inertia = np.zeros((n, n)), np.zeros((n, n))
    for rows, k, m in elements:
        used = sorted({i for row in rows for i in row})
        along = np.array([[row.get(i, 0.0) for i in used] for row in rows]).reshape(len(rows), len(used))
        stiffness[np.ix_(used, used)] += along.T @ k @ along
        inertia[np.ix_(used, used)] += along.T @ m @ along
    inverse = np.linalg.inv(np.linalg.cholesky(inertia))
    return np.linalg.eigvalsh(inverse @ stiffness @ inverse.T)[:count]
