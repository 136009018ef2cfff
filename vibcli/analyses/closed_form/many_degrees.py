"""Several degrees of freedom in letters: block after block, the modes of each from its characteristic polynomial."""

from vibcli.analyses.closed_form.amplitude_ratios import two_coordinates
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

MOST, CALLS = 12, 16_000_000      # coordinates; for all blocks together


def several(symbolic, modal, M, C, G, K):
    """The ClosedForms of a scene with several coordinates; None where they are too long or do not hold."""
    table, n = symbolic.scene.table, len(symbolic.scene.q)
    candidates = samples(symbolic, modal) if n <= MOST else []
    parts = blocks(table, n, (M, G, K)) if candidates else []
    if not parts or max(map(len, parts)) > LARGEST:
        return None
    values = [candidate.numeric.floats for candidate in candidates]
    damping = C if C and not G and damps_each(parts, C) else {}

    def solved():
        return [block_modes(table, n, part, congruent(table, damping, part.columns), values) for part in parts]

    found = within(CALLS, solved, [])
    modes, left = [mode for part, _ in found for mode in part], [rest for _, part in found for rest in part]
    if not found or not confirmed(modes, left, candidates):
        return None
    _number(modes, left, values[0])
    if n == 2:
        two_coordinates(table, modes, M, G, K)
    _keep_confirmed(modes, candidates)
    return ClosedForms(modes, left)


def _number(modes, left, values):
    """Sort the modes, and give each its number among all at the sample values."""
    squares = evaluate([mode.square for mode in modes], Floats, values)
    modes[:] = [mode for _, mode in sorted(zip(squares, modes, strict=True), key=lambda pair: pair[0])]
    others = [x for polynomial in left for x in roots_in_numbers(polynomial, values)]
    for i, square in enumerate(sorted(squares)):
        modes[i].index = 1 + i + sum(other < square for other in others)


def _keep_confirmed(modes, candidates):
    """Leave out shapes and damping ratios that do not hold in numbers."""
    for mode in modes:
        if mode.shape is not None and not shape_confirmed(mode, mode.shape, candidates):
            mode.shape = None
        if mode.pattern is not None and not shape_confirmed(mode, mode.pattern, candidates):
            mode.pattern = None
    damped = [mode for mode in modes if mode.zeta is not None]
    if damped and not damping_confirmed(damped, candidates):
        for mode in damped:
            mode.zeta = mode.omega_d = mode.zeta_pattern = None
