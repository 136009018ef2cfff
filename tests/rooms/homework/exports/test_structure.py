"""What published definitions say of packages, written down from these: of QTI 1.2 (IMS, ims_qtiasiv1p2.dtd) and of
quizzes (Canvas, cccv1p0.xsd) the parts that are used, of Moodle XML, for which there is no schema, what its importer
reads (question/format/xml/format.php). tests/peers/test_schemas.py holds packages against the definitions
themselves."""

import io
import re
from collections import Counter
from pathlib import PurePosixPath
from xml.etree import ElementTree
from zipfile import ZipFile

import pytest
from support.exported import manifest_key, question, written

KEY = manifest_key(21.909, 0.11, {"weight": 22.6})
ASKED = [question("block-1", KEY)._replace(files={"quake.csv": b"0,1\n"}), question("drum-1", KEY, KEY, group="drum"),
         question("block-1-by-hand", KEY, by_hand=True, group="block-by-hand")]
TEXT = ""
QTI = {     # {element: (what stands in it, in order; attributes it needs, {others: values})}
    "questestinterop": ("assessment ", (), {}),
    "assessment": ("(qtimetadata )*(section )+", ("ident",), {"title": ".+"}),
    "qtimetadata": ("(qtimetadatafield )+", (), {}), "qtimetadatafield": ("fieldlabel fieldentry ", (), {}),
    "section": ("(selection_ordering )?((item )*|(section )*)", ("ident",), {"title": ".+"}),
    "selection_ordering": ("(selection )*", (), {}),
    "selection": ("(selection_number )?(selection_extension )?", (), {}),
    "selection_extension": ("points_per_item ", (), {}),        # which is Canvas's own
    "item": ("(itemmetadata )?(presentation )?(resprocessing )*(itemfeedback )*", ("ident",), {"title": ".+"}),
    "itemmetadata": ("(qtimetadata )*", (), {}), "presentation": ("(material |response_str )+", (), {}),
    "material": ("(mattext )+", (), {}), "mattext": (TEXT, (), {"texttype": "text/.+"}),
    "response_str": ("render_fib ", ("ident",), {"rcardinality": "Single|Multiple|Ordered"}),
    "render_fib": ("(response_label )*", (), {"fibtype": "String|Integer|Decimal|Scientific"}),
    "response_label": (TEXT, ("ident",), {"rshuffle": "Yes|No"}),
    "resprocessing": ("outcomes (respcondition )+", (), {}), "outcomes": ("(decvar )+", (), {}),
    "decvar": (TEXT, (), {"varname": ".+", "vartype": "Integer|String|Decimal|Scientific|Boolean|Enumerated|Set",
                          "minvalue": ".+", "maxvalue": ".+"}),
    "respcondition": ("conditionvar (setvar )*(displayfeedback )*", (), {"continue": "Yes|No"}),
    "conditionvar": ("(other |vargte |varlte )+", (), {}), "other": (TEXT, (), {}),
    "vargte": (TEXT, ("respident",), {}), "varlte": (TEXT, ("respident",), {}),
    "setvar": (TEXT, (), {"varname": ".+", "action": "Set|Add|Subtract|Multiply|Divide"}),
    "displayfeedback": (TEXT, ("linkrefid",), {"feedbacktype": "Response|Solution|Hint"}),
    "itemfeedback": ("(flow_mat |material )+", ("ident",), {}), "flow_mat": ("(material )+", (), {}),
    **dict.fromkeys(("fieldlabel", "fieldentry", "selection_number", "points_per_item"), (TEXT, (), {})),
}
BOOLEAN, NUMBER = "true|false", r"-?\d+(\.\d+)?"
QUIZ = {"title": ".*", "description": ".*", "shuffle_answers": BOOLEAN, "hide_results": ".*", "points_possible": NUMBER,
        "scoring_policy": "keep_latest|keep_highest", "quiz_type": "practice_quiz|assignment|graded_survey|survey",
        "show_correct_answers": BOOLEAN, "allowed_attempts": r"-?\d+", "available": BOOLEAN}
HEAD = {"name", "questiontext", "generalfeedback", "defaultgrade", "penalty", "hidden", "idnumber"}
MOODLE = {"category": {"category", "info", "idnumber"}, "cloze": HEAD,
          "numerical": HEAD | {"answer", "unitgradingtype", "unitpenalty", "showunits", "unitsleft"},
          "essay": HEAD | {"responseformat", "responserequired", "responsefieldlines", "attachments",
                           "attachmentsrequired", "graderinfo"}}


def name(node):
    return node.tag.rpartition("}")[2]


