"""Faces are tables: each tells of every file of its folder, and imports nothing."""

import ast
from importlib import import_module

import pytest

from house.measure import PACKAGE
from vibcli import analyses, elements, quantities
from vibcli.api.reports import FOUND_BY
from vibcli.cli import COMMANDS
from vibcli.drawing.symbols import SYMBOLS
from vibcli.evidence.stress.families import FAMILIES
from vibcli.homework import exports
from vibcli.language import sections as of_language
from vibcli.reader import sections as of_questions
from vibcli.report import formats
from vibcli.report import sections as of_report
from vibcli.symbolic.parser import OF_SIGNALS

FACES = ("analyses", "cli", "drawing/symbols", "elements", "evidence/stress/families", "homework/exports",
         "language/sections", "quantities", "reader/sections", "report/formats", "report/sections")


def defines(path, name):
    """Does a file define a function, class or value of that name?"""
    tree = ast.parse(path.read_text(encoding="utf-8"))
    return name in {getattr(node, "name", None) for node in tree.body} | {
        target.id for node in tree.body if isinstance(node, ast.Assign) for target in node.targets
        if isinstance(target, ast.Name)}


@pytest.mark.parametrize("folder", FACES)
def test_a_face_imports_nothing(folder):
    tree = ast.parse((PACKAGE / folder / "__init__.py").read_text(encoding="utf-8"))
    assert all(isinstance(node, (ast.Expr, ast.Assign)) for node in tree.body)


@pytest.mark.parametrize(("table", "folder"), [
    pytest.param(of_language.NAMES, "language/sections", id="language"),
    pytest.param(of_questions.NAMES, "reader/sections", id="reader")])
def test_a_face_tells_of_every_file_of_its_folder(table, folder):
    files = {path.stem for path in (PACKAGE / folder).glob("*.py")} - {"__init__"}
    assert list(table) == sorted(files)
    assert [name for name, about in table.items() if not is_a_line(about)] == []


def test_families_of_stress_are_the_files_that_define_one():
    files = (PACKAGE / "evidence" / "stress" / "families").glob("*.py")
    assert [path.stem for path in sorted(files) if defines(path, "FAMILY")] == list(FAMILIES)
    assert all(map(is_a_line, FAMILIES.values()))


def test_elements_are_the_files_that_define_one():
    files = (PACKAGE / "elements").glob("*.py")
    assert {path.stem for path in files if defines(path, "ELEMENT")} == set(elements.ELEMENTS)
    assert all(is_a_line(about) for _, about in elements.ELEMENTS.values())


def test_every_word_of_find_is_answered_by_sections():
    assert set(analyses.FIND) == set(FOUND_BY)
    assert {section for found in FOUND_BY.values() for section in found} <= set(of_report.SECTIONS)


def test_analyses_of_modes_are_functions_of_their_files_and_what_has_particulars_declares_them():
    for word, (file, particulars, _) in analyses.ANALYSES.items():
        path = PACKAGE / "analyses" / f"{file}.py"
        assert word in analyses.FIND and defines(path, word) == (word in analyses.OF_MODES)
        assert defines(path, "ELEMENT") == (particulars is not None) and (particulars is None or path.stem == word)
        assert particulars is None or is_a_line(particulars)


def test_symbols_are_the_files_that_draw_what_joins_two_ends():
    files = {path.stem for path in (PACKAGE / "drawing" / "symbols").glob("*.py")
             if defines(path, "NAMED_BY") and defines(path, "between")}
    assert {file for file, _ in SYMBOLS.values()} == files
    assert set(SYMBOLS) == {name for name in elements.ELEMENTS
                            if getattr(import_module(f"vibcli.elements.{name}").ELEMENT, "signals", None)}
    assert all(is_a_line(about) for _, about in SYMBOLS.values())


def is_a_line(about):
    return 0 < len(about) <= 90 and "\n" not in about


def test_formats_are_the_files_that_render():
    files = (PACKAGE / "report" / "formats").glob("*.py")
    assert {path.stem for path in files if defines(path, "render")} == set(formats.FORMATS)
    assert all(is_a_line(about) for _, _, about in formats.FORMATS.values())


def test_exports_are_the_files_that_write_a_package():
    files = (PACKAGE / "homework" / "exports").glob("*.py")
    assert {path.stem for path in files if defines(path, "package")} == set(exports.FORMATS)
    assert all(is_a_line(about) for about in exports.FORMATS.values())


@pytest.mark.sweep
def test_sections_of_a_report_are_the_generators_of_their_files(house):
    """A section is a generator that takes the problem and the report, which it may not need."""
    found = {(node.name, module.rpartition(".")[2]) for module, tree in house.trees.items()
             if module.startswith("vibcli.report.sections.") for node in tree.body
             if isinstance(node, ast.FunctionDef) and [arg.arg for arg in node.args.args] in (
                 ["problem", "report"], ["problem", "_"]) and not node.name.startswith("_")
             and any(isinstance(part, (ast.Yield, ast.YieldFrom)) for part in ast.walk(node))}
    assert found == {(name, file) for name, (file, _) in of_report.SECTIONS.items()}
    assert all(is_a_line(about) for _, about in of_report.SECTIONS.values())


def test_commands_are_the_files_that_define_one():
    files = (PACKAGE / "cli").glob("*.py")
    assert {path.stem for path in files if defines(path, "command")} == set(COMMANDS)


def test_families_of_quantities_are_the_values_of_their_files():
    families = {name: set(import_module(f"vibcli.quantities.{name}").QUANTITIES)
                for name in {*quantities.FAMILIES.values(), *quantities.FORMS.values()}}
    assert {head: name for name, heads in families.items() for head in heads} == quantities.FAMILIES | quantities.FORMS


def test_what_is_asked_of_a_signal_in_round_brackets_is_known_to_the_parser():
    declared = {form: import_module(f"vibcli.quantities.{family}").QUANTITIES[form]
                for form, family in {**quantities.FAMILIES, **quantities.FORMS}.items() if form != "value"}
    asked = {form.partition("(")[0] for form, quantity in declared.items() if quantity.args and not quantity.indices}
    assert {"abs", *asked} == set(OF_SIGNALS)
