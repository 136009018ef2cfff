"""M, C, G and K in the lines of worked solutions, and in the formats that print them."""

import json

import pytest
from support.renderings import FORMATS, faults
from support.scenes import problem, problem_of
from support.worked_lines import Checked, InOtherUnits, told_later

import vibcli
from vibcli.cli.program import run
from vibcli.homework.line_values import LineValues
from vibcli.notation.latex import in_one_line, latex
from vibcli.notation.mathml import mathml
from vibcli.notation.plain import plain
from vibcli.notation.typst import typst
from vibcli.report.blocks import Document, Name, ShownMatrix, Words
from vibcli.report.formats.formula import formula, rows_of_matrix
from vibcli.report.formats.markdown import latex as protected
from vibcli.report.formats.text import section_lines, shown
from vibcli.report.sections.steps import section_of
from vibcli.report.steps.worked import worked

CAR = """
parameters: {m: 900 kg, J: 1200 kg*m^2, k: 20 kN/m, c: 1.5 kN*s/m, a: 1 m, b: 1.4 m}
bodies: {car: {mass: m, inertia: J, at: [0, 0], move: [0, y, phi]}}
points: {A: {body: car, at: [-a, 0]}, B: {body: car, at: [b, 0]}}
springs: {f: {k: k, between: [[-a, -1 m], A], preload: static}, r: {k: k, between: [[b, -1 m], B], preload: static}}
dampers: {d: {c: c, between: [[-a, -1 m], A]}}
"""
PRINTED = """\
  13  mass matrix, in the order  y, φ:  M = ⎛ m  0 ⎞ = ⎛ 900 kg      0      ⎞
                                            ⎝ 0  J ⎠   ⎝   0     1200 kg·m² ⎠
  14  damping matrix:  C = ⎛  c    −c·a ⎞ = ⎛ 1500 N·s/m  −1500 N·s  ⎞
                           ⎝ −c·a  c·a² ⎠   ⎝ −1500 N·s   1500 N·m·s ⎠
  15  stiffness matrix:  K = ⎛    2·k      k·(b − a)  ⎞ = ⎛ 40000 N/m   8000 N   ⎞
                             ⎝ k·(b − a)  k·(a² + b²) ⎠   ⎝  8000 N    59200 N·m ⎠
"""
CHAIN = """
parameters: {m: , k: }
bodies: {p: {mass: m, slide: x}, q: {mass: m, slide: y}}
springs: {s: {k: k, between: [ground, p]}, t: {k: k, between: [p, q]}}
"""

def text_of(scene):
    return shown(section_lines(section_of(worked(scene))))


def told(lines):
    return {line.settles: formula(line.parts, plain).replace("\u00a0", " ") for line in lines}


def test_they_stand_as_matrices_in_the_text():
    assert PRINTED in text_of(problem(CAR))


def test_each_entry_is_data(tmp_path, capsys):
    path = tmp_path / "car.yaml"
    path.write_text(CAR)
    assert run(["solve", str(path), "--steps", "--json"]) == 0
    lines = json.loads(capsys.readouterr().out)["steps"]
    found, p = {line["settles"]: line for line in lines}, vibcli.load(path)
    assert found["K"]["text"].endswith("= [40000 N/m, 8000 N; 8000 N, 59200 N·m]")
    for entry in ("M[y,y]", "M[phi,phi]", "C[y,phi]", "K[y,y]", "K[y,phi]", "K[phi,phi]"):
        assert found[entry]["value"] == pytest.approx(p[entry].value, rel=1e-13)
        assert found[entry]["number"] == found[entry[0]]["number"]
    assert found["C[y,phi]"]["expression"] == "-c*a" and found["C[y,phi]"]["unit"] == "N·s"
    assert "M[y,phi]" not in found and "K[phi,y]" not in found      # zero, and as across the diagonal


def test_entries_are_what_homework_rounds_on_the_way():
    lines = LineValues(problem(CAR))
    of_entries = [lines.number(text) for text in ("M[y,y]", "K[y,phi]", "K[phi,phi]")]
    assert None not in of_entries and set(of_entries) <= set(lines.uses[lines.number("a0")])


def test_an_entry_that_is_asked_has_the_words_of_the_question():
    lines = worked(problem(CAR.rstrip() + '\nanswers: {"K[1, phi]": 8 kN}\n'))
    (entry,) = [line for line in lines if line.settles.startswith("K[") and line.value == pytest.approx(8000)]
    assert entry.settles == "K[1, phi]" and entry.number == next(one.number for one in lines if one.settles == "K")


