"""Packages against published schemas, where these lie in a folder that VIBCLI_SCHEMAS names: each under the way of its
address, www.imsglobal.org/xsd/imsqti_v2p1.xsd and what it imports, imscp_v1p1.xsd and ims_qtiasiv1p2.dtd beside it, and
canvas.instructure.com/xsd/cccv1p0.xsd, which stands as lib/cc/xsd/cccv1p0.xsd in the sources of Canvas.

Their licences do not let us keep them; what they say of the packages for Canvas is a table in
tests/rooms/homework/exports/test_structure.py. Moodle publishes no schema.
"""

import os
from pathlib import Path
from zipfile import ZipFile

import pytest
from support.homework_scenes import EIGHTEEN, LETTERS

from vibcli.cli.program import run

etree = pytest.importorskip("lxml.etree", reason="no lxml here: make peers")
SCHEMAS = Path(os.environ.get("VIBCLI_SCHEMAS", ""))
HOST = SCHEMAS / "www.imsglobal.org" / "xsd"
HOSTILE = LETTERS.replace("in letters", 'in <letters> & "signs" ]]> {{ $').replace("spring {k}.", "spring {k}, 1 < 2.")


class Beside(etree.Resolver):
    """What schemas import, taken from the folder."""

    def resolve(self, url, public, context):
        found = SCHEMAS / url.partition("://")[2]
        return self.resolve_filename(str(found), context) if "://" in url and found.is_file() else None


def schema(name):
    if not (HOST / name).is_file():
        pytest.skip(f"no {name} under VIBCLI_SCHEMAS")
    parser = etree.XMLParser(no_network=True)
    parser.resolvers.add(Beside())
    return etree.XMLSchema(etree.parse(str(HOST / name), parser))


@pytest.fixture
def packages(tmp_path, monkeypatch):
    """(format) ↦ {name: bytes} of the XML in a package of two problems, one in letters."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("vibcli.homework.paper.find_spec", lambda name: None)
    for name, text in (("block", EIGHTEEN), ("letters", HOSTILE)):
        Path(f"{name}.yaml").write_text(text, encoding="utf-8")
    Path("set.yaml").write_text("title: Week 3 & 4\nproblems: [block.yaml, letters.yaml]\n", encoding="utf-8")
    Path("salt").write_text("a secret text", encoding="utf-8")
    assert run(["homework", "set.yaml", "-o", "out", "--export", "qti21", "--export", "canvas", "--pool", "3",
                "--salt-file", "salt"]) == 0

    def written(name):
        with ZipFile(f"out/instructor/{name}/package.zip") as files:
            return {path: files.read(path) for path in files.namelist() if path.endswith(".xml")}
    return written


@pytest.mark.sweep
def test_items_and_test_are_valid(packages):
    known = schema("imsqti_v2p1.xsd")
    found = {name: data for name, data in packages("qti21").items() if name != "imsmanifest.xml"}
    for name, data in found.items():
        known.assertValid(etree.fromstring(data))
        if name != "test.xml":
            assert not known.validate(etree.fromstring(data.replace(b"itemBody", b"itemBodies")))
    assert len(found) == 7


@pytest.mark.sweep
@pytest.mark.parametrize("name", ["qti21", "canvas"])
def test_the_manifest_is_valid(packages, name):
    """That of Canvas but for its namespace, which is that of Common Cartridge."""
    known = schema("imscp_v1p1.xsd")
    data = packages(name)["imsmanifest.xml"].replace(b"imsccv1p1/imscp_v1p1", b"imscp_v1p1")
    known.assertValid(etree.fromstring(data))
    assert not known.validate(etree.fromstring(data.replace(b"href", b"to")))


@pytest.mark.sweep
def test_quizzes_for_canvas_are_valid_but_for_its_own_extension(packages):
    """In the definition of QTI 1.2 `selection_extension` may hold anything that is declared: `points_per_item` is
    Canvas's own, and all that is not."""
    path = HOST / "ims_qtiasiv1p2.dtd"
    if not path.is_file():
        pytest.skip("no ims_qtiasiv1p2.dtd under VIBCLI_SCHEMAS")
    known = etree.DTD(str(path))
    quiz, = (data for name, data in packages("canvas").items() if data.find(b"questestinterop") > 0)
    for text, valid in ((quiz, True), (quiz.replace(b"itemfeedback", b"feedbacks"), False),
                        (quiz.replace(b' ident="', b' name="'), False)):
        known.validate(bare(text))
        found = {error.message for error in known.error_log.filter_from_errors()}
        assert (found == {"No declaration for element points_per_item"}) is valid


def bare(data):
    """An XML without namespaces, of which these definitions know nothing."""
    root = etree.fromstring(data)
    for node in root.iter():
        node.tag = etree.QName(node).localname
        for name in [name for name in node.attrib if "}" in name]:
            del node.attrib[name]
    etree.cleanup_namespaces(root)
    return root


@pytest.mark.sweep
def test_the_settings_of_a_quiz_are_valid(packages):
    """By what Canvas's own schema says of `quiz`; as a whole that schema is not valid itself."""
    path = SCHEMAS / "canvas.instructure.com" / "xsd" / "cccv1p0.xsd"
    if not path.is_file():
        pytest.skip("no cccv1p0.xsd under VIBCLI_SCHEMAS")
    whole = etree.parse(str(path)).getroot()
    for node in [node for node in whole if node.get("name") != "quiz"]:
        whole.remove(node)
    for node in whole.xpath("//*[@type='assignmentType']"):
        node.getparent().remove(node)
    known = etree.XMLSchema(whole)
    meta, = (data for name, data in packages("canvas").items() if name.endswith("assessment_meta.xml"))
    known.assertValid(etree.fromstring(meta))
    assert not known.validate(etree.fromstring(meta.replace(b"keep_highest", b"keep_best")))
