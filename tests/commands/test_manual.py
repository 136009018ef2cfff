"""The manual: every key of every element is explained and shown in a scene that runs; schema and templates are true."""

import json
from pathlib import Path

import jsonschema
import pytest
import yaml
from support.homework_scenes import BLOCK
from support.imported import modules

import vibcli
from vibcli.base.units import UNITS
from vibcli.check.verdicts import check
from vibcli.cli import COMMANDS
from vibcli.cli.program import run
from vibcli.elements import ELEMENTS
from vibcli.language.document.document import read, read_file
from vibcli.language.fields import Element
from vibcli.language.named_elements import load
from vibcli.manual import expressions, scenes, topics
from vibcli.manual.aliases import ALIASES
from vibcli.manual.catalogue import FACES, Catalogue
from vibcli.manual.index import Index, nearest_words, page, words
from vibcli.manual.json_schema import schema
from vibcli.manual.overview import overview
from vibcli.quantities import FAMILIES
from vibcli.reader.read import SECTIONS, read_spec
from vibcli.reader.sections.find import FIND
from vibcli.report.json_keys import KEYS
from vibcli.results.problem import Problem
from vibcli.symbolic.parser import FUNCTIONS

ROOT = Path(__file__).parents[2]
PACKAGE = Path(vibcli.__file__).parent
EXAMPLES = sorted((PACKAGE / "examples").glob("*.yaml"))
TEMPLATES = sorted((PACKAGE / "templates").glob("*.yaml"))
PROBLEMS = sorted((ROOT / "problems").glob("*/*.yaml"))
NARROW = 88


def problem_of(path):
    root, diagnostics, _ = read_file(str(path))
    return Problem(read_spec(root, str(path), diagnostics))


def stem(path):
    return path.stem


def answers_in(spec):
    return len(spec.answers) + sum(len(case.answers) for case in spec.cases.values())


# scenes


@pytest.mark.sweep
@pytest.mark.parametrize("path", EXAMPLES + TEMPLATES, ids=stem)
def test_scenes_agree_with_their_answers(path):
    problem = problem_of(path)
    verdicts = check(problem)
    assert len(verdicts) == answers_in(problem.spec) >= 1
    assert [(v.case, v.answer.asked.text, v.expected, v.found) for v in verdicts if not v.agrees] == []


def test_wrong_answers_would_show():
    path = PACKAGE / "examples" / "mass_spring_damper.yaml"
    text = path.read_text(encoding="utf-8").replace("20 rad/s", "20.01 rad/s")
    root, diagnostics = read(text.encode(), "wrong.yaml")
    verdicts = check(Problem(read_spec(root, "wrong.yaml", diagnostics)))
    assert [v.answer.asked.text for v in verdicts if not v.agrees] == ["omega[1]"]


@pytest.mark.parametrize("path", EXAMPLES, ids=stem)
def test_examples_say_what_they_are(path):
    spec = problem_of(path).spec
    assert all(spec.get(section) for section in ("title", "source", "question"))


def test_how_many_scenes_there_are():
    assert len(EXAMPLES) >= 55 and len(TEMPLATES) >= 10
    assert {path.stem for path in EXAMPLES} & {path.stem for path in TEMPLATES} == set()


def test_every_key_and_section_stands_in_an_example():
    catalogue = Catalogue()
    used = {use for path in EXAMPLES for use in catalogue.used(read_file(str(path))[0])}
    pairs = catalogue.pairs()
    assert [pair for pair in pairs if pair not in used] == []
    assert [section for section in SECTIONS if section not in used] == []
    assert len(pairs) == len(set(pairs)) >= 112 and len(SECTIONS) >= 19


def test_the_catalogue_knows_every_element_file():
    elements = Catalogue().elements
    files = {name: getattr(load(name, room), "ELEMENT", None)
             for room, names in (*FACES, ("elements", ELEMENTS)) for name in names}
    known = [declared.kind for declared in elements.values()]
    declared = [kind for kind in files.values() if isinstance(kind, Element)]
    assert len(declared) >= 14
    assert all(any(kind is one for one in known) for kind in declared)


