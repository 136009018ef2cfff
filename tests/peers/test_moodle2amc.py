"""Moodle XML as `moodle2amc` of amc2moodle reads it: question, category, key, and band to the digits that it keeps."""

import sys
from contextlib import contextmanager
from types import ModuleType

import pytest
from support.exported import COURSE, manifest_key, question, written

pytest.importorskip("amc2moodle", reason="no amc2moodle here: make peers")
KEYS = [manifest_key(21.909, 0.11, {"cycles": 3.4869, "weight": 22.6}), manifest_key(-3.5127, 0.0176, {"sign": 3.5127}),
        manifest_key(0.00123456, 6.2e-6), manifest_key(87654.3, 440.0, {"near": 89000.0}), manifest_key(7.0, 0.035)]


@contextmanager
def without_pictures():
    """Pictures are changed by ImageMagick, which need not be here: none is shown."""
    try:
        import wand.image  # noqa: F401
    except ImportError:
        packages = ModuleType("wand"), ModuleType("wand.image")
        packages[1].Image = None
        sys.modules["wand"], sys.modules["wand.image"] = packages
        try:
            yield
        finally:
            del sys.modules["wand"], sys.modules["wand.image"]
    else:
        yield


def test_questions_categories_keys_and_bands(tmp_path):
    with without_pictures():
        from amc2moodle.moodle2amc._quiz import Quiz

    asked = [question(f"block-{i}", key) for i, key in enumerate(KEYS, 1)]
    path = tmp_path / "questions.xml"
    path.write_bytes(written("moodle", asked, COURSE._replace(title="Week 3"))["questions.xml"])
    found, categories = Quiz(str(path))._reshape()
    assert list(categories.values()) == [len(KEYS)] and "Week 3" in next(iter(categories))
    read = found.findall("question")
    assert [one.get("qname").partition(":")[0] for one in read] == [one.item for one in asked]
    for one, key in zip(read, KEYS, strict=True):
        assert "A block on a spring." in one.find("text").text
        choices = one.find("AMCnumericChoices")
        assert float(choices.get("target")) == key["value"]
        kept = dict(part.strip().split(" = ") for part in choices.text.split(","))
        unit = 10.0 ** -int(kept["decimals"])
        assert abs(int(kept["exact"]) * unit - key["band"]) <= 0.5 * unit * (1 + 1e-9)
