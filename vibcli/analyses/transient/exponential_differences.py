"""Divided differences of the exponential, the shape of every linear response.

    E[λ₁](t) = e^{λ₁t}        E[λ₁…λₘ] = (E[λ₁…λₘ₋₁] − E[λ₂…λₘ]) / (λ₁ − λₘ)        E[λ…λ] = t^{m−1} e^{λt} / (m−1)!

With Laplace transform 1/Π(p − λᵢ), E[λ₁, λ₂] answers an impulse on an oscillator with the poles λ₁ and λ₂,
E[λ₁, λ₂, s] a force e^{st}, and k! E[λ₁, λ₂, s…s] with k + 1 times s a force tᵏe^{st}: critical damping, resonance,
beats and rigid motion are nodes that coincide or nearly do. The quotient is taken of the two nodes farthest apart, and
where that distance times t is small a series replaces it, so nothing cancels (McCurdy, Ng & Parlett 1984).
"""

import math
from collections.abc import Callable, Sequence
from functools import lru_cache
from typing import Any

import numpy as np

NEAR = 2.0
TERMS, SINH = 40, 8
BEATING = 1 / 8     # of their size, the distance within which nodes beat slowly

Known = dict[Any, Any]      # {nodes: what was found of them; the bytes of a mask of the times: the same there}


def exponential(node: complex, t: np.ndarray) -> np.ndarray:
    """e^{λt} for real times, of real type for a real λ."""
    decay = np.exp(node.real * t)
    if not node.imag:
        return decay
    angle, out = node.imag * t, np.empty(np.shape(t), complex)
    np.multiply(decay, np.cos(angle), out=out.real)
    np.multiply(decay, np.sin(angle), out=out.imag)
    return out


def real_wave(factor: complex | np.ndarray, node: complex, t: np.ndarray,
              known: Known) -> float | np.ndarray:
    """Re(factor e^{λt}); `known`: what was found at the same times."""
    if node not in known:
        decay, angle = np.exp(node.real * t) if node.real else 1.0, node.imag * t
        known[node] = (decay, np.cos(angle), np.sin(angle)) if node.imag else (decay, None, None)
    decay, cosine, sine = known[node]
    if cosine is None:
        found: float | np.ndarray = np.real(factor) * decay
        return found
    result: float | np.ndarray = decay * (np.real(factor) * cosine - np.imag(factor) * sine)
    return result


def differences(nodes: Sequence[complex], t: np.ndarray,
                known: Known | None = None) -> np.ndarray:
    """E[nodes] at an array of times, exact to a few roundings of |node| t; `known`: what was found at the same times.
    """
    known = {} if known is None else known

    def of(nodes: "tuple[complex, ...]") -> np.ndarray:
        if nodes not in known:
            known[nodes] = _difference(nodes, t, of)
        found: np.ndarray = known[nodes]
        return found

    return of(tuple(sorted(map(complex, nodes), key=lambda s: (s.real, s.imag))))


def _difference(nodes: tuple[complex, ...], t: np.ndarray,
                of: Callable[[tuple[complex, ...]], np.ndarray]) -> np.ndarray:
    if len(nodes) == 1:
        return exponential(nodes[0], t)
    i, j = farthest(nodes)
    gap = nodes[i] - nodes[j]
    if not gap:
        found: np.ndarray = t ** (len(nodes) - 1) / math.factorial(len(nodes) - 1) * exponential(nodes[0], t)
        return found
    near = abs(gap) * t <= NEAR
    if near.all():
        return _series(nodes, t)
    out: np.ndarray = (of(nodes[:j] + nodes[j + 1:]) - of(nodes[:i] + nodes[i + 1:])) / gap
    if near.any():
        out[near] = _series(nodes, t[near])
    return out


@lru_cache(1000)
def farthest(nodes: tuple[complex, ...]) -> tuple[int, int]:
    """The places i < j of the two nodes farthest apart."""
    pairs = ((i, j) for i in range(len(nodes)) for j in range(i + 1, len(nodes)))
    return max(pairs, key=lambda pair: abs(nodes[pair[0]] - nodes[pair[1]]))


def _series(nodes: tuple[complex, ...], t: np.ndarray) -> np.ndarray:
    """e^{at} Σ hₖ t^{m−1+k} / (m−1+k)! with the mean a of the nodes, hₖ the complete symmetric polynomials of λ − a."""
    m = len(nodes)
    if m == 2:
        return _pair(nodes, t)
    mean = sum(nodes) / m
    top = float(t.max(initial=0.0))
    offsets = [(node - mean) * top for node in nodes]
    reach = max(map(abs, offsets))
    count = next((k for k in range(1, TERMS) if reach**k < 1e-18 * math.factorial(k)), TERMS)
    h: list[complex] = [1.0, *([0.0] * (count - 1))]
    for offset in offsets:
        for k in range(1, count):
            h[k] = h[k] + offset * h[k - 1]
    real = not any(np.imag(h))
    share = t / top if top else t
    total = np.zeros(np.shape(t), float if real else complex)
    for k in reversed(range(count)):
        total *= share
        total += (h[k].real if real else h[k]) * math.factorial(m - 1) / math.factorial(m - 1 + k)
    found: np.ndarray = t ** (m - 1) / math.factorial(m - 1) * exponential(mean, t) * total
    return found


