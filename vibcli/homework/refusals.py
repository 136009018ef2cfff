"""What is wrong with the variants of a scene as their solution shows, each at its place in the file: that none is left,
and mistakes of the file that give nothing."""

from typing import TYPE_CHECKING

from vibcli.base.diagnostics import quoted
from vibcli.base.errors import Diagnostic, PhysicsError, SpecError
from vibcli.homework.told import untold
from vibcli.language.document.nodes import Mapping, Sequence

if TYPE_CHECKING:
    from vibcli.base.errors import Where
    from vibcli.homework.document import SceneDocument
    from vibcli.homework.variants import SolvedVariants


def require_variants(found: "SolvedVariants", document: "SceneDocument") -> None:
    """PhysicsError where no variant is left: which gate took how many, and which values come nearer; at the parameter
    that no sheet would tell, else at what is said of variants. SpecError where mistakes of the file give nothing in any
    variant."""
    if not found.accepted:
        names = untold(found.problem, found.keys) if found.counts["told"] == len(found.rejected) else []
        where = next((place for name in names if (place := _given_at(document.root, name))), found.rules.where)
        hint = f"; write {' and '.join(f'{{{name}}}' for name in names)} in the question" if names else ""
        raise PhysicsError("no variant is left", found.advice + hint, where)
    wrong = [Diagnostic(found.rules.mistakes[name].where, f"the mistake {quoted(name)} gives nothing in any variant: "
                        f"{reason}", "a mistake is a scene that can be solved: mend it, or leave it out")
             for name, reason in found.unsolved if name in found.rules.mistakes]
    if wrong:
        raise SpecError(wrong)


def _given_at(root: Mapping, name: str) -> "Where | None":
    """Where a parameter is given its values: under `variants`, else its one value; None where it is not seen."""
    for path in (("variants", "parameters"), ("variants", "rows"), ("parameters",)):
        node: object = root
        for key in path:
            node = node.entries[key][1] if isinstance(node, Mapping) and key in node.entries else None
        if isinstance(node, Sequence):
            node = node.items[0]
        if isinstance(node, Mapping) and name in node.entries:
            return node.entries[name][0].where
    return None
