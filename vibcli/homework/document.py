"""The document of a scene, from which it is read anew with other values, or with a part changed."""

from collections.abc import Mapping as Given
from functools import cached_property
from typing import TYPE_CHECKING, Any

from vibcli.base.errors import Diagnostic, SpecError, Where
from vibcli.base.work import Work
from vibcli.inverse import settled
from vibcli.language.cases import document_of_case
from vibcli.language.data_columns import columns_in, data_beside
from vibcli.language.document.nodes import Mapping
from vibcli.reader.read import read_alone, read_changed
from vibcli.results.problem import Problem
from vibcli.symbolic.parser import plain_name

if TYPE_CHECKING:
    from vibcli.language.given_values import GivenValue
    from vibcli.language.spec import Spec
    from vibcli.reader.variants import VariantRules


class SceneDocument:
    """The top of a document, that of a case of it included; settings: {parameter: (syntax tree, text)} that replace
    values of the file; files: {name: what stands in it} of those beside it, which are read there unless given."""

    def __init__(self, root: "Mapping", file: str, settings: dict[str, tuple[Any, Any]],
                 files: "Given[str, bytes] | None" = None):
        self.root, self.file, self.settings = root, file, settings
        self._given = files
        self._columns = {(file, name): columns_in(file, name, data) for name, data in (files or {}).items()}
        self._bare = Mapping(root.where, {key: pair for key, pair in root.entries.items() if key != "variants"})

    @classmethod
    def of(cls, root: "Mapping", file: str, case: str | None, settings: Any = None,
           files: "Given[str, bytes] | None" = None) -> "SceneDocument":
        """The document of a scene, or of a case of it."""
        return cls(document_of_case(root, case), file, settings or {}, files)

    @cached_property
    def files(self) -> dict[str, bytes]:
        """{name: what stands in it} of the files beside the scene that it takes numbers from."""
        if self._given is not None:
            return dict(self._given)
        self.spec()
        return {name: self._beside(name) for _, name in sorted(self._columns)}

    def _beside(self, name: str) -> bytes:
        data, problem = data_beside(self.file, name)
        if data is None:
            raise SpecError([Diagnostic(Where(self.file, 1, 1, 0), *problem)])
        return data

    @cached_property
    def rules(self) -> "VariantRules":
        """What it says of variants."""
        found: VariantRules = self.spec().get("variants")
        return found

    def spec(self) -> "Spec":
        """The Spec of it."""
        return read_alone(self.root, self.file, self.settings, self._columns)

    def problem(self, patience: int = 1) -> "Problem":
        """The Problem that is read anew as it stands."""
        return Problem(self.spec(), work=Work(patience))

    def changed(self, part: "Mapping", remark: str) -> "Spec":
        """The Spec with a part merged over it, whose parameters have the values of that; SpecError with this remark
        where that is none."""
        settings = {name: value for name, value in self.settings.items() if name not in parameters_of(part)}
        return read_changed(self.root, part, self.file, remark, settings)

    def with_values(self, values: "Given[str, GivenValue]") -> "SceneDocument":
        """The document with values for parameters."""
        return SceneDocument(self.root, self.file, self._with(values), self._given)

    def anew(self, values: "Given[str, GivenValue]") -> "Problem":
        """The Problem that is read with values for parameters, those that it would choose among them."""
        spec = read_alone(self._bare, self.file, self._with(values), self._columns)
        return settled(Problem(spec.with_sections(variants=self.rules)))

    def _with(self, values: "Given[str, GivenValue]") -> dict[str, tuple[Any, Any]]:
        return {**self.settings, **settings_of(values)}


def parameters_of(part: "Mapping") -> set[str]:
    """The names of the parameters to which a part of a scene gives values."""
    given = part.entries["parameters"][1] if "parameters" in part.entries else None
    return {plain_name(name) for name in given.entries} if isinstance(given, Mapping) else set()


def settings_of(values: "Given[str, GivenValue]") -> dict[str, tuple[Any, Any]]:
    """{parameter: (syntax tree, text)} of values for parameters."""
    return {name: (value.expression.tree, value.expression.scalar) for name, value in values.items()}
