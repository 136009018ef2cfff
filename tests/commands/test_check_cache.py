"""`vibcli check` twice: what has not changed is taken from the cache, what has is not; nothing of it can mislead."""

import errno
import json
import os
import subprocess
import sys
import time
from pathlib import Path

import pytest
from support.checked import SCENE
from support.few_files import files_left

from vibcli.cli.checking import cache as caching
from vibcli.cli.program import run

RECORD = """
bodies: {a: {mass: 1 kg, slide: x}}
springs: {s: {k: 4 N/m, between: [ground, a]}}
records: {F: {file: push.csv, unit: N}}
forces: {f: {at: a, force: F(t)}}
answers:
  omega[1]: 2 rad/s
"""


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.delenv("VIBCLI_NO_CACHE")
    (tmp_path / "sets").mkdir()
    for name, text in (("a", SCENE.replace("MASS", "1")), ("b", SCENE.replace("MASS", "2")), ("c", "bodies: 1\n"),
                       ("d", SCENE.replace("MASS", "0")), ("e", RECORD)):
        (tmp_path / "sets" / f"{name}.yaml").write_text(text)
    (tmp_path / "sets" / "push.csv").write_text("0,0\n1,1\n")
    return tmp_path


def checked(capfd, *more):
    code = run(["check", "sets", *more])
    out, err = capfd.readouterr()
    *lines, last = out.splitlines()
    kept = last.partition(", ")[2] if "from the cache" in last else ""
    return (code, lines, err, last.split(" from the cache")[0].rpartition(" in ")[0]), (
        int(last.split(" of ")[-2].split()[-1]) if kept else 0)


@pytest.mark.sweep
def test_the_second_time_says_the_same(folder, capfd):
    first, kept = checked(capfd)
    again, taken = checked(capfd)
    assert first == again and (kept, taken) == (0, 5)
    assert checked(capfd, "--jobs", "2") == (first, 5)
    assert checked(capfd, "--no-cache") == (first, 0)
    assert (folder / ".vibcli_cache" / "CACHEDIR.TAG").read_text().startswith("Signature: 8a477f597d28d172789f06886806")
    assert (folder / ".vibcli_cache" / ".gitignore").read_text() == "*\n"


@pytest.mark.sweep
def test_forms_are_the_same_from_the_cache(folder, capfd):
    found = []
    for _ in range(2):
        for form in ("json", "junit", "sarif", "github"):
            run(["check", "sets", "--format", form])
            found.append(capfd.readouterr())
    assert found[:4] == found[4:]


@pytest.mark.sweep
def test_what_changes_is_checked_anew(folder, capfd, monkeypatch):
    checked(capfd)
    (folder / "sets" / "a.yaml").write_text(SCENE.replace("MASS", "3"))
    assert checked(capfd)[1] == 4
    (folder / "sets" / "push.csv").write_text("0,0\n1,2\n")
    assert checked(capfd)[1] == 4
    assert checked(capfd, "--patience", "2")[1] == 0
    assert checked(capfd)[1] == 5
    monkeypatch.setattr(caching, "_machinery", lambda folder: "another version")
    assert checked(capfd)[1] == 0


@pytest.mark.sweep
def test_another_version_of_a_package_is_checked_anew(folder, capfd, monkeypatch):
    checked(capfd)
    (folder / "packages" / "PyYAML-999.0.dist-info").mkdir(parents=True)
    monkeypatch.setattr(sys, "path", [str(folder / "packages"), *sys.path])
    assert checked(capfd)[1] == 0
    (folder / "packages" / "PyYAML-999.0.dist-info").rename(folder / "packages" / "pyyaml-999.1.dist-info")
    assert checked(capfd)[1] == 0
    assert checked(capfd)[1] == 5


def test_versions_are_those_that_python_knows():
    from importlib.metadata import version

    described = caching._described()
    for name in caching.COMPUTES_WITH:
        assert version(name) in caching._version(name, described)
        assert caching._version(name, {}) == version(name)
    assert caching._version("no-such-package", {}) == "–"


@pytest.mark.sweep
def test_reading_it_imports_little(folder):
    code = ("import sys; from vibcli.cli.program import run; run(['check', 'sets']); "
            "print(sorted({'importlib.metadata', 'tempfile', 'email', 'socket', 'numpy', 'yaml'} & set(sys.modules)))")
    for _ in range(2):
        out = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True).stdout
    assert out.splitlines()[-1] == "[]"


