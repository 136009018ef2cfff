"""The document of a scene, from which it is read anew with other values, or with a part changed."""

from collections.abc import Mapping as Given
from typing import TYPE_CHECKING, Any, NamedTuple

from vibcli.base.work import Work
from vibcli.inverse import settled
from vibcli.reader.read import document_of_case, read_changed, read_spec
from vibcli.results.problem import Problem

if TYPE_CHECKING:
    from vibcli.language.document.nodes import Mapping
    from vibcli.language.given_values import GivenValue
    from vibcli.language.spec import Spec


class SceneDocument(NamedTuple):
    """The top of a document, that of a case of it included; settings: {parameter: (syntax tree, text)} that replace
    values of the file."""

    root: "Mapping"
    file: str
    settings: "dict[str, tuple[Any, Any]]"

    @classmethod
    def of(cls, root: "Mapping", file: str, case: str | None, settings: Any = None) -> "SceneDocument":
        """The document of a scene, or of a case of it."""
        return cls(document_of_case(root, case), file, settings or {})

    def problem(self, patience: int = 1) -> "Problem":
        """The Problem that is read anew as it stands."""
        return Problem(read_spec(self.root, self.file, (), self.settings), work=Work(patience))

    def changed(self, part: "Mapping", remark: str) -> "Spec":
        """The Spec with a part merged over it; SpecError with this remark where that is none."""
        return read_changed(self.root, part, self.file, remark, self.settings)

    def anew(self, values: "Given[str, GivenValue]") -> "Problem":
        """The Problem that is read with values for parameters, those that it would choose among them."""
        given = {name: (value.expression.tree, value.expression.scalar) for name, value in values.items()}
        return settled(Problem(read_spec(self.root, self.file, (), {**self.settings, **given})))
