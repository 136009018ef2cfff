"""Shapes of modes that lie close to one another, orthogonal to each other as a motion in time needs them.

Each by itself is a mix with those beside it, by what rounds over how far they are apart, and the mixes of two do not
fit together. Here the space of a few near ones is found at once, beside where D has poles, and in it, with shapes φⱼ at
zⱼ = ωⱼ² of node values xⱼ (Rayleigh–Ritz),

    G = ⟨φⱼ, φₖ⟩ = xⱼᵀ ∫₀¹ ∂D/∂s² (zⱼ + σ (zₖ − zⱼ)) dσ xₖ,      A = zⱼ G + xₖᵀ D(zⱼ) xⱼ      A y = z G y.

What is left of a mix turns two near shapes alike, so that a motion by both feels it as little as it tells their
frequencies.
"""

from itertools import pairwise
from typing import TYPE_CHECKING, cast

import numpy as np

from vibcli.analyses.continuous.counting import scales
from vibcli.analyses.continuous.local_modes import SPARE, projected
from vibcli.analyses.continuous.natural_frequencies import blurring
from vibcli.analyses.continuous.rayleigh_steps import nearer, start
from vibcli.analyses.continuous.refinement import away_from_poles
from vibcli.numerics.sparse_elimination import product, quadratic

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from vibcli.analyses.continuous.system import ContinuousSystem
    from vibcli.analyses.modal.undamped import Mode

NEAR, SPACED = 1e-4, 1e-2   # a relative gap of ω that is small, or of the n-th this over n
WIDEST = 8          # times as wide all that are near one another may be
MOST = 24           # of them
STEPS, PASSES = 6, 6
SETTLED = 1e-12     # of a shape: a step as short is none
OFF = 4             # times its bound a z of the space may be off
POINTS = 4          # of Gauss's rule between two zⱼ


def near_ones(modes: "Sequence[Mode]") -> list[list[int]]:
    """The places of modes each next to another one, run by run, ascending."""
    found: list[list[int]] = []
    for k, (one, two) in enumerate(pairwise(modes)):
        if one.omega and two.omega and is_near(one, two) and one.growth_rate is None:
            if found and found[-1][-1] == k:
                found[-1].append(k + 1)
            else:
                found.append([k, k + 1])
    return found


def is_near(one: "Mode", two: "Mode") -> bool:
    """Is the second mode next to the first?"""
    return cast("bool", two.omega - one.omega <= min(NEAR, SPACED / two.index) * two.omega)


def orthogonal(modes: "Sequence[Mode]", find: "Callable[[], ContinuousSystem]") -> "tuple[list[Mode], np.ndarray]":
    """Modes of a system in floats, with shapes orthogonal to each other of those that are near; and numbers (modes,),
    which these share. Those that are known in closed form, or whose space is not found, are as they were."""
    found, numbers, system = list(modes), np.arange(len(modes)), None
    for places in near_ones(modes):
        own = [modes[k] for k in places]
        if len(own) <= MOST and not any(mode.motion.curves for mode in own) and (
                apart := _orthogonal(own, system := system or find())) is not None:
            numbers[places] = places[0]
            for k, mode in zip(places, apart, strict=True):
                found[k] = mode
    return found, numbers


def _orthogonal(modes: "Sequence[Mode]", system: "ContinuousSystem") -> "list[Mode] | None":
    """The same of modes that are near one another; None where their space is not found."""
    z, errors = (np.array([float(part) for part in parts]) for parts in zip(
        *((mode.motion.z, mode.error) for mode in modes), strict=True))
    if z[-1] - z[0] > WIDEST * min(NEAR, SPACED / modes[0].index) * z[-1]:
        return None
    system = away_from_poles(system, z[0], z[-1])
    x, middle = _space(system, z), (z[0] + z[-1]) / 2
    if x.shape[1] < len(z):
        return None
    for _ in range(PASSES):
        x, beyond = _without_others(system, z, middle, x)
        moved, turn = _turned(system, z, middle, x)
        x = x @ turn
        if beyond <= SETTLED and abs(turn - np.diag(np.diag(turn))).max() <= SETTLED * abs(turn).max():
            break
    if not (abs(middle + moved - z) <= (OFF * errors + SETTLED) * z).all():
        return None
    _, sizes, slope = system.dynamic_stiffness(z)
    blurred = np.sqrt(blurring(system, z, x, sizes, scales(system, z, sizes, slope)))
    return [mode._replace(shape=system.in_scene(x[:, k])[:len(mode.shape)],
                          motion=mode.motion._replace(z=z[k], shape=system.in_scene(x[:, k]), system=system,
                                                      whole=x[:, k], blurred=blurred[:, k]))
            for k, mode in enumerate(modes)]


def _space(system: "ContinuousSystem", z: np.ndarray) -> np.ndarray:
    """About the shapes at z, ascending."""
    wanted, middle = len(z), system.numbers([(z[0] + z[-1]) / 2])
    entries, _, slope = system.dynamic_stiffness(middle)
    inertia = np.abs(slope[:system.n])      # of each coordinate: what is light moves the further
    x = start(system, min(wanted + SPARE, system.n)) / np.sqrt(np.where(inertia, inertia, inertia.max()))
    for _ in range(STEPS):
        x = nearer(system, middle, product(system.pattern, slope, x))
        moved, x = projected(system, entries, slope, x)
    return cast("np.ndarray", x[:, np.sort(np.argsort(abs(moved))[:wanted])])


def _without_others(system: "ContinuousSystem", z: np.ndarray, middle: float,
                    x: np.ndarray) -> tuple[np.ndarray, float]:
    """x less what is left of other modes than these, and how much that was of it."""
    entries, _, slope = system.dynamic_stiffness(z)
    away = nearer(system, system.numbers([middle]), product(system.pattern, entries, x))
    mass = product(system.pattern, slope, x)
    away = away - x @ np.linalg.solve(mass.T @ x, mass.T @ away)
    return x - away, (abs(away) / abs(x).max(axis=1, keepdims=True)).max()


def _turned(system: "ContinuousSystem", z: np.ndarray, middle: float, x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """By how much z is off the middle, and the combinations y of the x that are the shapes, orthonormal."""
    left = product(system.pattern, system.dynamic_stiffness(z)[0], x)
    j, k = np.triu_indices(len(z))
    at, weights = np.polynomial.legendre.leggauss(POINTS)
    between = ((z[j] + z[k])[:, None] + (z[k] - z[j])[:, None] * at) / 2
    slopes = system.dynamic_stiffness(between.ravel())[2].reshape(-1, len(j), POINTS) @ (weights / 2)
    G = np.zeros((len(z),) * 2)
    G[j, k] = G[k, j] = quadratic(system.pattern, slopes, x[:, j], x[:, k])
    A = (z - middle) * G + x.T @ left
    sizes = np.sqrt(np.diag(G))
    G, A = (part / sizes / sizes[:, None] for part in (G, (A + A.T) / 2))
    half = np.linalg.inv(np.linalg.cholesky(G)).T
    moved, y = np.linalg.eigh(half.T @ A @ half)
    return moved, half @ y / sizes[:, None]