def test_uses_are_found_by_key_and_by_short_form():
    text = (b"bodies:\n  a: {mass: 1, slide: x}\n  b: {mass: 1, slide: {by: y, along: [0, 1]}}\n"
            b"cases: {c: {gravity: 1}}\n")
    used = Catalogue().used(read(text, "x.yaml")[0])
    assert used.count(("slide", "by")) == 2 and used.count(("slide", "along")) == 1
    assert used.count(("body", "slide")) == 2 and "gravity" in used and ("slide", "carrier") not in used


def test_every_element_names_an_example_that_uses_it():
    catalogue = Catalogue()
    swept = 0
    for word, declared in catalogue.elements.items():
        if declared.fields:
            used = {use for use in catalogue.used(scenes.document(declared.example)) if use[0] == word}
            assert used, f"{declared.example} does not use {word}"
            swept += 1
    assert swept >= 15


@pytest.mark.parametrize("head", FAMILIES)
def test_every_quantity_is_asked_in_an_example(head):
    assert scenes.asking(head) is not None


# pages


@pytest.fixture(scope="module")
def pages():
    index = Index()
    return {word: index.page(word) for word in index.entries}


@pytest.mark.sweep
def test_pages_are_narrow_and_whole(pages):
    for word, text in {**pages, "": overview()}.items():
        lines = text.split("\n")
        assert "None" not in text, word
        assert max(map(len, lines)) <= NARROW, (word, max(lines, key=len))
        assert not any(line != line.rstrip() for line in lines), word
        assert text.count("`") % 2 == 0 and "\x1f" not in text, word
        assert "\n\n\n" not in text, word
    assert len(pages) >= 250


@pytest.mark.sweep
def test_every_word_has_a_page(pages):
    catalogue = Catalogue()
    expected = [*SECTIONS, *catalogue.elements, *UNITS, *FUNCTIONS, *FAMILIES, *FIND, *topics.TOPICS]
    expected += [f"{word}.{key}" for word, key in catalogue.pairs()] + [key for _, key in catalogue.pairs()]
    assert [word for word in expected if word not in pages] == []
    assert len(set(expected)) >= 200
    assert set(words()) >= set(pages)
    assert all(page(word) for word in [*ALIASES, *(set(COMMANDS) - {"explain", "new"})])


@pytest.mark.parametrize(("word", "same"), [
    ("springs.preload", "spring.preload"), ("spring preload", "spring.preload"), ("Spring", "spring"),
    ("ω", "omega"), ("ζ", "zeta"), ("exit codes", "exit"), ("half angle", "half_angle"), ("`pin`", "pin"),
    ("bodies.slide", "body.slide")])
def test_words_are_found_as_people_write_them(word, same):
    assert page(word) == page(same)


@pytest.mark.parametrize(("word", "title"), [
    ("response", "response — motions in time"), ("frf", "frf[x, F](5 Hz) — a quantity"),
    ("frequency response", "frequency_response — amplitude and phase"), ("initial", "initial — a section"),
    ("records", "records — a section"), ("earthquake", "record — an entry of `records`"),
    ("phase", "phase(x) — a quantity"), ("amplitude", "amplitude(x) — a quantity"),
    ("steady", "steady(x) — a quantity"), ("transmissibility", "transmissibility[x, F](5 Hz) — a quantity"),
    ("resonance", "frequency_response — "), ("absorber", "frequency_response — "),
    ("isolation", "frequency_response — "), ("shock", "time — "), ("until", "response.until — "),
    ("draw", "pictures — "), ("animate", "pictures — "), ("plot", "pictures — "), ("html", "reports — "),
    ("csv", "data — ")])
def test_words_of_textbooks_lead_to_their_pages(word, title):
    assert page(word).startswith(title)


@pytest.mark.parametrize("head", [head for head, family in FAMILIES.items() if family.endswith("response")])
def test_quantities_of_responses_name_the_page_about_them(head):
    assert f"More: vibcli explain {FAMILIES[head]};" in page(head)


