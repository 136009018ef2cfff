"""A plugin of pytest: each answer of a scene is a test, where the configuration says `vibcli = true`.

Nothing else of the program is imported until a scene is collected.
"""

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

if TYPE_CHECKING:
    from vibcli.cli.checking.found import CheckedFile

WHOLE = "scene"         # the test of a scene that has no answers, or cannot be read


class Disagrees(Exception):
    """An answer does not agree, or could not be checked; its text tells where and why."""


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addini("vibcli", "collect the answers of scenes in .yaml and .yml files as tests", type="bool",
                  default=False)


def pytest_collect_file(file_path: Path, parent: pytest.Collector) -> pytest.Collector | None:
    if not parent.config.getini("vibcli"):
        return None
    from vibcli.cli.checking.files import is_scene

    return SceneFile.from_parent(parent, path=file_path) if is_scene(file_path.name) else None


class SceneFile(pytest.File):
    """A scene, checked once for all its answers."""

    _found: "CheckedFile | None" = None

    def collect(self) -> "Iterator[AnswerItem]":
        """A test for each answer, as the file names it; what is wrong with the file is told by them."""
        from vibcli.cli.checking.files import answers_named

        for name, line in answers_named(str(self.path)) or [(WHOLE, 1)]:
            yield AnswerItem.from_parent(self, name=name, line=line, nodeid=f"{self.nodeid}::{name}")

    def checked(self) -> "CheckedFile":
        """What the check of the file found."""
        if self._found is None:
            from vibcli.cli.checking.work import checked_file

            self._found = checked_file(str(self.path))
        return self._found


class AnswerItem(pytest.Item):
    """One answer of a scene; line: where the file names it."""

    def __init__(self, *, line: int, **rest: Any):
        super().__init__(**rest)
        self.line = line

    def runtest(self) -> None:
        """Disagrees where the answer does not agree, is uncertain, or the file could not be checked."""
        from vibcli.cli.checking.found import findings

        assert isinstance(self.parent, SceneFile)
        checked = self.parent.checked()
        told = [one for one in findings(checked) if one.name in ("", self.name)]
        known = {WHOLE} | {answer.name for answer in checked.answers}
        if told or self.name not in known:
            raise Disagrees("\n".join(f"{self._shown(one.file)}:{one.line}: {one.rule}: {one.message}" for one in told)
                            or f"{self._shown(checked.file)}: '{self.name}' was not checked")

    def _shown(self, file: str) -> str:
        """The name of a file, of the scene itself that which pytest gives it."""
        return self.parent.nodeid if file == str(self.path) else file

    def repr_failure(self, excinfo: pytest.ExceptionInfo[BaseException], style: Any = None) -> Any:
        if isinstance(excinfo.value, Disagrees):
            return str(excinfo.value)
        return super().repr_failure(excinfo, style)

    def reportinfo(self) -> tuple[Path, int, str]:
        return self.path, self.line - 1, self.name
