"""How the frequency of one degree of freedom begins to hang on the amplitude, by the method of Lindstedt and Poincaré.

With V = V₂ξ² + V₃ξ³ + V₄ξ⁴ and T = (T₀ + T₁ξ + T₂ξ²) ξ̇² about the equilibrium, and A half the range of ξ,

    ω ≈ ω₀ (1 + κA²)    ω₀² = V₂/T₀    κ = 3V₄/4V₂ − 15V₃²/16V₂² − T₂/4T₀ + 3T₁V₃/8T₀V₂ + T₁²/16T₀²

as ξ = u − (μ₁/4) u² + (μ₁² − μ₂) u³/6 + … with μᵢ = Tᵢ/T₀ makes the inertia constant, after which Nayfeh and Mook
(1979, 2.3) have ω for quadratic and cubic terms of the force.
"""

from collections.abc import Mapping
from fractions import Fraction
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import PhysicsError
from vibcli.base.named_tuple import NamedTuple
from vibcli.mechanics.expansion import in_letters, in_numbers, up_to
from vibcli.symbolic.evaluation import evaluate
from vibcli.symbolic.normal_form import is_zero, textbook
from vibcli.symbolic.running_errors import RunningErrors, error_in, number_in

if TYPE_CHECKING:
    from vibcli.mechanics.configuration import Configuration
    from vibcli.mechanics.symbolic_system import SymbolicSystem
    from vibcli.symbolic.node import Node
    from vibcli.symbolic.running_errors import Rounded

ORDER = 4
V_POWERS, T_POWERS = ((2,), (3,), (4,)), ((0, 2), (1, 2), (2, 2))


class EnergyFactors(NamedTuple):
    """V₂, V₃, V₄ and T₀, T₁, T₂."""

    V: tuple[Any, ...]
    T: tuple[Any, ...]

    @property
    def kappa(self) -> "Node":
        """κ, of expressions."""
        (V2, V3, V4), (T0, T1, T2) = self
        bent, uneven = V3 / V2, T1 / T0
        found: Node = (3 * V4 / (4 * V2) - 15 * bent * bent / 16 - T2 / (4 * T0)
                       + 3 * uneven * bent / 8 + uneven * uneven / 16)
        return found


def factors_in_letters(symbolic: "SymbolicSystem") -> EnergyFactors:
    """Of a scene whose equilibrium is known in letters; else PhysicsError."""
    scene = symbolic.scene.resting
    (q,), (v,) = scene.q, scene.v
    V = in_letters(symbolic, "V with loads", [q], up_to(ORDER), ORDER)
    T = in_letters(symbolic, "T", [q, v], up_to(ORDER), ORDER)
    found = _factors(V, T, scene.table.zero)
    if is_zero(found.V[0]) or scene.table.is_positive(textbook(-found.V[0])):
        raise _no_stiffness()
    return found


def omega_in_letters(symbolic: "SymbolicSystem") -> "Node":
    """ω₀ of a scene whose equilibrium is known in letters."""
    found = factors_in_letters(symbolic)
    return textbook((found.V[0] / found.T[0]) ** Fraction(1, 2))


def kappa_in_letters(symbolic: "SymbolicSystem") -> "Node":
    """κ of a scene whose equilibrium is known in letters."""
    return textbook(factors_in_letters(symbolic).kappa)


def kappa_in_numbers(configuration: "Configuration", digits: int | None, unit: float) -> Any:
    """That of numbers, with the bound of its error."""
    scene = configuration.scene.resting
    (q,), (v,), table = scene.q, scene.v, scene.table
    V = in_numbers(configuration, "V with loads", [q], up_to(ORDER), ORDER, digits, unit)
    T = in_numbers(configuration, "T", [q, v], up_to(ORDER), ORDER, digits, unit)
    known = _factors(V, T, 0.0)
    if not number_in(known.V[0]) > error_in(known.V[0]):
        raise _no_stiffness()
    symbols = EnergyFactors(*(tuple(table.variable(f"factor {i} of {letter}") for i in range(3)) for letter in "VT"))
    values = {x.name: value for names, row in zip(symbols, known, strict=True)
              for x, value in zip(names, row, strict=True)}
    arithmetic = configuration.bounded_rest[0]
    if digits is not None:
        arithmetic = RunningErrors(configuration.precise_rest(digits)[0], unit)
    return evaluate([symbols.kappa], arithmetic, values)[0]


def _factors(V: "Mapping[tuple[int, ...], Node | Rounded]", T: "Mapping[tuple[int, ...], Node | Rounded]",
             zero: Any) -> EnergyFactors:
    return EnergyFactors(tuple(V.get(powers, zero) for powers in V_POWERS),
                         tuple(T.get(powers, zero) for powers in T_POWERS))


def _no_stiffness() -> PhysicsError:
    return PhysicsError("there are no small vibrations about this equilibrium: its linear stiffness is not positive",
                        "ask for backbone[1](x)(A) at an amplitude A")
