"""A uniform piece of a bar, shaft, string or beam: the coefficients of its differential equation."""

from typing import Any

from vibcli.base.named_tuple import NamedTuple


class Piece(NamedTuple):
    """B u⁗ − ((N + n x) u′)′ + (μ s² + c s + k) u = 0 on 0 ≤ x ≤ length, u ~ e^{st}.

    bending: B = EI, 0 of bars, shafts and strings; tension: N at x = 0 (EA of a bar, GI_o of a shaft); gradient: n;
    inertia: μ; drag: c; foundation: k, each per length. The end values are (u₀, u_l), of beams (u₀, θ₀, u_l, θ_l) with
    θ = u′. Numbers of any kind, arrays of many pieces of one order too.
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
        bending = self.bending
        return 4 if (bending.any() if hasattr(bending, "any") else bending) else 2

    def reaction(self, s: Any) -> Any:
        """κ = μ s² + c s + k: what a motion u e^{st} is answered by across, per length and u."""
        return (self.inertia * s + self.drag) * s + self.foundation

    def undamped_reaction(self, omega: Any) -> Any:
        """κ = k − μ ω²: that of a vibration at ω, drag left out; a real number."""
        return self.foundation - self.inertia * omega * omega
