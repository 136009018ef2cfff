"""The pieces of a member as they move in a mode, in floats."""

import numpy as np

from vibcli.analyses.continuous.shapes import Moved


def moved_pieces(mode, member):
    """The pieces of a member from left to right, as they move in a mode; in floats."""
    motion, found = mode.motion, []
    for placed in motion.system.ordered:
        if placed.owner == member:
            piece = placed.piece._make(float(x) for x in placed.piece)
            ends = np.array([_number(sum(x * motion.shape[i] for i, x in row.items())) for row in placed.rows])
            supported = not any(placed.rows[0].values())
            found.append(Moved(float(placed.start), piece, piece.foundation - piece.inertia * float(motion.z), ends,
                               supported, motion.curves))
    return sorted(found, key=lambda moved: moved.start)


def _number(x):
    """A float, or a complex number where there is a gyroscopic term."""
    return complex(x) if getattr(x, "imag", 0) else float(x.real if hasattr(x, "real") else x)
