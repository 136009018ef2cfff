"""A scene file as it is read again with its document changed."""

from collections.abc import Callable, Mapping
from fractions import Fraction
from functools import partial
from typing import Any

from vibcli.inverse import settled
from vibcli.language.cases import document_of_case
from vibcli.language.document.nodes import Mapping as DocumentMapping
from vibcli.language.document.nodes import Scalar
from vibcli.reader.read import read_alone
from vibcli.results.problem import Problem
from vibcli.symbolic.parser import plain_name

VALUE = "value"
Remade = Callable[[Callable[[DocumentMapping], DocumentMapping]], Problem]


def read_again(top: DocumentMapping, file: str, settings: Mapping[str, tuple[Any, Scalar]], case: str | None,
               work: Callable[[], Any] = lambda: None, drawn: Mapping[str, str] | None = None
               ) -> tuple[DocumentMapping, Remade]:
    """(the document of a case, of the scene itself where none is named, with other values of parameters; what makes the
    Problem of it changed). work(): what counts the long work of one; drawn: values of letters that have none in it."""
    found = with_settings(document_of_case(top, case), settings)
    found = DocumentMapping(found.where, {key: entry for key, entry in found.entries.items() if key != "cases"})

    def remade(change: Callable[[DocumentMapping], DocumentMapping]) -> Problem:
        problem = Problem(read_alone(change(found), file), work=work())
        problem = settled(problem) if problem.spec.choices else problem
        return problem.with_values({name: Fraction(value) for name, value in drawn.items()}) if drawn else problem

    return found, remade


def with_settings(top: DocumentMapping, settings: Mapping[str, tuple[Any, Scalar]]) -> DocumentMapping:
    """The document with other values of parameters."""
    def given(scalar: Scalar, node: Any) -> Any:
        has_more = isinstance(node, DocumentMapping) and VALUE in node.entries
        return replaced(node, VALUE, lambda _: scalar) if has_more else scalar

    for section in {"parameters", "choose"} & top.entries.keys():
        for key in top.entries[section][1].entries:
            if plain_name(key) in settings:
                _, scalar = settings[plain_name(key)]
                values = replaced(top.entries[section][1], key, partial(given, scalar))
                top = DocumentMapping(top.where, {**top.entries, section: (top.entries[section][0], values)})
    return top


def replaced(node: DocumentMapping, name: str, change: Callable[[Any], Any]) -> DocumentMapping:
    """The mapping with one of its values changed."""
    key, value = node.entries[name]
    return DocumentMapping(node.where, {**node.entries, name: (key, change(value))})
