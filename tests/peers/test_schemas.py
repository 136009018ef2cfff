"""Packages of QTI 2.1 against its published schemas, where these lie in a folder that VIBCLI_SCHEMAS names: each under
the way of its address, www.imsglobal.org/xsd/imsqti_v2p1.xsd and what it imports, www.imsglobal.org/xsd/imscp_v1p1.xsd.
"""

import os
from pathlib import Path
from zipfile import ZipFile

import pytest
from support.homework_scenes import EIGHTEEN, LETTERS

from vibcli.cli import run

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
def package(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("vibcli.homework.paper.find_spec", lambda name: None)
    for name, text in (("block", EIGHTEEN), ("letters", HOSTILE)):
        Path(f"{name}.yaml").write_text(text, encoding="utf-8")
    Path("set.yaml").write_text("title: Week 3 & 4\nproblems: [block.yaml, letters.yaml]\n", encoding="utf-8")
    Path("salt").write_text("a secret text", encoding="utf-8")
    assert run(["homework", "set.yaml", "-o", "out", "--export", "qti21", "--pool", "3", "--salt-file", "salt"]) == 0
    with ZipFile("out/instructor/qti21/package.zip") as files:
        return {name: files.read(name) for name in files.namelist() if name.endswith(".xml")}


def test_items_and_test_are_valid(package):
    known = schema("imsqti_v2p1.xsd")
    found = {name: data for name, data in package.items() if name != "imsmanifest.xml"}
    for name, data in found.items():
        known.assertValid(etree.fromstring(data))
        if name != "test.xml":
            assert not known.validate(etree.fromstring(data.replace(b"itemBody", b"itemBodies")))
    assert len(found) == 7


def test_the_manifest_is_valid(package):
    known = schema("imscp_v1p1.xsd")
    known.assertValid(etree.fromstring(package["imsmanifest.xml"]))
    assert not known.validate(etree.fromstring(package["imsmanifest.xml"].replace(b"href", b"to")))
