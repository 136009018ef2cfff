"""Several degrees of freedom in letters: block after block, the modes of each from its characteristic polynomial."""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from vibcli.analyses.closed_form.amplitude_ratios import with_ratio
from vibcli.analyses.closed_form.block_modes import block_modes
from vibcli.analyses.closed_form.characteristic import LARGEST
from vibcli.analyses.closed_form.closed_forms import ClosedForms
from vibcli.analyses.closed_form.damping import damps_each
from vibcli.analyses.closed_form.decoupling import blocks, congruent
from vibcli.analyses.closed_form.numeric_verification import (
    confirmed,
    damping_confirmed,
    roots_in_numbers,
    samples,
    shape_confirmed,
)
from vibcli.symbolic.evaluation import Floats, evaluate
from vibcli.symbolic.time_limit import within

if TYPE_CHECKING:
    from vibcli.analyses.closed_form.closed_forms import ClosedMode
    from vibcli.analyses.modal.modal_analysis import ModalAnalysis
    from vibcli.mechanics.symbolic_system import SymbolicSystem
    from vibcli.symbolic.node import Node

MOST, CALLS = 12, 16_000_000      # coordinates; for all blocks together


def several(symbolic: "SymbolicSystem", modal: "ModalAnalysis", M: "Mapping[tuple[int, int], Node]",
            C: "Mapping[tuple[int, int], Node]", G: "Mapping[tuple[int, int], Node]",
            K: "Mapping[tuple[int, int], Node]") -> ClosedForms | None:
    """The ClosedForms of a scene with several coordinates; None where they are too long or do not hold."""
    table, n = symbolic.scene.table, len(symbolic.scene.q)
    candidates = samples(symbolic, modal) if n <= MOST else []
    parts = blocks(table, n, (M, G, K)) if candidates else []
    if not parts or max(map(len, parts)) > LARGEST:
        return None
    values = [candidate.numeric.floats for candidate in candidates]
    damping = C if C and not G and damps_each(parts, C) else {}

    def solved() -> "list[tuple[list[ClosedMode], list[list[Node]]]]":
        return [block_modes(table, n, part, congruent(table, damping, part.columns), values) for part in parts]

    found = within(CALLS, solved, [])
    modes, left = [mode for part, _ in found for mode in part], [rest for _, part in found for rest in part]
    if not found or not confirmed(modes, left, candidates):
        return None
    modes = _numbered(modes, left, values[0])
    if n == 2:
        modes = [with_ratio(table, mode, M, G, K) for mode in modes]
    return ClosedForms(_confirmed(modes, candidates), left)


def _numbered(modes: "Sequence[ClosedMode]", left: "Sequence[list[Node]]",
              values: dict[str, float]) -> "list[ClosedMode]":
    """The modes sorted, each with its number among all at the sample values."""
    squares = evaluate([mode.square for mode in modes], Floats, values)
    others = [x for polynomial in left for x in roots_in_numbers(polynomial, values)]
    ascending = sorted(zip(squares, modes, strict=True), key=lambda pair: pair[0])
    return [mode._replace(index=1 + i + sum(other < square for other in others))
            for i, (square, mode) in enumerate(ascending)]


def _confirmed(modes: "Sequence[ClosedMode]", candidates: "list[ModalAnalysis]") -> "list[ClosedMode]":
    """The modes without shapes and damping ratios that do not hold in numbers."""
    found = []
    for mode in modes:
        wrong = [kind for kind in ("shape", "pattern") if getattr(mode, kind) is not None
                 and not shape_confirmed(mode, getattr(mode, kind), candidates)]
        found.append(mode._replace(**dict.fromkeys(wrong)))
    damped = [mode for mode in found if mode.zeta is not None]
    if damped and not damping_confirmed(damped, candidates):
        found = [mode._replace(zeta=None, omega_d=None, zeta_pattern=None) for mode in found]
    return found
