"""What damps modes that nothing couples: c of η̈ + c η̇ + ω² η = … for each."""

from typing import TYPE_CHECKING

import numpy as np

from vibcli.results.enough_modes import first_modes
from vibcli.results.not_by_modes import CoupledModes

if TYPE_CHECKING:
    from collections.abc import Sequence

    from vibcli.mechanics.factored_system import PlacedPiece
    from vibcli.results.modal_response import ModalResponse


def damping_of_modes(response: "ModalResponse", pieces: "Sequence[PlacedPiece]", count: int) -> np.ndarray:
    """c [1/s] of the first modes: given, or of drag c/μ that is the same everywhere, which damps each by itself."""
    given = response.problem.modal.member_damping
    if given is not None:
        return np.array([float(given.rate(mode)) for mode in first_modes(response.natural, count)])
    rates = {placed.piece.drag / placed.piece.inertia for placed in pieces}
    most = max(rates)
    if any(placed.retardation for placed in response.linear.pieces):
        raise CoupledModes("damping in proportion to stiffness stands beside drag", "ask for steady(…)")
    if not most:
        return np.zeros(count)
    if most - min(rates) > 1e-14 * most or response.matrices[0].any():
        raise CoupledModes("drag that differs from place to place couples the modes of members",
                           "ask for steady(…), or give all the same drag by mass")
    return np.full(count, most)
