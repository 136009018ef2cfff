"""The accuracy that is asked of a motion that is integrated: the error of each coordinate relative to how far it goes,
or to its largest value where that is less."""

SMALLEST, LARGEST = 1e-13, 1e-3
WANTS = f"an accuracy from {SMALLEST:g} to {LARGEST:g}, as in 1e-6"
TOO_FINE = "floats have no more digits: --digits follows a motion to as many as are asked"


def accuracy(text: str) -> float:
    """The accuracy that a text asks for; ValueError, with what is wrong, where it is none."""
    written = text.strip()
    try:
        number = float(written) if set(written) <= set("0123456789.eE+-") else None
    except ValueError:
        number = None
    if number is None:
        raise ValueError(f"expected {WANTS}")
    if not SMALLEST <= number <= LARGEST:
        raise ValueError(f"expected {WANTS}" + (f"; {TOO_FINE}" if 0 < number < SMALLEST else ""))
    return number