def test_a_key_is_shown_in_every_element_that_has_it():
    text = page("torsion")
    assert "spring.torsion — " in text and "damper.torsion — " in text
    assert "damper.torsion" not in page("spring.torsion")


def test_a_page_says_what_an_element_is_and_shows_a_scene():
    text = page("spring")
    for part in ("spring — an entry of `springs`", "One or more of `k`, `torsion`, `law`, `series` or",
                 "free_length  a length (m)", "A scene that runs (vibcli new preloaded_spring):", "  springs:\n"):
        assert part in text


def test_shapes_come_from_the_laws():
    text = page("shapes")
    assert "J_C = m*(width^2 + height^2)/12" in text
    assert "OC = 2*radius*sin(half_angle)/(3*half_angle)" in text


def test_an_element_that_has_other_keys_elsewhere_is_told_with_all():
    """Ends of beams may be guided, those of shafts have no spring `k`; what they hold is told with its measure."""
    end = " ".join(page("end").split())
    assert "Guided to a body or another member. Of `beams`." in end
    assert "The stiffness of a spring to the ground. Of `bars`, `beams` and `strings`." in end
    assert "(N·s/m); of `shafts` a torsional damping coefficient (N·m·s)" in end
    assert "At most one of `clamped`, `pinned` or `guided` may stand." in end and "`clamped` or `pinned`" not in end
    assert "of `shafts`" in page("attachment.c")
    assert "Its bending stiffness. Of `beams`." in " ".join(page("segment").split())
    assert "of     `beams`" in page("segment.EI")
    assert "Of `" not in page("section") + page("bar")


@pytest.mark.sweep
def test_the_key_page_shows_a_scene_with_the_key():
    catalogue, swept = Catalogue(), 0
    for word, key in catalogue.pairs():
        name = scenes.using(catalogue, (word, key), catalogue.elements[word].example)
        assert (word, key) in catalogue.used(scenes.document(name))
        swept += 1
    assert swept >= 112


def test_tables_of_texts_match_what_runs():
    assert set(expressions.FUNCTIONS) == set(FUNCTIONS)


