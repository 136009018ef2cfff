"""Where the energy of a mode is: the share of each spring, of each body, and of each damper in what is dissipated.

    spring s   ½ k |∇s·φ|² / ½ φᴴKφ        body   ½ Σ w |∇s·φ|² / ½ φᴴMφ        damper   c |∇s·u|² / uᴴCu

K and M are the sums of their parts, so the shares of a mode add up to one. A part that lowers K, such as the weight of
an inverted pendulum, has a negative share. Of gyroscopic and damped modes they are those of the mean over a period.
"""

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import mpmath

from vibcli.analyses.modal.modes_precise import WORKING, coinciding
from vibcli.base.named_tuple import NamedTuple
from vibcli.mechanics.element_contributions import owned_forms
from vibcli.mechanics.inner_products import inner

if TYPE_CHECKING:
    import numpy as np

    from vibcli.analyses.modal.modal_analysis import ModalAnalysis
    from vibcli.mechanics.element_contributions import Owned

NONE = 1e-20    # a share, or of its scale a sum, that is rounding


class Shares(NamedTuple):
    """potential, kinetic: {index of a mode: {name: share}}; dissipation: [(damped mode, {name: share})], None where
    nothing damps. Where there is no such energy, as V of a rigid mode, there are no shares. coinciding: lists of the
    indices of modes of one frequency, whose shapes may be mixed at will."""

    potential: dict[int, dict[str, Any]]
    kinetic: dict[int, dict[str, Any]]
    dissipation: list[tuple[Any, dict[str, Any]]] | None
    coinciding: list[list[int]]


def shares(modal: "ModalAnalysis", _: Any) -> Shares:
    """The Shares of a system."""
    with mpmath.workdps(WORKING):
        modes, owned, dissipation = modal.sharp_modes, owned_forms(modal.configuration), None
        kinetic = {mode.index: _shares(owned.kinetic, mode.shape) for mode in modes}
        potential = {mode.index: {} if mode.rigid else _shares(
            owned.potential, mode.shape, _energy(owned, mode.shape, mode.omega or mode.growth_rate)) for mode in modes}
        if modal.damped is not None:
            dissipation = []
            for mode in (mode for mode in modal.damped.shown() if mode.omega):
                shape = [mpmath.mpmathify(complex(x)) for x in mode.shape]
                lost = _shares(owned.dissipation, shape, _energy(owned, shape, mode.omega) / mode.omega)
                dissipation.append((mode, lost))
    return Shares(potential, kinetic, dissipation, coinciding(modes))


def _shares(parts: dict[str, tuple[list[tuple[mpmath.mpf, dict[int, Any]]], dict[tuple[int, int], mpmath.mpf]]],
            shape: "list[mpmath.mpc] | np.ndarray", scale: int | mpmath.mpf = 0) -> dict[str, float]:
    """{name: share} of the quadratic forms of parts in their sum, as floats; nothing where that is none of `scale`."""
    sizes = _sizes(parts, shape)
    total = sum(sizes.values())
    if not abs(total) > NONE * scale:
        return {}
    return {name: float(size / total) if abs(size) > NONE * abs(total) else 0.0 for name, size in sizes.items()}


def _energy(owned: "Owned", shape: "list[mpmath.mpc] | np.ndarray", rate: float | mpmath.mpf) -> mpmath.mpf:
    """|λ|² φᴴMφ: what the forms of a mode are measured by."""
    return rate**2 * sum(_sizes(owned.kinetic, shape).values())


def _sizes(parts: Mapping[str, tuple[list[tuple[mpmath.mpf, dict[int, Any]]], dict[tuple[int, int], mpmath.mpf]]],
           shape: "list[mpmath.mpc] | np.ndarray") -> dict[str, mpmath.mpf]:
    return {name: inner(rows, matrix, shape, shape).real for name, (rows, matrix) in parts.items()}
