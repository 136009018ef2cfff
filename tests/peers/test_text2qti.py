"""Packages for Canvas have the structure of those that `text2qti` writes, which Canvas is known to import."""

import io
from xml.etree import ElementTree
from zipfile import ZipFile

import pytest
from support.exported import manifest_key, question, written

pytest.importorskip("text2qti", reason="no text2qti here: make peers")
QUIZ = """Quiz title: Week 3

GROUP
pick: 1
points per question: 2

1.  A block on a spring.
-   Known mistakes
=   [21.8, 22.02]

END_GROUP

GROUP
pick: 1
points per question: 2

1.  A block in letters.
____

END_GROUP
"""


def theirs():
    from text2qti.config import Config
    from text2qti.qti import QTI
    from text2qti.quiz import Quiz

    config = Config()
    config.load()
    return QTI(Quiz(QUIZ, config=config)).zip_bytes()


def ours():
    key = manifest_key(21.909, 0.11, {"weight": 22.6})
    return written("canvas", [question("block-1", key), question("block-1-by-hand", key, by_hand=True,
                                                                 group="block-by-hand")])["package.zip"]


def skeleton(node):
    """Tags and attributes' names with those below, and what tells a kind of question."""
    tag = node.tag.rpartition("}")[2]
    told = node.text if tag in ("fieldlabel", "selection_number") or (tag == "fieldentry" and "question" in (
        node.text or "") and "-" not in node.text and "text2qti" not in node.text) else ""
    return tag, tuple(sorted(name.rpartition("}")[2] for name in node.attrib)), told, tuple(map(skeleton, node))


def roots(data):
    """{kind of file: its root}."""
    with ZipFile(io.BytesIO(data)) as package:
        found = {}
        for path in package.namelist():
            if path.endswith(".xml"):
                root = ElementTree.fromstring(package.read(path))
                found[root.tag.rpartition("}")[2]] = root
        return found


def test_assessments_are_built_alike():
    one, other = roots(theirs()), roots(ours())
    assert set(one) == set(other) == {"manifest", "quiz", "questestinterop"}
    assert skeleton(other["questestinterop"]) == skeleton(one["questestinterop"])


def test_resources_and_settings_are_some_of_theirs():
    one, other = roots(theirs()), roots(ours())
    assert {node.tag for node in other["quiz"].iter()} <= {node.tag for node in one["quiz"].iter()}
    types = [[(node.get("type"), len(node)) for node in root["manifest"].iter() if node.tag.endswith("resource")]
             for root in (one, other)]
    assert types[0] == types[1]
