"""Means of functions of second degree of signals that vibrate freely by modes of members:

    ⟨f⟩ = f(y₀) + ½ Σ ∂²f/∂yᵢ∂yⱼ ⟨(yᵢ − y₀ᵢ)(yⱼ − y₀ⱼ)⟩,      ⟨Re Σ aₙe^{iωₙt} · Re Σ bₙe^{iωₙt}⟩ = ½ Σ Re aₙ b̄ₙ.

What modes left out add are vibrations of other frequencies, of the product of whose sums Σ|a| Σ|b| it is half at most.
"""

from math import inf
from typing import TYPE_CHECKING, Any, TypeGuard

import numpy as np

from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.results.composed_errors import propagated
from vibcli.results.modal_signals import ModalSignal
from vibcli.results.without_bound import without_bound
from vibcli.symbolic.derivatives import gradient
from vibcli.symbolic.evaluation import Floats, evaluate

if TYPE_CHECKING:
    from collections.abc import Mapping

    from vibcli.results.signals import ComposedSignal
    from vibcli.symbolic.node import Node

ALIKE = 1e-9        # relative: angular frequencies whose vibrations are taken together and apart


class Swings(NamedTuple):
    """Re Σ a e^{iωt} from an instant on, ω ascending, each once; off: how far Σ |a| may be off by rounding; left: a
    bound of what others of other frequencies add."""

    omega: np.ndarray
    sizes: np.ndarray
    off: float
    left: float

    def product(self, other: "Swings") -> tuple[float, float]:
        """(mean of the product with another, how far it may be off); what one has left out the other may hold."""
        both = np.concatenate([self.omega, other.omega])
        order = np.argsort(both, kind="stable")
        same = np.cumsum(np.diff(both[order], prepend=-inf) > ALIKE * both[order]) - 1
        place = np.empty(len(both), int)
        place[order] = same
        one, two = (np.zeros(int(same.max(initial=-1)) + 1, complex) for _ in range(2))
        one[place[:len(self.omega)]] = self.sizes
        two[place[len(self.omega):]] = other.sizes
        alone = [float(np.abs(x[y == 0]).sum()) for x, y in ((one, two), (two, one))]
        off = self.off * float(np.abs(two).sum()) + other.off * float(np.abs(one).sum()) + self.off * other.off
        left = self.left * other.left + self.left * alone[1] + other.left * alone[0]
        return float(np.real(one @ two.conj()) / 2), (off + left) / 2


def swings(signal: ModalSignal, start: float) -> Swings:
    """The free vibrations of a signal from an instant on."""
    motion = signal.modal
    left = motion.bound(signal.reads, start)
    if not left < inf:
        raise without_bound(motion, signal.reads, start)
    stretch = next(one for one in reversed(motion.stretches(start)) if one.start <= start)
    sizes, rates = motion.swings(signal.reads, stretch, motion.count)
    order = np.argsort(rates.imag)
    sizes, omega = sizes[order], rates[order].imag
    first = np.diff(omega, prepend=-inf) > ALIKE * omega
    together = np.zeros(int(first.sum()), complex)
    np.add.at(together, np.cumsum(first) - 1, sizes)
    return Swings(omega[first], together, signal.error(start) - left, left)


def mean_of_products(signal: "ComposedSignal", start: float,
                     still: "Mapping[str, tuple[float, float]]") -> tuple[float, float]:
    """(mean, how far it may be off) of a function of ModalSignals from an instant on; still: {name: (the mean of each,
    how far that may be off)}."""
    parts = signal.signals
    curved = _second_slopes(signal)
    values, errors = ({name: found[k] for name, found in still.items()} for k in range(2))
    known = {**signal.floats, **values}
    vibrations = {name: swings(part, start) for name, part in parts.items()}     # type: ignore[arg-type]

    def function(here: "Mapping[str, float]") -> float:
        found: float = evaluate([signal.node], Floats, {**signal.floats, **here})[0]
        return found
    total, off = function(values), propagated(function, values, errors)
    for (one, other), slope in curved.items():
        size = evaluate([slope], Floats, known)[0] / 2
        product, error = vibrations[one].product(vibrations[other])
        total += size * product
        off += abs(size) * error
    return total, off


def is_of_modes(signal: Any) -> "TypeGuard[ComposedSignal]":
    """Is it a function of ModalSignals alone?"""
    return all(isinstance(part, ModalSignal) for part in signal.signals.values())


def _second_slopes(signal: "ComposedSignal") -> "dict[tuple[str, str], Node]":
    """{(name, name): ∂²f} of a function of second degree; PhysicsError of others."""
    from vibcli.analyses.transient.wave_sums import WaveSum, WaveSums

    found = {(one.name, other.name): curved for one, slope in gradient(signal.node).items()
             for other, curved in gradient(slope).items()}
    waves = dict.fromkeys(signal.signals, WaveSum.of([(0.0, 1.0)], [0.0]))
    try:        # only of polynomials does that tell all
        evaluate([signal.node], WaveSums, {**signal.floats, **waves})
        known = not any(curved.mask for curved in found.values())
    except KeyError:
        known = False
    if not known:
        raise PhysicsError("of members that vibrate freely means are found of sums of squares and of products of two "
                           "signals, beside what repeats itself as waves bring it back", "ask for mean(x^2), or rms(x)")
    return found
