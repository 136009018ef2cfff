"""Is an equilibrium stable? By the eigenvalues of the linearised system about it, and beyond them where they are zero.

Without gyroscopic terms a damper does not change the answer that K gives (Thomson & Tait 1879, Chetaev 1955); with
them it may destroy a stability that gyroscopic terms alone give, and so may a damper that feeds energy in.
"""

from vibcli.errors import PhysicsError

STABLE, HELD, NEUTRAL, UNSTABLE, FALLING = "stable", "held", "neutral", "unstable", "falling"
OPEN = "open"
WORDS = {STABLE: "stable", HELD: "stable, but only terms beyond the linear ones hold it",
         NEUTRAL: "neutral: it can move freely", UNSTABLE: "unstable",
         FALLING: "unstable: terms beyond the linear ones drive it away"}


class Stability:
    """kind: one of the WORDS, or OPEN; growth_rate: the largest Re λ > 0 in 1/s, else None."""

    __slots__ = ("growth_rate", "kind")

    def __init__(self, kind, growth_rate=None):
        self.kind, self.growth_rate = kind, growth_rate

    @property
    def stable(self):
        """Neutral counts as stable; None where it is left open."""
        return None if self.kind == OPEN else self.kind not in (UNSTABLE, FALLING)


def stability(problem):
    """The Stability of the equilibrium of a numeric problem."""
    modes = (problem.damped if _dampers_decide(problem.elements) else None) or problem.modes
    if not modes:
        return _of_first_order(problem.damped)
    if growing(modes):
        return Stability(UNSTABLE, float(max(growing(problem.damped or ()) or growing(modes))))
    kinds = problem.zero_modes.values()
    if "falling" in kinds:
        return Stability(FALLING)
    if "free" in kinds:
        return Stability(NEUTRAL)
    return Stability(HELD if kinds else STABLE)


def _of_first_order(damped):
    """Where nothing would oscillate without the dampers."""
    if growing(damped):
        return Stability(UNSTABLE, float(max(growing(damped))))
    return Stability(NEUTRAL if any(not mode.omega for mode in damped) else STABLE)


def judged(problem):
    """The Stability, OPEN where there are no small oscillations that would tell."""
    try:
        return stability(problem)
    except PhysicsError:
        return Stability(OPEN)


def growing(modes):
    """The growth rates of the modes that grow."""
    return [mode.growth_rate for mode in modes if mode.kind in ("flutter", "divergence")]


def _dampers_decide(elements):
    """May dampers feed energy in, or take away what gyroscopic or circulatory terms hold?"""
    loads = any(any(part.values()) for part in (elements.C, elements.drag, elements.G))
    return loads or elements.circulatory or any(c < 0 for c, _ in elements.dampers)
