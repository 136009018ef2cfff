"""Words of a file in each format: read back as they are, neither markup nor formula, template or answer."""

import io
import json
import re
from html.parser import HTMLParser
from itertools import pairwise
from xml.etree import ElementTree
from zipfile import ZipFile

import pytest
from support import course_systems
from support.exported import manifest_key, on_disk, question, written

from vibcli.base.errors import PhysicsError
from vibcli.homework.exports.escaping import cdata
from vibcli.homework.exports.item import item_of, plain_name, require_own_names, whole_weights
from vibcli.homework.exports.told import bands_told

WORDS = ["<b>bold</b> & \"quotes\" 'so'", "]]> ends", "{{ params.x }} and {{{x}}}", "costs $5 and $6$ or $$7$$",
         r"\(x\) and \[y\] \ alone", "a lone } brace {", "{1:SHORTANSWER:=trap}", "{2:NUMERICAL:=1:0}",
         "x ~ y # z = 50%", "@@PLUGINFILE@@/x", "&amp; &#123; &lt;", "φ̈ → ∞ 𝔇", "<pl-number-input answers-name='a'>",
         "<!-- -->", "a`b|c"]
KEY = manifest_key(21.909, 0.11, {"weight": 22.6})


class Text(HTMLParser):
    """What is read of a page, and the tags that it has."""

    def __init__(self, page):
        super().__init__(convert_charrefs=True)
        self.text, self.tags = "", set()
        self.feed(page)
        self.close()

    def handle_starttag(self, tag, _):
        self.tags.add(tag)

    def handle_data(self, data):
        self.text += data


def pages(name, words, said):
    """(question, what is told of a mistake) in a format, as HTML, and all that its package holds."""
    files = written(name, [question("block-1", KEY, KEY, words=words, said={"weight": said})])
    if name == "moodle":
        one = list(ElementTree.fromstring(files["questions.xml"]).iter("question"))[1]
        return one.find("questiontext/text").text, None
    if name == "prairielearn":
        table = json.loads(files["questions/block/variants.jsonl"])
        return table["params"]["question"], table["params"]["mistakes"]["a"][0][2]
    with ZipFile(io.BytesIO(files["package.zip"])) as package:
        paths = [path for path in package.namelist() if path.endswith(".xml")]
        roots = [ElementTree.fromstring(package.read(path)) for path in paths]
    if name == "canvas":
        texts = [node.text for root in roots for node in root.iter() if node.tag.endswith("mattext")]
        return texts[0], texts[1]
    item = next(root for root in roots if root.tag.endswith("assessmentItem"))
    body = next(node for node in item.iter() if node.tag.endswith("itemBody"))
    feedback = next(node for node in item.iter() if node.tag.endswith("modalFeedback"))
    return ElementTree.tostring(body, "unicode"), ElementTree.tostring(feedback, "unicode")


@pytest.mark.parametrize("name", ["moodle", "prairielearn", "qti21", "canvas"])
@pytest.mark.parametrize("words", WORDS)
def test_words_are_read_back(name, words, tmp_path):
    asked, said = pages(name, words, words)
    plain = Text(asked)
    assert " ".join(words.split()) in " ".join(plain.text.split())
    assert not {"b", "pl-number-input"} & plain.tags
    if name != "qti21":         # there neither templates nor dollars mean anything
        head = asked.partition("</p>")[0].replace("\\(\\omega", "")
        assert not re.search(r"\{\{|\{\d*:|\$[^<]|\\[(\[]", head)
    if said is not None:
        assert " ".join(words.split()) in " ".join(Text(said).text.split())


@pytest.mark.parametrize("words", WORDS)
def test_what_is_said_ends_no_answer_of_a_cloze_question(words, tmp_path):
    files = written("moodle", [question("block-1", KEY, KEY, words=words, said={"weight": words})])
    fields = course_systems.moodle(files)["block-1"]
    for letter in "ab":
        assert fields[letter]("21.909") == ("right", "")
        verdict, told = fields[letter]("22.6")
        assert verdict == "wrong" and " ".join(words.split()) in " ".join(told.split())
        assert fields[letter]("30") == ("wrong", "")
    assert len(fields) == 2