@pytest.mark.sweep
def test_a_record_that_comes_later_is_seen(folder, capfd):
    (folder / "sets" / "push.csv").unlink()
    (before, *_), _ = checked(capfd)
    assert before == 3
    (folder / "sets" / "push.csv").write_text("0,0\n1,1\n")
    _, kept = checked(capfd)
    run(["check", "sets/e.yaml"])
    assert kept == 4 and "✓ omega[1]" in capfd.readouterr().out


@pytest.mark.sweep
def test_a_damaged_entry_is_checked_anew_in_silence(folder, capfd):
    first, _ = checked(capfd)
    entries = sorted((folder / ".vibcli_cache").glob("*.json"))
    assert len(entries) == 5
    for entry, damage in zip(entries, (b"", b"{", b"[1]", b'{"form": 1, "sum": "", "entry": "{}"}', None), strict=True):
        if damage is None:
            data = json.loads(entry.read_text())
            damage = json.dumps(data | {"entry": data["entry"].replace("false", "true")}).encode()
        entry.write_bytes(damage)
    again, kept = checked(capfd)
    assert again == first and kept <= 1
    assert checked(capfd) == (first, 5)
    for one in (*entries[:2], folder / ".vibcli_cache" / "sources"):    # what has no end is not waited for
        one.unlink()
        os.mkfifo(one)
    assert checked(capfd) == (first, 3)
    assert checked(capfd) == (first, 5)


def test_a_fault_is_not_kept(folder, capfd, monkeypatch):
    import vibcli.check.verdicts as verdicts

    def broken(*args):
        raise RuntimeError("broken")

    with monkeypatch.context() as patch:
        patch.setattr(verdicts, "check", broken)
        assert run(["check", "sets/a.yaml"]) == 101
    capfd.readouterr()
    assert run(["check", "sets/a.yaml"]) == 0
    assert "from the cache" not in capfd.readouterr().out


def test_a_file_that_changes_meanwhile_is_not_kept(folder, capfd, monkeypatch):
    import vibcli.check.verdicts as verdicts

    whole = verdicts.check

    def slow(*args):
        found = whole(*args)
        (folder / "sets" / "a.yaml").write_text(SCENE.replace("MASS", "7"))
        return found

    with monkeypatch.context() as patch:
        patch.setattr(verdicts, "check", slow)
        assert run(["check", "sets/a.yaml"]) == 0
    assert run(["check", "sets/a.yaml"]) == 1


@pytest.mark.parametrize("make, said", [
    (lambda place: place.symlink_to("/tmp"), "it is a link"), (lambda place: place.write_text("x"), "File exists")])
def test_a_cache_that_cannot_be_used_is_said_and_left(folder, capfd, make, said):
    make(folder / ".vibcli_cache")
    (code, _, err, _), kept = checked(capfd)
    assert code == 3 and kept == 0 and "cannot keep results" in err and said in err


@pytest.mark.sweep
def test_few_files_that_may_be_opened_are_enough(folder, capfd):
    run(["check", "sets"])      # all is imported
    with files_left(2):
        (code, _, err, _), kept = checked(capfd, "--cache-dir", "new")
    assert code == 3 and kept == 0 and "warning" not in err and "of its own" not in err
    assert checked(capfd, "--cache-dir", "new")[1] == 5


def test_what_it_hangs_on_cannot_be_read(folder, capfd, monkeypatch):
    def closed(folder):
        raise OSError(errno.EMFILE, os.strerror(errno.EMFILE))

    monkeypatch.setattr(caching, "_machinery", closed)
    (code, _, err, _), kept = checked(capfd)
    assert code == 3 and kept == 0 and "cannot keep results: Too many open files; all is checked anew" in err


def test_jobs_that_cannot_be_begun_are_refused(folder, capfd):
    with files_left(6):
        assert run(["check", "sets", "--jobs", "2", "--no-cache"]) == 2
    assert "no process can be begun: Too many open files; leave --jobs out" in capfd.readouterr().err


