"""A Configuration whose equilibrium, and what is evaluated there, has as many digits as one likes."""

from functools import cached_property
from typing import TYPE_CHECKING

import mpmath

from vibcli.mechanics.configuration import Configuration
from vibcli.mechanics.high_precision import equilibrium_to, in_its_place
from vibcli.symbolic.evaluation import evaluate, multiprecision

if TYPE_CHECKING:
    from vibcli.mechanics.equilibrium.equilibrium import Equilibrium

ZERO = 1000     # units of the last place: a dependent coordinate below them is where it is drawn


class PreciseConfiguration(Configuration):
    """The same at the working precision of mpmath, at which it is made and must be used."""

    def __init__(self, near: Configuration) -> None:
        self.arithmetic = multiprecision()
        self.near, self.values = near, near.numeric.values(self.arithmetic)
        super().__init__(near.numeric, self._equilibrium_near(near.equilibrium))

    def _equilibrium_near(self, near: "Equilibrium") -> "Equilibrium":
        if near.drawn:
            return near._replace(values=in_its_place(self.near.scene.resting.drawn, self.values, self.arithmetic))
        return near._replace(values=equilibrium_to(self.near.numeric, near, self.values, self.arithmetic))

    @property
    def coupled(self) -> bool:
        """As near by."""
        return self.near.coupled

    @property
    def at_rest(self) -> "dict[str, mpmath.mpf]":
        """{symbol: number} of everything in equilibrium, at t = 0."""
        zero = mpmath.mpf(0)
        return {**self.values, self.scene.time.name: zero, **self.equilibrium.values,
                **{v.name: zero for v in self.scene.v}}

    @property
    def dependent_values(self) -> "dict[str, mpmath.mpf]":
        """{name: number} of the dependent coordinates in equilibrium."""
        nodes, small = self.scene.resting.dependent, ZERO * mpmath.eps
        values = dict(zip(nodes, evaluate(list(nodes.values()), self.arithmetic, self.at_rest), strict=True))
        return {name: value if abs(value) > small * self.scene.unit_of(name) else mpmath.mpf(0)
                for name, value in values.items()}

    @cached_property
    def preloaded(self) -> "PreciseConfiguration | None":
        """The same under the force that lets go at t = 0; None where none does."""
        return None if self.near.preloaded is None else PreciseConfiguration(self.near.preloaded)

    @cached_property
    def matrices(self) -> list[dict[tuple[int, int], mpmath.mpf]]:
        """M, C, G, K as {(i, j): number}."""
        return self.near.precise_system(mpmath.mp.dps).matrices()