@pytest.mark.sweep
def test_json_keys_are_those_that_are_printed(capsys, tmp_path):
    printed = set()
    for name, *options in (("mass_spring_damper", "--insight"), ("given_matrices",), ("bead_on_a_rail",),
                           ("hanging_rod",), ("mast_on_two_stays",), ("ropes_and_links",), ("buckled_post",),
                           ("forced_vibration",), ("frequency_response",), ("dry_friction",),
                           ("shear_frame_by_ritz",), ("atwoods_machine",), ("concurrent_springs",),
                           ("swing_by_amplitude",), ("expanded_about_rest",), ("wide_swing", "--steps")):
        code, out, _ = call(capsys, "solve", "--json", *options, scenes.path(name))
        assert code == 0
        printed |= _paths(json.loads(out))
    damped = tmp_path / "damped.yaml"       # whose damper may be forgotten: then there is no such answer
    damped.write_text(f'{BLOCK}variants: {{parameters: {{m: [1.2 kg, 2.4 kg]}}, ask: {{"zeta[1]": }}}}\n',
                      encoding="utf-8")
    several = tmp_path / "several.yaml"
    several.write_text(Path(scenes.path("set_of_variants")).read_text(encoding="utf-8").replace(
        "sample: 60", "sample: 6"), encoding="utf-8")
    for file in (str(several), str(damped)):
        code, out, _ = call(capsys, "variants", file, "--json")
        assert code == 0
        printed |= _paths(json.loads(out))
    code, out, _ = call(capsys, "response", scenes.path("forced_vibration"), "--json", "--at", "0.5")
    assert code == 0
    printed |= _paths(json.loads(out))
    bar = tmp_path / "bar.yaml"
    bar.write_text("bars: {NAME: {length: 2 m, EA: 2 N, mass_per_length: 1 kg/m, left: clamped}}\n"
                   "initial: {NAME.u': 1 m/s}\nfind: [{response: {of: [\"NAME.u'(1 m)\"], until: 6 s}}]\n",
                   encoding="utf-8")
    slider = tmp_path / "slider.yaml"
    slider.write_text("bodies: {p: {mass: 1 kg, at: [0, 0], slide: x}}\nmotion: {order: 3}\ninitial: {x: 1 cm}\n"
                      "springs: {s: {k: 1 N/m, preload: 1 N, between: [[0, 1 m], p]}}\n", encoding="utf-8")
    chain = tmp_path / "chain.yaml"
    chain.write_text("bodies: {p: {mass: 1 kg, slide: x}}\nsprings:\n  s:\n    series: [{k: 2 N/m}, {law: 3 N/m*d + 4 "
                     "N/m^3*d^3}]\n    between: [ground, p]\ninitial: {x: 1 cm}\nfind: [expansion]\n", encoding="utf-8")
    sweep = ("sweep", scenes.path("mass_spring_damper"), "--over", "k=-1 .. 800", "--points", "3")
    coupled = tmp_path / "coupled.yaml"
    coupled.write_text("parameters: {k: 1 N/m}\nbodies: {a: {mass: 1 kg, slide: x}, b: {mass: 1 kg, slide: y}}\n"
                       "springs: {s: {k: k, stretch: x}, t: {k: 1 N/m, stretch: y}}\n", encoding="utf-8")
    for command, file, *options in (sweep, ("sweep", coupled, "--over", "k=0.5 .. 2"),
                                    ("frequencies", bar), ("solve", chain), ("response", bar), ("response", slider),
                                    ("response", slider, "--phase-plane")):
        code, out, _ = call(capsys, command, str(file), "--json", *options)
        assert code == 0
        printed |= _paths(json.loads(out))
    assert printed - set(KEYS) == set()
    assert set(KEYS) - printed <= {"characteristic_polynomial", "remark"}


NAMED_BY_THE_SCENE = ("reactions", "values", "forces", "shape", "potential", "kinetic", "dissipation", "deflection",
                      "alone", "bounds", "coordinates", "dependent", "initial")


def _paths(data, path=""):
    """Dotted paths of an object; what is named by the scene (coordinates, cases) is not entered."""
    found = set()
    for key, value in data.items():
        here = f"{path}.{key}".lstrip(".")
        found.add(here)
        if here == "cases" or (key in NAMED_BY_THE_SCENE and (path or key == "reactions")):
            continue
        if isinstance(value, dict):
            found |= _paths(value, here)
        elif isinstance(value, list):
            for item in value:
                found |= _paths(item, here + "[]") if isinstance(item, dict) else set()
    return found


# commands


def call(capsys, *arguments):
    code = run(list(arguments))
    return code, *capsys.readouterr()


def test_explain(capsys):
    assert call(capsys, "explain")[:2] == (0, overview() + "\n")
    assert call(capsys, "explain", "exit", "codes")[:2] == (0, page("exit") + "\n")
    code, out, err = call(capsys, "explain", "sprign")
    assert (code, out) == (2, "") and "'sprign'" in err and "spring" in err
    code, out, err = call(capsys, "explain", "xyzzyxyzzy")
    assert (code, out) == (2, "") and "vibcli explain" in err
    assert nearest_words("dampr")[0] == "damper"


def test_new_prints_and_writes_but_never_overwrites(capsys, tmp_path):
    code, out, _ = call(capsys, "new")
    assert code == 0 and out == (PACKAGE / "templates" / "mass_spring.yaml").read_text(encoding="utf-8")
    file = tmp_path / "p.yaml"
    assert call(capsys, "new", "pendulum", "-o", str(file))[:2] == (0, "")
    assert file.read_text(encoding="utf-8") == scenes.text("pendulum")
    code, out, err = call(capsys, "new", "rolling", "-o", str(file))
    assert (code, out) == (2, "") and "exists already" in err
    assert file.read_text(encoding="utf-8") == scenes.text("pendulum")
    assert call(capsys, "new", "rolling", "-o", str(tmp_path / "no" / "p.yaml"))[0] == 2
    code, _, err = call(capsys, "new", "pendulm")
    assert code == 2 and "pendulum" in err


