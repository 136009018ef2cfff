"""What mistakes give in a variant that is read anew, against what its key says of them."""

from typing import TYPE_CHECKING

from vibcli.base.errors import PhysicsError, SpecError
from vibcli.homework.mistakes import MISTAKES, MODEL
from vibcli.homework.problem_mistakes import mistakes_of
from vibcli.inverse import settled

if TYPE_CHECKING:
    from collections.abc import Sequence

    from vibcli.homework.document import SceneDocument
    from vibcli.homework.keys import AnswerKey
    from vibcli.homework.mistakes.known import KnownMistake
    from vibcli.homework.variants import ProblemVariant
    from vibcli.reader.variants import VariantRules
    from vibcli.results.problem import Problem


def require_same_mistakes(document: "SceneDocument", fresh: "Problem", keys: "Sequence[AnswerKey]",
                          variant: "ProblemVariant", at: str, turn: int | None = None) -> None:
    """RuntimeError, a fault of ours, where a mistake does not give what a variant says of it, its scene being read
    anew; fresh: that of the variant; at: its values in words; turn: which one of those that change the scene is solved,
    all unless it is given."""
    again, names = document.with_values(variant.values), _in_turn(document.rules, variant, turn)
    mistakes = {one.name: one for one in mistakes_of(fresh, document.rules, again, keys, names)}
    for key, one in zip(keys, variant.keys, strict=True):
        right = key.found(fresh) if one.wrong else None
        for wrong in (wrong for wrong in one.wrong if wrong.mistake in names):
            known = mistakes.get(wrong.mistake)
            scene = None if known is None else _scene(known, fresh)
            value = None if known is None or scene is None else key.mistaken(known, scene, right)
            if value is None or not key.is_mistaken_so(fresh, one, wrong.value, value):
                raise RuntimeError(f"two ways to what '{wrong.mistake}' makes of {key.text} differ, "
                                   f"{wrong.value!r} and {value!r}, at {at}")


def _in_turn(rules: "VariantRules", variant: "ProblemVariant", turn: int | None) -> set[str]:
    """The mistakes of a variant, without those that change the scene but the one whose turn it is."""
    told = list(dict.fromkeys(wrong.mistake for one in variant.keys for wrong in one.wrong))
    solved = [name for name in told if name in rules.mistakes or MISTAKES[
        name.partition(" (")[0].replace(" ", "_")][0] == MODEL]
    if turn is None or not solved:
        return set(told)
    return set(told) - set(solved) | {solved[turn % len(solved)]}


def _scene(mistake: "KnownMistake", fresh: "Problem") -> "Problem | None":
    """The scene that a mistake takes for the right one, with what that chooses; None where it cannot."""
    try:
        return fresh if mistake.problem is None else settled(mistake.problem)
    except (SpecError, PhysicsError):
        return None
