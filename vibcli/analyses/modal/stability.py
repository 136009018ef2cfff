"""Is an equilibrium stable? By the eigenvalues of the linearised system about it, and beyond them where they are zero.

Without gyroscopic terms a damper does not change the answer that K gives (Thomson & Tait 1879, Chetaev 1955); with
them it may destroy a stability that gyroscopic terms alone give, and so may a damper that feeds energy in.
"""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

from vibcli.base.errors import Inertless, PhysicsError

if TYPE_CHECKING:
    from vibcli.analyses.modal.damped_modes import DampedMode
    from vibcli.analyses.modal.modal_analysis import ModalAnalysis
    from vibcli.analyses.modal.undamped import Mode

STABLE, HELD, NEUTRAL, UNSTABLE, FALLING = "stable", "held", "neutral", "unstable", "falling"
OPEN = "open"
ROUNDING = 1e-13        # of the largest entry of K
WORDS = {STABLE: "stable", HELD: "stable, but only terms beyond the linear ones hold it",
         NEUTRAL: "neutral: it can move freely", UNSTABLE: "unstable",
         FALLING: "unstable: terms beyond the linear ones drive it away"}


class Stability(NamedTuple):
    """kind: one of the WORDS, or OPEN; growth_rate: the largest Re λ > 0 in 1/s, else None."""

    kind: str
    growth_rate: float = None

    @property
    def stable(self) -> bool:
        """Neutral counts as stable; None where it is left open."""
        return None if self.kind == OPEN else self.kind not in (UNSTABLE, FALLING)


def stability(modal: Any) -> Stability:
    """The Stability of an equilibrium, by its modes."""
    if inertless(modal.configuration.linear_system):
        return _of_springs(modal.configuration)
    modes = (modal.damped if _dampers_decide(modal.configuration.linear_system) else None) or modal.modes
    if not modes:
        return _of_first_order(modal.damped)
    if growing(modes):
        return Stability(UNSTABLE, float(max(growing(modal.damped or ()) or growing(modes))))
    kinds = modal.zero_modes.values()
    if "falling" in kinds:
        return Stability(FALLING)
    if "free" in kinds:
        return Stability(NEUTRAL)
    return Stability(HELD if kinds else STABLE)


def inertless(elements: Any) -> bool:
    """Do springs, weights and loads alone act on it?"""
    return len(elements.massless) == elements.n and not elements.dampers and not any(
        any(part.values()) for part in (elements.C, elements.drag, elements.G))


def _of_springs(configuration):
    """By the signs of K, which is that of a potential: what dampers and masses are added does not matter."""
    import numpy as np

    elements = configuration.linear_system
    if elements.circulatory:
        raise Inertless
    sizes = list(map(configuration.numeric.size_along, configuration.scene.coordinates))
    K = elements.stiffness_array() * np.outer(sizes, sizes)
    values = np.linalg.eigvalsh(K) / (np.abs(K).max() or 1.0)
    if values[0] < -ROUNDING:
        return Stability(UNSTABLE)
    if values[0] > ROUNDING:
        return Stability(STABLE)
    if not configuration.system.is_linear:
        raise PhysicsError("K is singular in the equilibrium, and nothing has inertia: terms beyond the linear ones "
                           "decide whether it is stable", "give a mass")
    return Stability(NEUTRAL)


def _of_first_order(damped):
    """Where nothing would oscillate without the dampers."""
    if growing(damped):
        return Stability(UNSTABLE, float(max(growing(damped))))
    return Stability(NEUTRAL if any(not mode.omega for mode in damped) else STABLE)


def judged(modal: "ModalAnalysis") -> Stability:
    """The Stability, OPEN where there are no small oscillations that would tell."""
    try:
        return stability(modal)
    except PhysicsError:
        return Stability(OPEN)


def growing(modes: "Sequence[DampedMode | Mode]") -> list[float]:
    """The growth rates of the modes that grow."""
    return [mode.growth_rate for mode in modes if mode.kind in ("flutter", "divergence")]


def _dampers_decide(elements):
    """May dampers feed energy in, or take away what gyroscopic or circulatory terms hold?"""
    loads = any(any(part.values()) for part in (elements.C, elements.drag, elements.G))
    return loads or elements.circulatory or any(c < 0 for c, _ in elements.dampers)