def test_new_lists_what_there_is(capsys):
    code, out, _ = call(capsys, "new", "--list")
    assert code == 0 and all(path.stem in out for path in EXAMPLES + TEMPLATES)
    assert max(map(len, out.split("\n"))) <= NARROW


@pytest.mark.parametrize("path", TEMPLATES, ids=stem)
def test_templates_are_commented_and_narrow(path):
    lines = path.read_text(encoding="utf-8").split("\n")
    assert lines[0].startswith("# ") and sum("#" in line for line in lines) >= 3
    assert max(map(len, lines)) <= NARROW


@pytest.mark.parametrize("arguments", [["explain"], ["explain", "spring"], ["explain", "shapes"], ["explain", "by"],
                                       ["schema"], ["new"], ["new", "--list"]], ids=" ".join)
def test_the_manual_imports_nothing_heavy(arguments):
    assert modules(*arguments) == (0, set())


# schema


@pytest.fixture(scope="module")
def validator():
    found = schema()
    jsonschema.Draft7Validator.check_schema(found)
    return jsonschema.Draft7Validator(found)


@pytest.mark.parametrize("path", EXAMPLES + TEMPLATES + PROBLEMS, ids=stem)
def test_the_schema_accepts_what_is_right(path, validator):
    data = yaml.load(path.read_text(encoding="utf-8"), Loader=getattr(yaml, "CSafeLoader", yaml.SafeLoader))
    assert [f"{list(e.absolute_path)}: {e.message}" for e in validator.iter_errors(data)] == []


@pytest.mark.parametrize("text", [
    "bodys: {a: {mass: 1, slide: x}}",
    "bodies: {a: {mass: 1, slide: x, colour: red}}",
    "bodies: {a: {mass: 1, slide: x, turn: phi}}",
    "bodies: {a: {shape: disk, mass: 1}}",
    "bodies: {a: {mass: 1, pin: {at: O}}}",
    "bodies: {a: {mass: 1, move: [x]}}",
    "bodies: {a: {mass: 1, roll: {surface: floor}}}",
    "bodies: {1a: {mass: 1, slide: x}}",
    "bodies: {a: {parts: []}}",
    "springs: {s: {k: 1}}",
    "springs: {s: {k: 1, torsion: 2, between: [a, b]}}",
    "springs: {s: {k: 1, between: [a, b, c]}}",
    "springs: [{k: 1, between: [a, b]}]",
    "points: {A: [1, 2, 3]}",
    "surfaces: {s: {circle: [0, 0], radius: 1, side: left}}",
    "find: [everything]",
    "find: []",
    "answers: [1]",
    "parameters: {k: {sign: negative}}",
    "cases: {a: {cases: {}}}",
    "cases: {a: {body: {}}}",
    "matrices: {M: [1, 2]}",
    "gravity: [1, 2, 3]",
    "energies: {U: x^2}",
])
def test_the_schema_rejects_what_is_wrong(text, validator):
    data = yaml.safe_load(text)
    assert list(validator.iter_errors(data)), text


def test_the_schema_describes_every_key(validator):
    found, described = validator.schema, 0
    assert set(found["properties"]) == set(SECTIONS)
    for declared in Catalogue().elements.values():
        definition = found["definitions"].get(declared.word)
        for key in declared.fields:
            if key in declared.kind.fields:
                mapping = definition["anyOf"][1] if "anyOf" in definition else definition
                assert mapping["properties"][key]["description"]
            else:       # where it stands within some elements alone it is described there
                assert f'"{key}"' in json.dumps(found["definitions"][declared.within(key)[0]]["properties"])
            described += 1
    assert described >= 112
    assert {"title", "$schema", "additionalProperties"} <= set(found)
    for word in ("spring", "body", "slide", "part"):
        assert f"#/definitions/{word}" in json.dumps(found)
