"""Parts joined end to end by what they reflect and let through, which nothing in between makes large.

With û = √Z u, f̂ = f/√Z at the ends, Z > 0 a stiffness chosen for each node, a = f̂ + i û goes in, b = f̂ − i û = S a
comes out: S = (d̂ − i)(d̂ + i)⁻¹, unitary for real d. At a joint û is one and the forces cancel.
"""

from typing import TYPE_CHECKING

import numpy as np

from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    from vibcli.numerics.pieces.arithmetic import Arithmetic


class Level(NamedTuple):
    """S and ∂S/∂κ of some parts, (parts, κ, m, m), m/2 values at either end; None where no slope is asked for."""

    s: np.ndarray
    slope: np.ndarray | None


def scattered(stiffness: np.ndarray, slope: np.ndarray | None, scale: np.ndarray, numbers: "Arithmetic") -> Level:
    """S of d with Z, (parts, κ, m): S = 1 − 2i (d̂ + i)⁻¹."""
    both = scale[..., :, None] * scale[..., None, :]
    one, i = _unit(stiffness, numbers)
    inverse = numbers.inverse(stiffness * both + i)
    return Level(one - 2 * i @ inverse, None if slope is None else 2 * i @ inverse @ (slope * both) @ inverse)


def stiffness_again(level: Level, scale: np.ndarray, numbers: "Arithmetic") -> tuple[np.ndarray, np.ndarray | None]:
    """(d, ∂d/∂κ) of S: d̂ = 2i (1 − S)⁻¹ − i."""
    one, i = _unit(level.s, numbers)
    inverse = numbers.inverse(one - level.s)
    both = scale[..., :, None] * scale[..., None, :]
    return (2 * i @ inverse - i) / both, (
        None if level.slope is None else 2 * i @ inverse @ level.slope @ inverse / both)


def _unit(values: np.ndarray, numbers: "Arithmetic") -> tuple[np.ndarray, np.ndarray]:
    one = numbers.array(np.eye(values.shape[-1]))
    return one, one * numbers.i


def joined(level: Level, numbers: "Arithmetic") -> Level:
    """Neighbours in pairs; a last one without partner stays."""
    pairs = len(level.s) // 2
    left, right = (Level(*(None if values is None else values[j:2 * pairs:2] for values in level)) for j in range(2))
    return Level(*(None if found is None else np.concatenate([found, values[2 * pairs:]])
                   for found, values in zip(_star(left, right, numbers), level, strict=True)))


def _blocks(values: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    h = values.shape[-1] // 2
    return values[..., :h, :h], values[..., :h, h:], values[..., h:, :h], values[..., h:, h:]


def _whole(one: np.ndarray, two: np.ndarray, three: np.ndarray, four: np.ndarray) -> np.ndarray:
    return np.concatenate([np.concatenate(part, axis=-1) for part in ((one, two), (three, four))], axis=-2)


def _star(left: Level, right: Level, numbers: "Arithmetic") -> tuple[np.ndarray, np.ndarray]:
    """S of two in a row (Redheffer's product with f and −f at the joint), and ∂S/∂κ where it is found of both."""
    l11, l12, l21, l22 = _blocks(left.s)
    r11, r12, r21, r22 = _blocks(right.s)
    one = numbers.array(np.eye(l11.shape[-1]))
    p = numbers.inverse(one - l22 @ r11)
    a, b = r11 @ p, p @ l22
    through = one + a @ l22
    s = _whole(l11 + l12 @ a @ l21, -l12 @ through @ r12, -r21 @ p @ l21, r22 + r21 @ b @ r12)
    if left.slope is None:
        return s, None
    d11, d12, d21, d22 = _blocks(left.slope)
    e11, e12, e21, e22 = _blocks(right.slope)
    dp = p @ (d22 @ r11 + l22 @ e11) @ p
    da, db = e11 @ p + r11 @ dp, dp @ l22 + p @ d22
    slope = da @ l22 + a @ d22
    return s, _whole(d11 + d12 @ a @ l21 + l12 @ da @ l21 + l12 @ a @ d21,
                     -(d12 @ through @ r12 + l12 @ slope @ r12 + l12 @ through @ e12),
                     -(e21 @ p @ l21 + r21 @ dp @ l21 + r21 @ p @ d21),
                     e22 + e21 @ b @ r12 + r21 @ db @ r12 + r21 @ b @ e12)


def divided(s: np.ndarray, inward: np.ndarray, numbers: "Arithmetic") -> np.ndarray:
    """What goes into the parts of a level with S, (parts, κ, m), from what goes into the pairs joined of it."""
    pairs = len(s) // 2
    h = inward.shape[-1] // 2
    _, _, l21, l22 = _blocks(s[:2 * pairs:2])
    r11, r12, _, _ = _blocks(s[1:2 * pairs:2])
    first, last = inward[:pairs, :, :h, None], inward[:pairs, :, h:, None]
    inverse = numbers.inverse(numbers.array(np.eye(h)) - l22 @ r11)
    out = inverse @ (l21 @ first - l22 @ r12 @ last)
    back = r11 @ out - r12 @ last
    found = np.empty((len(s), *inward.shape[1:]), out.dtype)
    found[:2 * pairs:2] = np.concatenate([first, back], axis=-2)[..., 0]
    found[1:2 * pairs:2] = np.concatenate([-out, last], axis=-2)[..., 0]
    found[2 * pairs:] = inward[pairs:]
    return found
