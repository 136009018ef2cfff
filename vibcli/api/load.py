"""From a file, a text or a mapping to the Model of it."""

import os
from collections.abc import Mapping

from vibcli.api.mapping import document_of
from vibcli.api.model import Model
from vibcli.api.source import SceneSource, file_source, problem_of
from vibcli.base.decoding import MAX_BYTES, too_long
from vibcli.base.errors import SpecError
from vibcli.language.document.document import read

UNNAMED = "scene"       # of a text: diagnostics name it before line and column


def load(scene: str | os.PathLike[str] | Mapping[str, object]) -> Model:
    """The Model of a scene file, or of a mapping that holds what such a file would. SpecError where it is invalid;
    FileNotFoundError where there is no such file."""
    if isinstance(scene, Mapping):
        return _model(SceneSource(UNNAMED, *document_of(scene), []))
    return _model(file_source(scene))


def loads(text: str, folder: str | os.PathLike[str] = ".") -> Model:
    """The Model of the text of a scene; `folder`: where its records lie."""
    file = os.path.normpath(os.path.join(os.fspath(folder), UNNAMED))
    data = text.encode("utf-8", "surrogatepass")
    if len(data) > MAX_BYTES:
        raise SpecError([too_long(file, len(data))])
    return _model(SceneSource(file, *read(data, file), text.splitlines()))


def _model(source: SceneSource) -> Model:
    return Model(source, problem_of(source))