def _pair(nodes: tuple[complex, ...], t: np.ndarray) -> np.ndarray:
    """t e^{at} sinh(z)/z with the mean a of two nodes and z half their distance times t, |z| <= 1."""
    half = (nodes[0] - nodes[1]) / 2
    square = half * half
    z = (square if square.imag else square.real) * t * t
    total = np.ones_like(z)
    for k in range(SINH, 0, -1):
        total *= z / (2 * k * (2 * k + 1))
        total += 1.0
    found: np.ndarray = t * exponential(nodes[1] + half, t) * total
    return found


def bounds(nodes: Any, early: Any, late: Any,
           known: Known | None = None) -> Any:
    """Upper bounds of |E[nodes](t)| on the intervals early <= t <= late; `known`: those found on the same ones."""
    known = {} if known is None else known
    if nodes not in known:
        known[nodes] = _bounds(nodes, early, late, known)
    return known[nodes]


def _bounds(nodes: tuple[complex, ...], early: np.ndarray, late: np.ndarray,
            known: Known) -> np.ndarray:
    m = len(nodes)
    fastest = np.exp(np.maximum(*(max(node.real for node in nodes) * t for t in (early, late))))
    found: np.ndarray = fastest * late ** (m - 1) / math.factorial(m - 1)
    if m > 1:
        i, j = farthest(nodes)
        gap = abs(nodes[i] - nodes[j])
        if gap:
            apart = (bounds(nodes[:j] + nodes[j + 1:], early, late, known)
                     + bounds(nodes[:i] + nodes[i + 1:], early, late, known))
            found = np.minimum(found, apart / gap)
            if m == 2 and gap < BEATING * abs(nodes[0]):
                found = np.minimum(found, fastest * _beat(nodes, early, late) / gap)
    return found


def _beat(nodes: tuple[complex, ...], early: np.ndarray, late: np.ndarray) -> np.ndarray:
    """What |e^{at} − e^{bt}| does not exceed on the intervals beside the faster of the two, nor as it is found in
    floats: |1 − q e^{2iy}|² = (1 − q)² + 4 q sin²y, with the decay q of the one beside the other and half the angle y
    between them."""
    a, b = nodes
    apart, turns = abs(a.real - b.real), abs(a.imag - b.imag) / (2 * math.pi)
    sine = np.maximum(*(np.abs(np.sin(math.pi * turns * t)) for t in (early, late)))
    sine = np.where(np.floor(turns * late - 0.5) > np.floor(turns * early - 0.5), 1.0, sine)
    beat = np.hypot(np.expm1(-apart * late), 2 * np.exp(-apart * early / 2) * sine)
    found: np.ndarray = beat + 2**-51 * max(abs(a), abs(b)) * late * np.minimum(1.0, abs(a - b) * late)
    return found


def real_sum(terms: Sequence[tuple[int, tuple[complex, ...], np.ndarray | slice, complex | np.ndarray]],
             known: Known,
             t: np.ndarray) -> np.ndarray:
    """Σ Re(factor tᵏ E[nodes]) of terms (k, nodes, which of the times, factors there); `known`: what other sums found
    at the same times."""
    total = np.zeros(len(t))
    for power, nodes, inside, factor in terms:
        here, found = t[inside], _known_there(known, inside)
        part = (real_wave(factor, nodes[0], here, found) if len(nodes) == 1
                else np.real(factor * differences(nodes, here, found)))
        total[inside] += here**power * part if power else part
    return total


def largest_sum(terms: Sequence[tuple[int, tuple[complex, ...], np.ndarray | slice, complex | np.ndarray]],
                known: Known, early: np.ndarray, late: np.ndarray) -> np.ndarray:
    """An upper bound of the magnitude of the same on the intervals early <= t <= late; `known`: what other sums found
    on the same ones."""
    total = np.zeros(len(early))
    for power, nodes, inside, factor in terms:
        found = _known_there(known, inside)
        part = bounds(nodes, early[inside], late[inside], found)
        total[inside] += np.abs(factor) * (late[inside]**power * part if power else part)
    return total


def _known_there(known: Known,
                 inside: np.ndarray | slice) -> Known:
    """What is known at those of the times that a term acts at."""
    return known if isinstance(inside, slice) else known.setdefault(inside.tobytes(), {})
