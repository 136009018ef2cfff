"""Mistakes that give nothing in any variant, each with the reason in the first of them."""

from typing import TYPE_CHECKING

from vibcli.base.errors import PhysicsError, SpecError
from vibcli.homework.mistakes import MODEL
from vibcli.homework.printed import with_printed
from vibcli.homework.problem_mistakes import OF_FILE, own_values
from vibcli.results.variants import with_given

if TYPE_CHECKING:
    from vibcli.homework.mistakes.known import KnownMistake
    from vibcli.homework.variants import SolvedVariants

UNTOLD = "it has no such answer"


def unsolved(found: "SolvedVariants") -> list[tuple[str, str]]:
    """(mistake, why it gives nothing) of those of the file, and of the catalogue that change the scene, that in no
    accepted variant give anything for what they concern."""
    told = {name for one in found.summaries for name in one.nearest}
    told |= {name for name, _ in found.same}
    left = [one for one in found.mistakes if one.kind in (OF_FILE, MODEL) and one.name not in told
            and any(one.concerns(key.asked, key.unit) for key in found.keys)]
    return [(one.name, _reason(found, one)) for one in left] if found.accepted else []


def _reason(found: "SolvedVariants", mistake: "KnownMistake") -> str:
    """Why it gives nothing in the first variant."""
    values = found.accepted[0].values
    try:
        scene = with_given(mistake.problem or found.problem, {**values, **own_values(mistake, found.rules)})
        scene = with_printed(scene, found.rules)
        for key in found.keys:
            if mistake.concerns(key.asked, key.unit):
                instead = mistake.instead.get(key.text)
                key.found(scene) if instead is None else key.value(scene, instead)
    except SpecError as error:
        return error.diagnostics[0].message
    except PhysicsError as error:
        return error.message
    return UNTOLD
