"""Pieces whose tension varies along them: stiffness, held count and fields by short parts joined two and two."""

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from vibcli.numerics.pieces.graded_parts import (
    depth_of,
    end_derivatives,
    is_slack,
    parts_of,
    slack_series,
    sums,
)
from vibcli.numerics.pieces.graded_tree import graded_tree, ports
from vibcli.numerics.pieces.scattering import divided, stiffness_again

if TYPE_CHECKING:
    import mpmath

    from vibcli.numerics.pieces.arithmetic import Arithmetic
    from vibcli.numerics.pieces.graded_tree import GradedTree
    from vibcli.numerics.pieces.piece import Piece

AT_ONCE, HELD = 4_000, 2**21        # parts times values of κ, and times places
LIKE = 2.0              # times as many parts at most as the lowest of them needs, |κ|^(1/order)


def mirrored(piece: "Piece") -> "Piece":
    """Seen from its other end."""
    return piece._replace(tension=piece.tension + piece.gradient * piece.length, gradient=-piece.gradient)


def _settled(piece: "Piece") -> "Piece":
    """With no tension where that is a rounding of none: waves that are as slow there would feel it."""
    return piece._replace(tension=0 * piece.tension) if piece.order == 2 and is_slack(piece) else piece


def graded_stiffness(piece: "Piece", kappa: np.ndarray, numbers: "Arithmetic") -> tuple[np.ndarray, np.ndarray]:
    """(d, ∂d/∂κ), (κ, m, m), of one piece over flat κ. An end without tension of what is no beam bears no force."""
    if piece.order == 2 and piece.gradient < 0:
        d, slope = graded_stiffness(mirrored(piece), kappa, numbers)
        return d[..., ::-1, ::-1], slope[..., ::-1, ::-1]
    piece = _settled(piece)
    real = numbers.is_real(kappa)
    parted = np.array([real and depth_of(piece, x, numbers) + depth_of(mirrored(piece), x, numbers) < piece.length
                       for x in kappa], bool)
    found = [np.zeros((len(kappa), piece.order, piece.order), kappa.dtype) for _ in range(2)]
    for chosen, of in ((parted, _of_parted_ends), (~parted, _of_joined_ends)):
        if chosen.any():
            for values, some in zip(found, of(piece, kappa[chosen], numbers), strict=True):
                values[chosen] = some
    return found[0], found[1]


def _of_parted_ends(piece: "Piece", kappa: np.ndarray, numbers: "Arithmetic") -> np.ndarray:
    """(d, ∂d/∂κ), (κ, m, m), at κ at which no end feels the other: each that of the layer next to it, as deep as the
    least of like κ needs."""
    half = piece.order // 2
    found = np.zeros((2, len(kappa), piece.order, piece.order), kappa.dtype)
    signs = numbers.array([1, -1][:half])       # slopes turn round in the mirror
    for own, seen, turned in ((slice(0, half), piece, signs * signs), (slice(half, None), mirrored(piece), signs)):
        left = np.argsort(kappa)
        while len(left):
            layer = seen._replace(length=depth_of(seen, kappa[left[0]], numbers))
            along = mirrored(layer) if piece.order == 2 and layer.gradient < 0 else layer
            run = left[next(_runs(along, kappa[left]))]
            for values, some in zip(found, graded_stiffness(layer, kappa[run], numbers), strict=True):
                values[run, own, own] = some[:, :half, :half] * turned[:, None] * turned
            left = left[len(run):]
    return found


