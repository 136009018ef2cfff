"""Normalisation of mode shapes, stated with every shape that is shown.

first: the first coordinate is 1 (the next that moves where it rests); largest: the largest amplitude is 1;
mass: φᵀMφ = 1, as the shapes come from the eigenvalue problem.
"""

NEGLIGIBLE = 1e-9
WORDS = {"first": "the first coordinate that moves is 1", "largest": "the largest amplitude is 1", "mass": "φᵀMφ = 1"}


def normalised(shape, how="first"):
    """A mode shape in the normalisation asked for, as a list of numbers."""
    values = list(shape)
    size = max(map(abs, values), default=0)
    if not size or how == "mass":
        return values
    if how == "largest":
        pivot = max(values, key=abs)
    else:
        pivot = next(value for value in values if abs(value) > NEGLIGIBLE * size)
    return [value / pivot for value in values]
