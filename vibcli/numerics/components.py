"""Connected components of a relation between places."""

import numpy as np


def components(related: np.ndarray) -> list[list[int]]:
    """Those of a symmetric boolean array, as ascending lists of places."""
    left, found = set(range(len(related))), []
    while left:
        part, fresh = set(), {min(left)}
        while fresh:
            i = fresh.pop()
            part.add(i)
            fresh.update(left.intersection(np.flatnonzero(related[i]).tolist()) - part)
        left -= part
        found.append(sorted(part))
    return found


def clusters(related: np.ndarray) -> list[list[int]]:
    """Those of more than one place."""
    return [part for part in components(related) if len(part) > 1]
