"""What a family is: scenes that one knob makes harder, and what is asked of them."""

from collections.abc import Callable, Mapping, Sequence
from typing import Any

from vibcli.base.named_tuple import NamedTuple


class StressFamily(NamedTuple):
    """knob: what is turned, in words; values: of it, as a scene writes them; scene(value): the mapping that such a file
    would hold, whose one answer is what is asked (omega[1] stands for all modes, eigenvalue[1] for all damped ones);
    plain: what it stands beside, (file of the methods, name of the method, setting) or a function of the value that
    gives numbers; truth(value), where a closed form gives it: (numbers of mpmath at the working precision, the largest
    value of the motion, None of modes)."""

    knob: str
    values: Sequence[str]
    scene: Callable[[str], Mapping[str, Any]]
    plain: tuple[str, str, str] | Callable[[str], list[Any]]
    truth: Callable[[str], tuple[list[Any], Any]] | None = None


def powers(first: int, last: int, step: int = 1) -> tuple[str, ...]:
    """1e<first> … 1e<last>."""
    return tuple(f"1e{k}" for k in range(first, last + (1 if step > 0 else -1), step))


def chain(masses: Sequence[str], stiffnesses: Sequence[str], dampers: Sequence[str] = ()) -> dict[str, Any]:
    """Masses in a row on springs, the first on the ground, one spring more than masses where the last is held, too."""
    ends = ["ground", *(f"m{i}" for i in range(1, len(masses) + 1)), "ground"]
    found: dict[str, dict[Any, Any]] = {
        "bodies": {f"m{i}": {"mass": mass, "slide": f"x{i}"} for i, mass in enumerate(masses, 1)},
        "springs": {f"s{i}": {"k": k, "between": ends[i - 1:i + 1]} for i, k in enumerate(stiffnesses, 1)}}
    if dampers:
        found["dampers"] = {f"d{i}": {"c": c, "between": ends[i - 1:i + 1]} for i, c in enumerate(dampers, 1)}
    return found
