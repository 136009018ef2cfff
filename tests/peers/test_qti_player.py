"""Items of QTI 2.1 as a player that is not ours marks them, in Chromium: @citolab/qti-convert, @citolab/qti-components.

`make peers` installs both beside Python's packages, and has 100 variants of each problem played, as VIBCLI_PEERS_POOL
says, else three; a folder `node_modules` elsewhere is named by NODE_PATH.
"""

import html
import io
import json
import os
import shutil
import subprocess
import sys
from pathlib import Path
from zipfile import ZipFile

import pytest
from support.browser import BROWSER, NEEDED, QUIET
from support.exported import grades

from vibcli.cli.program import run

HERE, SETS = Path(__file__).parent, Path(__file__).parents[2] / "problems" / "sets"
MODULES = Path(os.environ.get("NODE_PATH") or Path(sys.prefix) / "peers" / "node_modules")
PLAYER = MODULES / "@citolab" / "qti-components" / "cdn" / "index.global.js"
POOL = int(os.environ.get("VIBCLI_PEERS_POOL", "3"))

pytestmark = [NEEDED, pytest.mark.sweep,
              pytest.mark.skipif(not PLAYER.exists(), reason="no @citolab/qti-components here: make peers"),
              pytest.mark.skipif(shutil.which("node") is None, reason="no node here")]


def played(package, answers, folder):
    """[(score of the key, [what is said])] of answers (item, letter, text), in their order."""
    with ZipFile(io.BytesIO(package)) as files:
        files.extractall(folder / "qti2")
    subprocess.run(["node", HERE / "convert.mjs", MODULES, folder / "qti2" / "items", folder / "qti3"], check=True,
                   capture_output=True, timeout=3000)
    items = {path.stem: path.read_text(encoding="utf-8") for path in (folder / "qti3").iterdir()}
    work = json.dumps({"items": items, "answers": answers}).replace("</", "<\\/")
    page = (HERE / "play.html").read_text(encoding="utf-8").replace("WORK", work)
    (folder / "play.html").write_text(page, encoding="utf-8")
    shutil.copy(PLAYER, folder)
    shown = subprocess.run([BROWSER, *QUIET, f"--user-data-dir={folder}/profile", "--virtual-time-budget=100000000",
                            "--dump-dom", (folder / "play.html").as_uri()], capture_output=True, text=True,
                           timeout=3000).stdout
    found = json.loads(html.unescape(shown.partition('<pre id="found">')[2].partition("</pre>")[0]))
    assert isinstance(found, list), found
    return found


def probes(key):
    """Key, both edges, a part in 10⁹ within and without, each mistake, the sign, the unit; none twice, as the player
    says nothing anew of the same answer."""
    value, band = key["value"], key["band"]
    numbers = [value, *(value + side * band * (1 + part) for side in (1, -1) for part in (0, 1e-9, -1e-9)),
               *(one["value"] for one in key["mistakes"]), -value]
    return list(dict.fromkeys([*map(repr, numbers), f"{value!r} kg", ""]))


@pytest.mark.parametrize("path", sorted(SETS.glob("*")), ids=lambda path: path.name)
def test_every_item_of_a_set_is_marked_as_by_grade(path, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("vibcli.homework.paper.find_spec", lambda name: None)
    Path("salt").write_text("a secret text", encoding="utf-8")
    assert run(["homework", str(path), "-o", "out", "--export", "qti21", "--pool", str(POOL), "--salt-file",
                "salt"]) == 0
    manifest = json.loads(Path("out/instructor/manifest.json").read_text(encoding="utf-8"))
    keys = {(one["name"], variant["variant"]): variant["keys"] for one in manifest["problems"]
            for variant in one["variants"]}
    asked = [(student["id"], letter, key, text) for student in manifest["students"] for sheet in student["sheets"]
             for letter, key in zip("abcdefgh", keys[sheet["problem"], sheet["variant"]], strict=False)
             if "value" in key for text in probes(key)]
    found = played(Path("out/instructor/qti21/package.zip").read_bytes(), [(*one[:2], one[3]) for one in asked],
                   tmp_path)
    print(f"{len(found)} verdicts")
    assert len(manifest["students"]) == POOL * len(manifest["problems"])
    assert len(found) == len(asked) >= 20 * len(manifest["students"])
    for (item, letter, key, text), (score, said) in zip(asked, found, strict=True):
        verdict, mistake = grades(key)(text)
        assert (score > 0) == (verdict == "right"), (item, letter, text)
        names = [one.removeprefix(f"({letter}) ").partition(": ")[0] for one in said]
        assert len(names) == bool(mistake) and set(names) <= alike(key, mistake), (item, letter, text)


def alike(key, mistake):
    """The mistakes that give what this one gives, but for rounding."""
    values = {one["name"]: one["value"] for one in key["mistakes"]}
    return {name for name, value in values.items() if mistake and abs(value - values[mistake]) <= 1e-12 * abs(value)}
