"""Is an equilibrium stable? By the eigenvalues of the linearised system about it, and beyond them where they are zero.

Without gyroscopic terms a damper does not change the answer that K gives (Thomson & Tait 1879, Chetaev 1955); with
them it may destroy a stability that gyroscopic terms alone give, and so may a damper that feeds energy in. What has no
inertia: stability_of_stiffness.py.
"""

from collections.abc import Sequence, ValuesView
from contextlib import suppress
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple

if TYPE_CHECKING:
    from vibcli.analyses.modal.damped_modes import DampedMode
    from vibcli.analyses.modal.modal_analysis import ModalAnalysis
    from vibcli.analyses.modal.stability_of_stiffness import Direction
    from vibcli.analyses.modal.undamped import Mode
    from vibcli.mechanics.factored_system import FactoredSystem

STABLE, HELD, NEUTRAL, UNSTABLE, FALLING = "stable", "held", "neutral", "unstable", "falling"
OPEN, UNDECIDED = "open", "undecided"
WORDS = {STABLE: "stable", HELD: "stable, but only terms beyond the linear ones hold it",
         NEUTRAL: "neutral: it can move freely", UNSTABLE: "unstable",
         FALLING: "unstable: terms beyond the linear ones drive it away",
         UNDECIDED: "stable or not as masses or dampers would have it: loads without a potential act on what has none"}


class Stability(NamedTuple):
    """kind: one of the WORDS, or OPEN; growth_rate: the largest Re λ > 0 in 1/s, else None."""

    kind: str
    growth_rate: float = None

    @property
    def stable(self) -> bool:
        """Neutral counts as stable; None where it is left open."""
        return None if self.kind in (OPEN, UNDECIDED) else self.kind not in (UNSTABLE, FALLING)


def stability(modal: Any) -> Stability:
    """The Stability of an equilibrium, by its modes; where coordinates have no inertia by the signs of K, or by its
    modes where what follows statically is held."""
    elements = modal.configuration.element_data
    decide = _dampers_decide(elements)
    if elements.massless:
        from vibcli.analyses.modal.stability_of_stiffness import FALLS, FOLLOWS, of_what_follows, takes_energy

        if takes_energy(elements):
            return _of_potential(modal)
        held = of_what_follows(elements)
        if held != FOLLOWS or inertless(elements):
            return Stability(UNSTABLE if held == FALLS else UNDECIDED)
    modes = ((modal.damped if decide else None) or modal.modes).shown()
    if growing(modes):
        return Stability(UNSTABLE, float(max(growing(modal.damped.shown() if modal.damped else ()) or growing(modes))))
    kinds = modal.zero_modes.values()
    if not modal.modes and any(not mode.omega for mode in modes):
        kinds = _beyond(modal, [mode for mode in modes if not mode.omega])
    return _by_zeros(kinds)


def _by_zeros(kinds: set[str] | tuple[Any, ...] | ValuesView[Any]) -> Stability:
    """By what its directions without stiffness are."""
    if "falling" in kinds:
        return Stability(FALLING)
    if "free" in kinds:
        return Stability(NEUTRAL)
    return Stability(HELD if kinds else STABLE)


def inertless(elements: Any) -> bool:
    """Do springs, weights and loads alone act on it?"""
    return len(elements.massless) == elements.n and not elements.dampers and not any(
        any(part.values()) for part in (elements.C, elements.drag, elements.G))


def _of_potential(modal: "ModalAnalysis") -> Stability:
    """By the signs of K and, where one is zero, by the potential beyond it."""
    from vibcli.analyses.modal.stability_of_stiffness import signs_of_stiffness

    signs = signs_of_stiffness(modal.configuration)
    if signs.negative:
        return Stability(UNSTABLE, _rate(modal))
    return _by_zeros(_beyond(modal, signs.null) if signs.null else ())


def _rate(modal: "ModalAnalysis") -> float | None:
    """The largest growth rate; None where what falls at once follows the rest, or has no equation of its own."""
    if inertless(modal.configuration.linear_system):
        return None
    with suppress(PhysicsError):
        return max(map(float, growing((modal.damped or modal.modes).shown())), default=None)
    return None


def _beyond(modal: "ModalAnalysis", null: "list[Direction]") -> set[str]:
    """What directions without stiffness are: free, held or falling."""
    from vibcli.mechanics.equilibrium.zero_modes import FREE, zero_modes

    if len(null) == modal.free:
        return {FREE}
    return set(zero_modes(modal.configuration, null).values())


def judged(modal: "ModalAnalysis") -> Stability:
    """The Stability, OPEN where there are no small oscillations that would tell."""
    try:
        return stability(modal)
    except PhysicsError:
        return Stability(OPEN)


def growing(modes: "Sequence[DampedMode | Mode]") -> list[float]:
    """The growth rates of the modes that grow."""
    return [mode.growth_rate for mode in modes if mode.kind in ("flutter", "divergence")]


def _dampers_decide(elements: "FactoredSystem") -> bool:
    """May dampers feed energy in, or take away what gyroscopic or circulatory terms hold?"""
    loads = any(any(part.values()) for part in (elements.C, elements.drag, elements.G))
    return loads or elements.circulatory or any(c < 0 for c, _ in elements.dampers)