def _of_joined_ends(piece: "Piece", kappa: np.ndarray, numbers: "Arithmetic") -> tuple[np.ndarray, np.ndarray]:
    """(d, ∂d/∂κ) of the whole, from all its parts."""
    found, real = [], numbers.is_real(kappa)
    order, portions = _portions(piece, kappa)
    for some in portions:
        tree = graded_tree(piece, some, numbers)
        whole = [values[0] for values in stiffness_again(tree.levels[-1], ports(tree, -1), numbers)]
        whole = [(values + values.swapaxes(-1, -2)) / 2 for values in whole]
        found.append([numbers.real(values) if real else values for values in whole])
    d, slope = (np.concatenate(values)[order] for values in zip(*found, strict=True))
    if piece.order == 2 and is_slack(piece):
        for values in (d, slope):
            values[:, 0, :] = values[:, :, 0] = 0 * values[:, :, 0]
    return d, slope


def graded_count(piece: "Piece", kappa: np.ndarray, numbers: "Arithmetic") -> np.ndarray:
    """J₀ over flat real κ: no part vibrates between held ends, so it is the number of negative stiffnesses of the
    joints, two parts at a time."""
    if piece.order == 2 and piece.gradient < 0:
        return graded_count(mirrored(piece), kappa, numbers)
    piece, found = _settled(piece), []
    order, portions = _portions(piece, kappa)
    for some in portions:
        tree = graded_tree(piece, some, numbers, False)
        found.append(sum(_negative(tree, i, numbers) for i in range(len(tree.levels) - 1)) + np.zeros(len(some), int))
    result: np.ndarray = np.concatenate(found)[order]
    return result


def graded_fields(piece: "Piece", kappa: np.ndarray, ends: np.ndarray, x: np.ndarray,
                  numbers: "Arithmetic") -> np.ndarray:
    """(u, u′, …), (values, order), of one piece over flat κ, end values (values, order), places x."""
    if piece.order == 2 and piece.gradient < 0:
        found = graded_fields(mirrored(piece), kappa, ends[:, ::-1], piece.length - x, numbers)
        result: np.ndarray = found * numbers.array([1, -1])
        return result
    piece = _settled(piece)
    found = np.empty((len(x), piece.order), np.result_type(kappa, ends, x))
    real = numbers.is_real(kappa) and numbers.is_real(ends)
    for chosen in _together(piece, kappa):
        some = _fields(piece, kappa[chosen], ends[chosen], x[chosen], numbers)
        found[chosen] = numbers.real(some) if real else some
    return found


def graded_integrals(piece: "Piece", kappa: np.ndarray, x: np.ndarray, weights: np.ndarray,
                     numbers: "Arithmetic") -> np.ndarray:
    """Σ weights · u over places x of one piece, (κ, order), of the fields that have one end value 1 each, by the
    moments Σ weights ηᵏ of its parts."""
    if piece.order == 2 and piece.gradient < 0:
        return graded_integrals(mirrored(piece), kappa, piece.length - x, weights, numbers)[:, ::-1]
    piece = _settled(piece)
    found = np.empty((len(kappa), piece.order), np.result_type(kappa, weights))
    real = numbers.is_real(kappa) and numbers.is_real(weights)
    for chosen in _runs(piece, kappa):
        some = _integrals(piece, kappa[chosen], x, weights, numbers)
        found[chosen] = numbers.real(some) if real else some
    return found


def _integrals(piece: "Piece", kappa: np.ndarray, x: np.ndarray, weights: np.ndarray,
               numbers: "Arithmetic") -> np.ndarray:
    tree, order = graded_tree(piece, kappa, numbers, False), piece.order
    of, unit = np.repeat(np.arange(len(kappa)), order), numbers.array(np.tile(np.eye(order), (len(kappa), 1)))
    ends, places = _part_ends(piece, tree, of, unit, numbers), numbers.array(tree.cuts)
    c, half = tree.series.numbers(tree.series.c), tree.series.half
    (index, eta), power, found = _places_in(places, half, x), weights, 0 * kappa[of]
    if order == 2 and is_slack(piece) and (near := index == 0).any():
        u = _near_slack(piece, tree.cuts[1], kappa[of, None], ends[0, :, 1:], x[None, near], numbers)[..., 0]
        found, power = u @ weights[near], np.where(near, 0, weights)
    moments = np.zeros((len(c), len(half)), power.dtype)
    for k in range(len(c)):
        np.add.at(moments[k], index, power)
        power = power * eta
    sums_of_parts = (moments[..., None, None] * c).sum(axis=0)[:, of]
    found = found + (sums_of_parts * _first_coefficients(piece, c, half, of, ends, numbers)).sum(axis=(0, -1))
    result: np.ndarray = found.reshape(len(kappa), order)
    return result


