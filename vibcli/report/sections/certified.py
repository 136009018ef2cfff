"""What certifies the results: what is left of the equations when they are put back into them, and all their digits."""

from typing import TYPE_CHECKING, Any

from vibcli.base.errors import NoBound, NoDigit, PhysicsError
from vibcli.report.blocks import TableBlock, figures_of_fewer_digits
from vibcli.report.keys import Key, data

if TYPE_CHECKING:
    from collections.abc import Sequence

    from vibcli.report.blocks import Section
    from vibcli.results.problem import Problem


def certified(problem: "Problem") -> dict[str, Any]:
    """{certificate: its keys} of what was found of a scene; nothing where that leaves nothing behind."""
    from vibcli.results.certificate import certificate

    found = certificate(problem)
    return data([CERTIFICATE], {CERTIFICATE.name: found}) if found else {}


def require_all_digits(sections: "Sequence[Section]") -> None:
    """PhysicsError of the first figure that has fewer digits than others, or none."""
    for section in sections:
        for text in figures_of_fewer_digits(section)[:1]:
            raise PhysicsError(f"under '{section.title}' stands {text}: no more digits are within the bound of its "
                               "error", "leave --strict out")
        rows = [row for block in section.blocks if isinstance(block, TableBlock) for row in block.rows]
        for word in (NoBound.CELL, NoDigit.CELL):
            if any(word in row for row in rows):
                raise PhysicsError(f"under '{section.title}' stands '{word}': no digit of what is asked there is known",
                                   "leave --strict out")


def require_rounding(problem: "Problem") -> None:
    """PhysicsError where more than rounding is left of the equations."""
    from vibcli.results.certificate import ENERGY, ROUNDING, certificate

    for what, left in certificate(problem).items():
        if what != ENERGY and not left <= ROUNDING:
            raise PhysicsError(f"the residual ratio of {what} is {left:.2g}: more than the {ROUNDING} that "
                               "rounding may leave", "leave --strict out")


def _of(what: str) -> Any:
    return lambda found: found.get(what)


CERTIFICATE = Key(
    "certificate", "what is left of the equations when the results are put back into them, of those stages alone that "
    "were needed; absent of letters, and where none was", of=(
        Key("force_balance", "forces in equilibrium over 2⁻⁵² and the size of their terms; up to 20 is rounding",
            _of("force balance")),
        Key("modes", "the largest residual of a mode over that of rounding, ‖λ²Mφ + λ(C + G)φ + Kφ‖ / ((|λ|²‖M‖ + "
            "|λ|‖C + G‖ + ‖K‖)‖φ‖ n 2⁻⁵²), of lumped bodies; up to 20 is rounding", _of("modes")),
        Key("orthogonality", "‖ΦᵀMΦ − I‖/(n 2⁻⁵²) of the natural modes", _of("orthogonality")),
        Key("damped_modes", "the residual of the damped modes", _of("damped modes")),
        Key("energy_balance", "of a motion in time: work of the loads − what is dissipated − the change of T + V, "
            "relative to the largest of these; small oscillations are looked at over two spans, one at each end",
            _of("energy balance"))))
