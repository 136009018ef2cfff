"""A uniform piece of a bar, shaft, string or beam: the coefficients of its differential equation."""

from typing import Any, NamedTuple


class Piece(NamedTuple):
    """B u⁗ − ((N + n x) u′)′ + (μ s² + c s + k) u = 0 on 0 ≤ x ≤ length, u ~ e^{st}.

    bending: B = EI, 0 of bars, shafts and strings; tension: N at x = 0 (EA of a bar, GI_o of a shaft); gradient: n;
    inertia: μ; drag: c; foundation: k, each per length. The end values are (u₀, u_l), of beams (u₀, θ₀, u_l, θ_l) with
    θ = u′. Numbers of any kind.
    """

    length: Any
    bending: Any
    tension: Any
    gradient: Any
    inertia: Any
    drag: Any
    foundation: Any

    @property
    def order(self) -> int:
        """Of the differential equation in x: 2, of beams 4."""
        return 4 if self.bending else 2