def _together(piece: "Piece", kappa: np.ndarray) -> Iterator[np.ndarray]:
    """Numbers of values in groups of those whose κ are the same or alike, as many as are worth being held at once."""
    at, own = _distinct(kappa)
    order = np.argsort(own, kind="stable")
    edges = np.searchsorted(own[order], np.arange(len(at) + 1))
    for run in _runs(piece, kappa[at]):
        chosen = np.concatenate([order[edges[k]:edges[k + 1]] for k in run])
        most = max(1, HELD // len(parts_of(piece, max(float(abs(value)) for value in kappa[at[run]]))))
        yield from (chosen[i:i + most] for i in range(0, len(chosen), most))


def _runs(piece: "Piece", kappa: np.ndarray) -> Iterator[np.ndarray]:
    """Numbers of fields in groups of like |κ|, so that all in one have about the parts that they need."""
    sizes = np.array([float(abs(value)) for value in kappa])
    order = np.argsort(sizes, kind="stable")
    while len(order):
        alike = max(1, int(np.searchsorted(sizes[order], LIKE**piece.order * sizes[order[0]], side="right")))
        count = min(alike, max(1, AT_ONCE // len(parts_of(piece, sizes[order[alike - 1]]))))
        yield order[:count]
        order = order[count:]


def _portions(piece: "Piece", kappa: np.ndarray) -> tuple[np.ndarray, list[np.ndarray]]:
    """(the number of each κ among all of the portions, κ by their size in portions that need about as many parts)."""
    runs = list(_runs(piece, kappa))
    return np.argsort(np.concatenate(runs)), [kappa[run] for run in runs]


def _negative(tree: "GradedTree", i: int, numbers: "Arithmetic") -> np.ndarray:
    """How many negative eigenvalues the stiffnesses of joints that a level loses have, (κ)."""
    level = tree.levels[i]
    pairs, h = len(level.s) // 2, level.s.shape[-1] // 2
    d, _ = stiffness_again(level, np.ones(level.s.shape[-1]), numbers)
    joint = numbers.real(d[:2 * pairs:2, :, h:, h:] + d[1:2 * pairs:2, :, :h, :h])
    if h == 1:
        found: np.ndarray = (joint[..., 0, 0] < 0).sum(axis=0)
        return found
    determinant = joint[..., 0, 0] * joint[..., 1, 1] - joint[..., 0, 1] * joint[..., 1, 0]
    result: np.ndarray = np.where(determinant < 0, 1, 2 * (joint[..., 0, 0] + joint[..., 1, 1] < 0)).sum(axis=0)
    return result


def _fields(piece: "Piece", kappa: np.ndarray, ends: np.ndarray, x: np.ndarray, numbers: "Arithmetic") -> np.ndarray:
    """At a κ each: what goes into the whole goes into its parts, whose end values follow; those of one κ and the same
    end values are one field at several places."""
    at, own = _distinct(kappa)
    first, field = _distinct(np.stack([own, *(_distinct(column)[1] for column in ends.T)], axis=-1))
    values, of = kappa[at], own[first]
    tree = graded_tree(piece, values, numbers, False)
    parts = _part_ends(piece, tree, of, ends[first], numbers)
    found, index = _within(piece, tree, (of, field), parts, x, numbers)
    if piece.order == 2 and is_slack(piece) and (index == 0).any():
        near = np.flatnonzero(index == 0)
        found[near] = _near_slack(piece, tree.cuts[1], kappa[near], parts[0, field[near], 1], x[near], numbers)
    return found


def _distinct(values: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """(places of the values, or rows, that differ, the number of each among these)."""
    if values.dtype.kind != "O":
        _, places, numbers = np.unique(values, axis=0, return_index=True, return_inverse=True)
        return places, numbers.reshape(-1)
    known: dict[Any, int] = {}
    numbers = np.array([known.setdefault(value, len(known)) for value in values.tolist()], int)
    return np.unique(numbers, return_index=True)[1], numbers


def _part_ends(piece: "Piece", tree: "GradedTree", of: np.ndarray, ends: np.ndarray,
               numbers: "Arithmetic") -> np.ndarray:
    """The end values of all parts, (parts, fields, order), of fields with these end values; of: the numbers of their
    κ."""
    scale = ports(tree, -1)[0, of]
    d = stiffness_again(tree.levels[-1], ports(tree, -1), numbers)[0][0, of]
    if piece.order == 2 and is_slack(piece):
        ends = ends * numbers.array([0, 1])
    inward = ((ends[:, None, :] @ d)[:, 0] * scale + numbers.i * ends / scale)[None]
    for level in reversed(tree.levels[:-1]):
        inward = divided(level.s[:, of], inward, numbers)
    outward = (tree.levels[0].s[:, of] @ inward[..., None])[..., 0]
    found: np.ndarray = (inward - outward) / (2 * numbers.i) * ports(tree, 0)[:, of]
    return found


def _within(piece: "Piece", tree: "GradedTree", which: tuple[np.ndarray, np.ndarray], parts: np.ndarray, x: np.ndarray,
            numbers: "Arithmetic") -> tuple[np.ndarray, np.ndarray]:
    """(the series of the part in which each place lies, from its end values; the number of that part); which: (the
    number of the κ of each field, the number of the field at each place)."""
    (of, field), places, half = which, numbers.array(tree.cuts), tree.series.half
    c = tree.series.numbers(tree.series.c)
    index, eta = _places_in(places, half, x)
    weights = _first_coefficients(piece, c, half, of, parts, numbers)
    met, place = _distinct(index * len(of) + field)
    part, one = index[met], field[met]
    terms = (c[:, part, of[one]] * weights[part, one]).sum(axis=-1)[:, place]
    return np.stack([sums(terms, eta, j) / half[index, 0, 0] ** j for j in range(piece.order)], axis=-1), index


def _places_in(places: np.ndarray, half: np.ndarray, x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """(the number of the part in which each place lies, η there)."""
    index = np.clip(np.searchsorted(places.astype(float), x.astype(float), side="right") - 1, 0, len(places) - 2)
    return index, (x - (places[index] + places[index + 1]) / 2) / half[index, 0, 0]


def _first_coefficients(piece: "Piece", c: np.ndarray, half: np.ndarray, of: np.ndarray, parts: np.ndarray,
                        numbers: "Arithmetic") -> np.ndarray:
    """Those of the series in all parts, (parts, fields, order), that have these end values."""
    values = np.concatenate([np.stack([one / half**j for j, one in enumerate(at_end)], axis=-2)
                             for at_end in end_derivatives(c, piece.order // 2)], axis=-2)
    return np.asarray((numbers.inverse(values)[:, of] @ parts[..., None])[..., 0])


def _near_slack(piece: "Piece", end: "float | mpmath.mpf", kappa: np.ndarray, value: np.ndarray, x: np.ndarray,
                numbers: "Arithmetic") -> np.ndarray:
    """(u, u′) next to the end without tension; u′ = κ/n there."""
    whole, u = (slack_series(piece, place, kappa, numbers) for place in (end, x))
    slope = np.where(x == 0, kappa / piece.gradient, u[1] / np.where(x == 0, 1, x))
    return np.asarray(np.stack([u[0], slope], axis=-1) * (value / whole[0])[..., None])
