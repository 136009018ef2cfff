"""From a file, a text or a mapping to the Model of it."""

import os
from collections.abc import Mapping

from vibcli.api.model import Model
from vibcli.api.source import UNNAMED, SceneSource, file_source, problem_of, text_source
from vibcli.language.document.mapping import document_of


def load(scene: str | os.PathLike[str] | Mapping[str, object]) -> Model:
    """The Model of a scene file, or of a mapping that holds what such a file would. SpecError where it is invalid;
    FileNotFoundError where there is no such file."""
    if isinstance(scene, Mapping):
        return _model(SceneSource(UNNAMED, *document_of(scene), []))
    return _model(file_source(scene))


def loads(text: str, folder: str | os.PathLike[str] = ".") -> Model:
    """The Model of the text of a scene; `folder`: where its records lie. SpecError where it is invalid."""
    if not isinstance(text, str):
        raise TypeError(f"expected the text of a scene, found {type(text).__name__}; vibcli.load takes files "
                        "and mappings")
    return _model(text_source(text, folder))


def _model(source: SceneSource) -> Model:
    return Model(source, problem_of(source))
