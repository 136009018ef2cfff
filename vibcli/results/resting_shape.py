"""The shape in which a piece of a member rests, as a function of its place, which the time stands for."""

from typing import TYPE_CHECKING

from vibcli.results.not_by_modes import NotByModes
from vibcli.results.response_of_members import CHECKED, SAME
from vibcli.symbolic.rationals import fraction_of

if TYPE_CHECKING:
    from vibcli.mechanics.configuration import Configuration
    from vibcli.mechanics.factored_system import PlacedPiece
    from vibcli.scene.scene import Scene
    from vibcli.symbolic.node import Node

SHARES = 0.0, 0.25, 0.5, 0.75, 1.0      # of a piece


def quartic_at_rest(configuration: "Configuration", piece: "PlacedPiece", scene: "Scene") -> "Node":
    """u of a piece in the equilibrium of a Configuration, of the fourth degree as an even load bends it; NotByModes
    where it is none."""
    import numpy as np

    from vibcli.mechanics.inputs_outputs.displacements import resting
    from vibcli.symbolic.evaluation import Floats, evaluate

    still, start, length = configuration.scene.resting, float(piece.start), float(piece.piece.length)
    signal = still.members[piece.owner].signal_stem
    nodes = [resting(still, f"{signal}({start + share * length!r} m)") for share in (*SHARES, CHECKED)]
    *values, other = evaluate(nodes, Floats, configuration.at_rest)
    powers = np.linalg.solve(np.vander(SHARES, increasing=True), values)
    if abs(np.polynomial.polynomial.polyval(CHECKED, powers) - other) > SAME * max(map(abs, values)):
        raise NotByModes(f"'{piece.owner}' rests in a shape that is no polynomial of the fourth degree",
                         "take its tension or what varies along it out")
    table = scene.table
    xi = scene.time / table.number(fraction_of(length))
    return sum((table.number(fraction_of(float(c))) * xi**k for k, c in enumerate(powers) if c), table.zero)
