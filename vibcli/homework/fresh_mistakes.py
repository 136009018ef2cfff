"""What mistakes give in a variant that is read anew, against what its key says of them."""

from typing import TYPE_CHECKING

from vibcli.base.errors import PhysicsError, SpecError
from vibcli.homework.mistakes import mistakes_of
from vibcli.inverse import settled

if TYPE_CHECKING:
    from collections.abc import Sequence

    from vibcli.homework.document import SceneDocument
    from vibcli.homework.keys import AnswerKey
    from vibcli.homework.variants import ProblemVariant
    from vibcli.mistakes.known import KnownMistake
    from vibcli.results.problem import Problem


def require_same_mistakes(document: "SceneDocument", fresh: "Problem", keys: "Sequence[AnswerKey]",
                          variant: "ProblemVariant", at: str) -> None:
    """RuntimeError, a fault of ours, where a mistake does not give what a variant says of it, its scene being read
    anew; fresh: that of the variant; at: its values in words."""
    again = document.with_values(variant.values)
    told = {wrong.mistake for one in variant.keys for wrong in one.wrong}
    mistakes = {one.name: one for one in mistakes_of(fresh, document.rules, again, keys, told)}
    for key, one in zip(keys, variant.keys, strict=True):
        right = key.found(fresh) if one.wrong else None
        for wrong in one.wrong:
            known = mistakes.get(wrong.mistake)
            scene = None if known is None else _scene(known, fresh)
            value = None if known is None or scene is None else key.mistaken(known, scene, right)
            if value is None or not key.is_mistaken_so(fresh, one, wrong.value, value):
                raise RuntimeError(f"two ways to what '{wrong.mistake}' makes of {key.text} differ, "
                                   f"{wrong.value!r} and {value!r}, at {at}")


def _scene(mistake: "KnownMistake", fresh: "Problem") -> "Problem | None":
    """The scene that a mistake takes for the right one, with what that chooses; None where it cannot."""
    try:
        return fresh if mistake.problem is None else settled(mistake.problem)
    except (SpecError, PhysicsError):
        return None