@pytest.mark.sweep
def test_letters_alone_have_no_numbers_and_what_there_is_not_no_matrix():
    lines = told(worked(problem(CHAIN)))
    assert lines["M"] == "mass matrix, in the order  x, y:  M = [m, 0; 0, m]"
    assert lines["K"] == "stiffness matrix:  K = [2·k, −k; −k, k]" and not {"C", "G"} & set(lines)
    turning = told(worked(problem_of("problems/6_two_degrees/particle_on_turning_disc.yaml")))
    assert turning["G"] == "gyroscopic matrix:  G = [0, −2·m·Ω; 2·m·Ω, 0]" and "C" not in turning


def test_one_degree_has_none():
    one = "parameters: {m: , k: }\nbodies: {p: {mass: m, slide: x}}\nsprings: {s: {k: k, between: [ground, p]}}\n"
    assert not {"M", "K"} & set(told(worked(problem(one))))


def test_numbers_alone_stand_once():
    given = problem("coordinates: [x, y]\nmatrices: {M: [[9, 0], [0, 1]], K: [[27, -3], [-3, 3]]}\n")
    assert told(worked(given))["K"] == "stiffness matrix:  K = [27, −3; −3, 3] N/m"


def test_what_no_page_holds_in_letters_is_told_entry_by_entry_and_in_numbers():
    line, = [line for line in worked(problem_of("problems/6_two_degrees/motor_on_inclined_mounts.yaml"))
             if line.settles == "K"]
    text = formula(line.parts, plain)
    assert text.startswith("stiffness matrix:  K₁₁ = ") and ",  K₁₂ = K₂₁ = " in text
    assert sum(isinstance(part, ShownMatrix) for part in line.parts) == 1 and text.count("N/m") == 1


MATRIX = ShownMatrix(((("1/2",), (Name("k1"),)), ((Words("any"),), ("−3",))))


@pytest.mark.parametrize(("write", "wanted"), [
    (plain, "[1/2, k₁; any, −3]"), (latex, r"\begin{pmatrix} 1 / 2 & k_{1} \\ \text{any} & - 3 \end{pmatrix}"),
    (in_one_line, r"\begin{pmatrix} 1 / 2 & k_{1} \\ \text{any} & - 3 \end{pmatrix}"),
    (protected, r"\begin{pmatrix} 1 / 2 & k _ {1} \cr \text{any} & - 3 \end{pmatrix}"),
    (typst, 'mat(delim: "(", 1 \\/ 2, k_(1); "any", - 3)')])
def test_a_matrix_in_each_notation(write, wanted):
    assert formula([MATRIX], write) == wanted


def test_a_matrix_on_a_page_has_rows_of_cells():
    text = formula([MATRIX], mathml)
    assert text.count("<mtr>") == 2 and text.count("<mtd>") == 4 and text.startswith("<mrow><mo>(</mo><mtable")


def test_columns_are_as_wide_as_their_widest_entry():
    assert rows_of_matrix(MATRIX) == ["⎛ 1/2  k₁ ⎞", "⎝ any  −3 ⎠"]
    three = ShownMatrix(tuple((("1",), (Name("x''"),)) for _ in range(3)))
    assert rows_of_matrix(three) == ["⎛ 1  ẍ ⎞", "⎜ 1  ẍ ⎟", "⎝ 1  ẍ ⎠"]


@pytest.mark.sweep
def test_no_format_is_at_fault_with_matrices_that_fill_a_line():
    scene = problem_of("problems/7_more_degrees/six_storeys_shaken_at_the_top.yaml")
    lines = worked(scene)
    assert sum(isinstance(part, ShownMatrix) for line in lines for part in line.parts) == 6
    assert not faults(Document("six", None, (), section_of(lines)), FORMATS)


def test_a_wrong_entry_and_a_letter_in_one_that_nothing_tells_are_seen():
    scene = problem(CAR)
    lines = worked(scene)
    assert not Checked(scene, lines).wrong and not InOtherUnits(scene, lines).wrong and not told_later(scene, lines)
    at, line = next((i, one) for i, one in enumerate(lines) if one.settles == "K")
    table = scene.scene.table

    def with_first(cell, of):
        matrices = [i for i, part in enumerate(line.parts) if isinstance(part, ShownMatrix)]
        first = next(i for i in matrices if type(line.parts[i].rows[0][0][0]) is of)
        (row, *rows) = line.parts[first].rows
        other = ShownMatrix((((cell, *row[0][1:]), *row[1:]), *rows))
        parts = (*line.parts[:first], other, *line.parts[first + 1:])
        return [*lines[:at], line._replace(parts=parts), *lines[at + 1:]]

    assert Checked(scene, with_first("40001.", str)).wrong
    assert InOtherUnits(scene, with_first(table.parameter("k") * table.parameter("a"), type(table.one))).wrong
    assert told_later(scene, with_first(table.parameter("nobody"), type(table.one))) == [(line.number, "nobody")]