def wrong_in(node):
    """What is against the table in an element and below it."""
    children, needed, others = QTI.get(name(node), (None, (), {}))
    if children is None or not re.fullmatch(children, "".join(f"{name(one)} " for one in node)):
        yield name(node)
    own = {key: value for key, value in node.attrib.items() if "}" not in key}
    yield from (f"{name(node)}: {key}" for key in set(needed) - set(own))
    yield from (f"{name(node)}: {key}" for key, value in own.items()
                if key not in needed and not re.fullmatch(others.get(key, "-"), value))
    for one in node:
        yield from wrong_in(one)


@pytest.fixture(scope="module")
def canvas():
    """{path: bytes} of a package."""
    with ZipFile(io.BytesIO(written("canvas", ASKED)["package.zip"])) as files:
        return {path: files.read(path) for path in files.namelist()}


def quiz_of(canvas):
    return next(data for path, data in canvas.items() if b"<questestinterop" in data and path.endswith(".xml"))


def test_quizzes_for_canvas_are_built_as_qti_says(canvas):
    quiz = quiz_of(canvas)
    assert list(wrong_in(ElementTree.fromstring(quiz))) == []
    seen = {name(node) for node in ElementTree.fromstring(quiz).iter()}
    assert seen == set(QTI)
    for one, other in ((b"itemfeedback", b"feedbacks"), (b'"Decimal"', b'"Float"'), (b"respident", b"ident"),
                       (b"selection_extension", b"selection_metadata"), (b'continue="No"', b'continue="no"')):
        assert list(wrong_in(ElementTree.fromstring(quiz.replace(one, other)))), one


def test_what_quizzes_for_canvas_refer_to_is_there(canvas):
    root = ElementTree.fromstring(quiz_of(canvas))
    idents = Counter(node.get("ident") for kind in ("item", "section", "assessment") for node in root.iter()
                     if name(node) == kind)
    assert idents.most_common(1)[0][1] == 1 and len(idents) >= 8
    for item in (node for node in root.iter() if name(node) == "item"):
        given = {kind: {node.get("ident") for node in item.iter() if name(node) == kind}
                 for kind in ("response_str", "itemfeedback")}
        assert {node.get("respident") for node in item.iter() if node.get("respident")} <= given["response_str"]
        assert {node.get("linkrefid") for node in item.iter() if node.get("linkrefid")} == given["itemfeedback"]
    manifest = ElementTree.fromstring(canvas["imsmanifest.xml"])
    resources = {node.get("identifier"): node for node in manifest.iter() if name(node) == "resource"}
    assert {node.get("identifierref") for node in manifest.iter() if name(node) == "dependency"} <= set(resources)
    named = [node.get("href") for node in manifest.iter() if name(node) == "file"]
    assert sorted(named) == sorted(set(canvas) - {"imsmanifest.xml"})
    assert all(not PurePosixPath(path).is_absolute() and ".." not in path for path in named)


def test_settings_of_quizzes_are_those_that_canvas_knows(canvas):
    meta = ElementTree.fromstring(next(data for path, data in canvas.items() if path.endswith("assessment_meta.xml")))
    found = {name(node): node.text or "" for node in meta}
    assert len(found) == len(meta) and set(found) == set(QUIZ)
    assert all(re.fullmatch(QUIZ[key], text) for key, text in found.items())
    assert meta.get("identifier") == ElementTree.fromstring(quiz_of(canvas))[0].get("ident")


def test_moodle_reads_all_that_its_questions_hold():
    """No element is passed over, each text is where it is looked for, and each file has a name and base64."""
    quiz = ElementTree.fromstring(written("moodle", ASKED)["questions.xml"])
    assert quiz.tag == "quiz" and {node.get("type") for node in quiz} == set(MOODLE)
    for node in quiz:
        kind, counted = node.get("type"), Counter(one.tag for one in node)
        assert set(counted) <= MOODLE[kind], kind
        assert all(count == 1 for tag, count in counted.items() if tag != "answer")
        for path in ("name", "questiontext", "generalfeedback", "info", "graderinfo", "answer", "answer/feedback"):
            assert all(one.find("text") is not None for one in node.findall(path))
        assert all(one.get("format", "html") in ("html", "moodle_auto_format") for one in node.iter())
        for answer in node.findall("answer"):
            assert {one.tag for one in answer} == {"text", "tolerance", "feedback"}
            assert 0 <= float(answer.get("fraction")) <= 100 and float(answer.find("tolerance").text) >= 0
        for file in node.iter("file"):
            assert file.get("name") and file.get("encoding") == "base64"
    assert list(quiz.iter("file"))