@pytest.mark.sweep
def test_a_folder_of_others_is_no_cache(folder, capfd):
    """What makes it one would have git ignore all that lies in it."""
    before = {path.name for path in folder.iterdir()}
    for named in ("", ".", "sets"):
        (code, _, err, _), kept = checked(capfd, "--cache-dir", named)
        assert code == 3 and kept == 0 and "it holds other files; all is checked anew" in err
    assert {path.name for path in folder.iterdir()} == before
    (folder / "empty").mkdir()
    assert "warning" not in checked(capfd, "--cache-dir", "empty")[0][2]
    assert checked(capfd, "--cache-dir", "empty")[1] == 5


@pytest.mark.sweep
def test_two_at_once_leave_whole_entries(folder):
    command = [sys.executable, "-m", "vibcli", "check", "sets", "--quiet"]
    environment = {name: value for name, value in os.environ.items() if name != "VIBCLI_NO_CACHE"}
    both = [subprocess.Popen(command, env=environment, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
            for _ in range(2)]
    assert {process.communicate(timeout=300)[0] and process.returncode for process in both} == {3}
    entries = list((folder / ".vibcli_cache").glob("*.json"))
    assert len(entries) == 5 and all(json.loads(entry.read_text())["form"] == 1 for entry in entries)
    assert not list((folder / ".vibcli_cache").glob(".*.json.*"))


@pytest.mark.sweep
def test_nothing_is_computed_with_from_the_cache(folder):
    code = ("import sys; from vibcli.cli.program import run; run(['check', 'sets', '-q']); "
            "print([name for name in ('numpy', 'scipy', 'sympy', 'yaml', 'vibcli.results', 'vibcli.reader')"
            " if name in sys.modules])")
    environment = {name: value for name, value in os.environ.items() if name != "VIBCLI_NO_CACHE"}
    found = [subprocess.run([sys.executable, "-c", code], env=environment, capture_output=True, text=True,
                            check=False).stdout.splitlines()[-1] for _ in range(2)]
    assert "numpy" in found[0] and found[1] == "[]"


def test_the_folder_beside_the_first_path(tmp_path):
    found = [caching.folder_of([path]) for path in ("a/b", "a/b/c.yaml", ".", "..", "x", "../y", "/")]
    assert found == [Path(place) / ".vibcli_cache" for place in ("a", "a/b", ".", "..", ".", "..", "/")]


@pytest.mark.sweep
def test_last_times_are_known(folder, capfd):
    start = time.process_time()
    checked(capfd)
    kept = caching.Cache(folder / ".vibcli_cache", [[], 1])
    assert 0 < kept.seconds("sets/a.yaml") <= time.process_time() - start
    assert kept.seconds("sets/unknown.yaml") == 0


def test_sources_are_read_anew_where_they_look_changed(tmp_path, monkeypatch):
    (tmp_path / "room").mkdir()
    source, kept = tmp_path / "room" / "a.py", tmp_path / "kept"
    source.write_text("one = 1\n")
    monkeypatch.setattr(caching, "ROOT", tmp_path)
    first = caching._sources(kept)
    read = []
    monkeypatch.setattr(caching.Path, "read_bytes", lambda path: read.append(path) or b"")
    assert caching._sources(kept) == first and not read
    monkeypatch.undo()
    monkeypatch.setattr(caching, "ROOT", tmp_path)
    kept.write_text(kept.read_text().replace(first, first[::-1]))       # damaged: read anew
    assert caching._sources(kept) == first
    source.write_text("one = 11\n")
    changed = caching._sources(kept)
    assert changed != first
    (tmp_path / "room" / "b.py").write_text("")
    assert caching._sources(kept) not in (first, changed)


def test_of_an_installed_wheel_its_record_tells(tmp_path, monkeypatch):
    described, text = tmp_path / "vibcli-1.0.dist-info", "vibcli/__init__.py,a,1\nvibcli/cli/checking/cache.py,b,2\n"
    described.mkdir()
    assert caching._installed(str(described)) is caching._installed(None) is None
    (described / "RECORD").write_text(text)
    assert caching._installed(str(described)) is None       # another copy than this one
    monkeypatch.setattr(caching, "ROOT", tmp_path / "vibcli")
    monkeypatch.setattr(caching, "__file__", str(tmp_path / "vibcli" / "cli" / "checking" / "cache.py"))
    assert caching._installed(str(described)) == text
    (described / "RECORD").write_text("__editable__.vibcli.pth,a,1\n")
    assert caching._installed(str(described)) is None
    monkeypatch.undo()
    own = caching._installed(caching._described().get("vibcli"))
    assert own is None or caching.ROOT.parent.name == "site-packages"
