"""Tensions that balance each other without any load: what members that keep their length, links and ropes share in any
proportion.

The conditions Gₖ = 0 hold with forces λₖ along them. What Σ λₖ ∂Gₖ/∂q = 0 allows beside λ = 0 is self-stress
(Pellegrino & Calladine 1986): statics leaves it open, and only a `preload` tells it, or a stiffness of what stretches.
"""

from collections.abc import Sequence
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import numpy as np

    from vibcli.elements.member import Member
    from vibcli.scene.scene import Scene

OPEN = 1e-9         # of a unit vector of self-stress: less is rounding


def pinned(scene: "Scene", members: "Sequence[Member]", slopes: "Sequence[Sequence[float]]",
           forces: "Sequence[float]") -> list[int]:
    """The numbers of those members whose preload settles what would be open. slopes: ∂Gₖ/∂q, a row to each coordinate,
    a column to each member first and then to each constraint; forces: along each coordinate. SpecError where the
    tension of one that carries something is open still."""
    import numpy as np

    matrix, found, carried = np.array(slopes, dtype=float).reshape(len(slopes), -1), [], list(forces)
    for k, member in enumerate(members):
        if "preload" in member.record and _open(matrix)[k]:
            found.append(k)
            matrix = np.vstack([matrix, np.eye(matrix.shape[1])[k]])
            carried.append(scene.number(scene.lower(member.record["preload"])))
    least = np.linalg.lstsq(matrix, np.array(carried), rcond=OPEN)[0]
    loaded = np.abs(least) > OPEN * max(map(abs, carried))
    left = [member for member, *both in zip(members, _open(matrix), loaded, strict=False) if all(both)]
    if left:
        _report(scene, left)
    return found


def _open(matrix: "np.ndarray") -> "np.ndarray":
    """Which columns take part in a self-stress."""
    import numpy as np

    sizes = np.abs(matrix).max(axis=0, initial=0.0)
    _, s, v = np.linalg.svd(matrix / np.where(sizes, sizes, 1.0))
    rank = int((s > OPEN * s.max(initial=0.0)).sum())
    found: np.ndarray = np.sqrt((v[rank:] ** 2).sum(axis=0)) > OPEN
    return found


def _report(scene: "Scene", left: "Sequence[Member]") -> None:
    first, names = left[0], " and ".join(f"'{member.name}'" for member in left[:3])
    what = "string" if first.kind.name == "string" else "beam"
    shares = names if len(left) > 1 else f"{names} and what stands beside it"
    help_ = "give `preload: T` of it" if what == "string" else "give `preload: T` of it, or `EA` of all"
    scene.report(first.record.where, f"how {shares} share what they carry is not told by statics: they keep their "
                 "length", help_)