def test_the_end_of_a_section_without_markup_is_divided():
    for text in ("a]]>b", "]]>", "]]]]>>", "]]>]]>"):
        assert ElementTree.fromstring(f"<a>{cdata(text)}</a>").text == text


def test_names_of_items():
    assert item_of("lever", 16) == "lever-17"
    odd = ["1_lever", "Hebel ü", "a b", "a_b", "x" * 80, "Hebel ö"]
    found = [plain_name(name) for name in odd]
    assert len(set(found)) == len(odd) and all(re.fullmatch(r"[A-Za-z_][A-Za-z0-9_.-]*", name) for name in found)
    assert plain_name("a_b") == "a_b"


def test_names_of_problems_never_meet():
    """Neither that of what is marked by hand, nor one that was made, is taken by another problem."""
    made = plain_name("b c")
    names = ["block", "block-by-hand", "Block-By-Hand", "block-by-hand-by-hand", "b c", made, plain_name(made)]
    groups = [plain_name(name) + end for name in names for end in ("", "-by-hand")]
    assert len({group.casefold() for group in groups}) == len(groups)
    require_own_names(names)
    same = ["x" * 64 + number for number in ("43714", "100683")]       # of one hash
    with pytest.raises(PhysicsError, match="would have one name in packages, q_x"):
        require_own_names(same)
    with pytest.raises(PhysicsError, match="'lever' and 'Lever' would have one name"):
        require_own_names(["lever", "Lever"])


def test_weights_are_whole_in_the_ratio_of_points():
    assert whole_weights([2.0, 1.0]) == [2, 1] and whole_weights([1.5, 1.0]) == [3, 2]
    assert whole_weights([1 / 3, 2 / 3, 1]) == [1, 2, 3]


def test_attached_files_and_figures_stand_in_each_package(tmp_path):
    one = question("block-1", KEY)._replace(files={"quake.csv": b"t,a\n0,1\n"})
    assert b"quake.csv" in written("moodle", [one])["questions.xml"]
    assert written("prairielearn", [one])["questions/block/clientFilesQuestion/quake.csv"] == b"t,a\n0,1\n"
    for name in ("qti21", "canvas"):
        with ZipFile(io.BytesIO(written(name, [one])["package.zip"])) as package:
            assert package.read("files/block/quake.csv") == b"t,a\n0,1\n"
            assert b"files/block/quake.csv" in package.read("imsmanifest.xml")
    odd = one._replace(files={"at 5%, #2?.csv": b"1"})
    assert b'/at%205%25%2C%20%232%3F.csv">at 5%, #2?.csv</a>' in written("moodle", [odd])["questions.xml"]
    assert on_disk({"a/b": b"c"}, tmp_path).joinpath("a/b").read_bytes() == b"c"


@pytest.mark.parametrize("wrong", [10.3, 10.6, 9.2, 10.9])
def test_no_band_of_a_mistake_meets_that_of_the_key(wrong):
    right, *others = bands_told(manifest_key(10.0, 0.5, {"one": wrong, "other": wrong + 0.2}, "m"))
    assert right[:2] == pytest.approx((9.5, 10.5)) and others
    assert all(one.low < one.high and (one.high <= right.low or one.low >= right.high) for one in others)
    assert all(one.high <= other.low for one, other in pairwise(sorted(others)))


def test_the_right_response_of_qti_is_the_key():
    with ZipFile(io.BytesIO(written("qti21", [question("block-1", KEY)])["package.zip"])) as package:
        item = package.read("items/block-1.xml").decode()
    assert f"<correctResponse><value>{KEY['value']!r}</value></correctResponse>" in item
