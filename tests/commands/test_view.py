"""The page that follows a file: what it serves and to whom, what it solves anew, what an edit and an interrupt do."""

import json
import os
import re
import signal
import socket
import subprocess
import sys
import time
from contextlib import contextmanager
from html import unescape
from http.client import HTTPConnection
from pathlib import Path

import pytest
from support.browser import BROWSER, NEEDED, QUIET, dom, measured
from support.imported import modules

from vibcli.cli.program import run
from vibcli.cli.viewing.following import Asked, Following
from vibcli.cli.viewing.page import page
from vibcli.cli.viewing.server import serving
from vibcli.cli.viewing.shown import Shown, State
from vibcli.cli.viewing.solver import Job, solved

SCENE = """\
title: A block & <b>its</b> spring
parameters: {m: 2 kg, k: 800 N/m}
bodies: {b: {mass: m, slide: x}}
springs: {s: {k: k, between: [ground, b]}}
"""
CASES = SCENE + "cases:\n  stiff: {parameters: {k: 900 N/m}}\n  soft: {parameters: {k: 50 N/m}}\n"
BROKEN = SCENE.replace("mass: m", "mass: mm")
SLOW = "bodies:\n" + "".join(f"  b{i}: {{mass: {i + 1} kg, slide: x{i}}}\n" for i in range(60)) + (
    "springs:\n") + "".join(
    f"  s{i}: {{k: {7 + i} N/m, between: [b{i}, b{(7 * i + 3) % 60}]}}\n" for i in range(60) if i != (7 * i + 3) % 60)


@pytest.fixture(autouse=True)
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)


# who is answered, and with what

@pytest.fixture
def served():
    """(port, what is shown) of a server in this process."""
    shown = Shown("scene.yaml")
    shown.show(title="<i>T</i>", parts=("<p>one</p>", "<p>two</p>"))
    with serving(shown, 0) as address:
        yield int(re.fullmatch(r"http://127\.0\.0\.1:(\d+)/", address)[1]), shown


def asked(port, path, method="GET", **headers):
    """(status, headers, text) of a request."""
    connection = HTTPConnection("127.0.0.1", port, timeout=300)
    connection.request(method, path, headers=headers)
    answer = connection.getresponse()
    return answer.status, answer.headers, answer.read().decode()


def test_the_page_can_be_read_without_its_script(served):
    status, headers, text = asked(served[0], "/")
    assert status == 200 and "<p>one</p>" in text and "&lt;i&gt;T&lt;/i&gt;" in text and "<i>T" not in text
    assert headers["X-Content-Type-Options"] == "nosniff" and headers["Access-Control-Allow-Origin"] is None
    policy, nonce = headers["Content-Security-Policy"], re.search('<script nonce="(.*?)">', text)[1]
    assert "default-src 'none'" in policy and f"script-src 'nonce-{nonce}'" in policy and "http" not in policy


def test_nothing_of_the_page_is_loaded_from_elsewhere():
    text = page(State(3, "t", ("<p>one</p>",), ("<script>x</script>",), "w"), "n")
    text = re.sub(r'url\("data:font/woff;base64,[\w+/=]+"\)', "", text)
    assert not re.search(r"https?:|//\w|\bsrc=|\bhref=|@import|url\(", text)
    assert "&lt;script&gt;x" in text and text.count("<script") == 1


@pytest.mark.parametrize("headers", [
    {"Host": "evil.example"}, {"Host": "evil.example:80"}, {"Host": "127.0.0.1"}, {"Host": ""},
    {"Host": "127.0.0.1:1"}, {"Origin": "http://evil.example"}, {"Origin": "null"}])
@pytest.mark.parametrize("path", ["/", "/content?after=0"])
def test_who_asks_for_another_host_is_refused(served, path, headers):
    status, _, text = asked(served[0], path, **headers)
    assert status == 403 and "one" not in text


def test_own_names_are_answered(served):
    for host in ("127.0.0.1", "localhost"):
        own = f"{host}:{served[0]}"
        assert asked(served[0], "/", Host=own, Origin=f"http://{own}")[0] == 200


@pytest.mark.parametrize("path", ["/etc/passwd", "/../../etc/passwd", "/scene.yaml", "/%2e%2e/x", "/content/", "/."])
def test_no_path_reaches_a_file(served, path):
    Path("scene.yaml").write_text(SCENE)
    assert asked(served[0], path)[::2] == (404, "there is nothing here")


@pytest.mark.parametrize("method", ["POST", "PUT", "DELETE", "OPTIONS"])
def test_nothing_can_be_sent(served, method):
    assert asked(served[0], "/", method)[0] == 501


def test_only_this_machine_is_served(served):
    with socket.socket() as other:
        other.settimeout(2)
        assert other.connect_ex(("127.0.0.2", served[0])) != 0


@pytest.mark.parametrize("after", ["", "after=x", "after=-1", "after=" + "9" * 40, "before=1"])
def test_an_odd_version_gets_the_present_one(served, after):
    assert json.loads(asked(served[0], f"/content?{after}")[2])["parts"] == ["<p>one</p>", "<p>two</p>"]


def test_who_waits_is_told_of_news(served):
    port, shown = served
    connection = HTTPConnection("127.0.0.1", port, timeout=300)
    connection.request("GET", f"/content?after={shown.state.version}")
    shown.show(title="<i>T</i>")        # no news
    shown.show(work="solving …")
    assert json.loads(connection.getresponse().read())["work"] == "solving …"


# what is solved

class Counting:
    """A solver that finds at once, and counts."""

    def __init__(self):
        self.jobs, self.busy, self.stopped = [], False, 0

    def start(self, job):
        self.jobs.append(job.case)
        self.busy = True

    def found(self, seconds):
        self.busy = False
        return f"<p>{len(self.jobs)}</p>", []

    def stop(self):
        self.stopped += 1
        self.busy = False


@pytest.fixture
def following():
    return followed(CASES)


def followed(text):
    Path("scene.yaml").write_text(text)
    found = Following(Asked("scene.yaml", (), None, 1), Shown("scene.yaml"))
    found.solver = Counting()
    return found


def settled(following, text=None):
    """The cases that are solved once the file has this text."""
    if text is not None:
        Path("scene.yaml").write_text(text)
    before = len(following.solver.jobs)
    following.look()
    for _ in range(5):
        following.work(0)
    return following.solver.jobs[before:]


def test_what_changed_is_solved_and_nothing_else(following):
    assert settled(following) == [None, "stiff", "soft"]
    assert settled(following) == []
    assert settled(following, "# a remark\n" + CASES.replace("stiff: {", "stiff:   {") + "\n") == []
    assert settled(following, CASES.replace("900", "901")) == ["stiff"]
    assert settled(following, CASES) == []         # known from before
    assert settled(following, CASES.replace("50 N/m", "60 N/m") + "    # so\n") == ["soft"]
    assert settled(following, CASES.replace("2 kg", "3 kg")) == [None, "stiff", "soft"]
    assert settled(following, CASES + "answers: {stable: true}\n") == [None]
    assert following.shown.state.errors == () and len(following.shown.state.parts) == 3


def test_records_beside_are_followed_too():
    Path("a.csv").write_text("t,a\n0,0\n1,2\n")
    following = followed(SCENE.replace("m: 2 kg,", "m: 2 kg,")
                         + "records: {r: {file: a.csv, unit: N}}\nforces: {f: {at: b, force: r(t)}}\n")
    assert settled(following) == [None] and settled(following) == []
    Path("a.csv").write_text("t,a\n0,0\n1,20\n")
    assert settled(following) == [None]


def test_an_error_is_shown_and_gone_after_the_next_edit(following):
    settled(following)
    parts = following.shown.state.parts
    assert settled(following, BROKEN) == []
    error, = following.shown.state.errors
    assert "scene.yaml:3:" in error and "^^" in error and "unknown name 'mm'" in error
    assert following.shown.state.parts == parts
    assert settled(following, CASES) == [] and following.shown.state.errors == ()
    os.remove("scene.yaml")
    settled(following)
    assert "no such file" in following.shown.state.errors[0]
    settled(following, CASES)
    assert following.shown.state.errors == () and following.shown.state.parts == parts


def test_work_on_what_has_changed_meanwhile_is_broken_off(following):
    following.look()
    following.solver.found = lambda seconds: None
    following.work(0)
    assert following.solver.busy and following.shown.state.work == "solving: 0 of 3 are there …"
    Path("scene.yaml").write_text(BROKEN)
    following.look()
    assert following.solver.stopped == 0        # it may be mended by a letter
    Path("scene.yaml").write_text(SCENE.replace("2 kg", "9 kg"))
    following.look()
    assert following.solver.stopped == 1


def test_a_part_has_report_figure_and_moving_modes():
    html, errors = solved(Job(SCENE.encode(), "scene.yaml", ("k=200",), None, 0, 1))
    assert errors == [] and "<math" in html and "10</td>" in html and "<animate" in html
    assert "A block &amp; &lt;b&gt;its&lt;/b&gt; spring" in html


def test_what_cannot_be_solved_says_why():
    falling = ("parameters: {m: 2 kg}\nbodies: {b: {mass: m, at: [0, 0], slide: {along: [0, 1], by: x}}}\n"
               "gravity: 9.81 m/s^2\nfind: [frequencies]\n")
    html, _ = solved(Job(falling.encode(), "scene.yaml", (), None, 0, 1))
    assert "Not found:" in html


# the command

@contextmanager
def viewing(text):
    """(process, port) of the command on a file of this text."""
    Path("scene.yaml").write_text(text)
    process = subprocess.Popen([sys.executable, "-m", "vibcli", "view", "scene.yaml", "--no-open"],
                               stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    try:
        yield process, int(process.stdout.readline().rpartition(":")[2].strip(" /\n"))
    finally:
        if process.poll() is None:
            process.kill()
        process.communicate()


def until(port, holds):
    """The content of the page as soon as something holds of it."""
    version, end = -1, time.monotonic() + 120
    while time.monotonic() < end:
        found = json.loads(asked(port, f"/content?after={version}")[2])
        if holds(found):
            return found
        version = found["version"]
    raise AssertionError(found)


def interrupted(process):
    """(exit code, stderr) after an interrupt of the process alone; the one that solves has ended with it."""
    children = Path(f"/proc/{process.pid}/task/{process.pid}/children")
    others = children.read_text().split() if children.exists() else []
    process.send_signal(signal.SIGINT)
    _, said = process.communicate(timeout=300)
    time.sleep(0.1)
    assert not [child for child in others if "spawn" in _command(child)]
    return process.returncode, said.strip()


def _command(pid):
    try:
        return Path(f"/proc/{pid}/cmdline").read_text()
    except OSError:
        return ""


@pytest.mark.sweep
def test_the_file_is_followed_from_outside():
    with viewing(SCENE) as (process, port):
        assert "ω" in "".join(until(port, lambda found: found["parts"])["parts"])
        Path("scene.yaml").write_text(BROKEN)
        assert "^" in until(port, lambda found: found["errors"])["errors"][0]
        Path("scene.yaml").write_text(SCENE.replace("800", "200"))
        assert "10</td>" in until(port, lambda found: "10</td>" in "".join(found["parts"]))["parts"][0]
        assert interrupted(process) == (130, "interrupted")


@pytest.mark.sweep
def test_a_file_that_is_wrong_from_the_start_is_shown():
    with viewing(BROKEN) as (process, port):
        assert "unknown name" in until(port, lambda found: found["errors"])["errors"][0]
        assert interrupted(process) == (130, "interrupted")


@pytest.mark.sweep
def test_an_interrupt_while_solving():
    with viewing(SLOW) as (process, port):
        until(port, lambda found: found["work"] == "solving …")
        assert interrupted(process) == (130, "interrupted")


@pytest.mark.parametrize("options, said", [
    (["none.yaml"], "there is no file"), (["scene.yaml", "--case", "x"], "no case 'x'"),
    (["scene.yaml", "--set", "q=3"], "no parameter 'q'"), (["scene.yaml", "--port", "70000"], "--port")])
def test_what_cannot_be_followed_is_a_usage_error(options, said, capsys):
    Path("scene.yaml").write_text(SCENE)
    assert run(["view", *options]) == 2
    assert said in capsys.readouterr().err


def test_a_port_that_is_taken_is_named(served, capsys):
    Path("scene.yaml").write_text(SCENE)
    assert run(["view", "scene.yaml", "--port", str(served[0])]) == 2
    assert f"--port {served[0]} cannot be had: address already in use" in capsys.readouterr().err


@pytest.mark.sweep
def test_other_commands_import_nothing_of_it():
    Path("scene.yaml").write_text(SCENE)
    for command in ("solve", "check", "draw"):
        _, names = modules(command, "scene.yaml", *["-o", "x.svg"] * (command == "draw"))
        heavy = "http", "multiprocessing", "webbrowser", "vibcli.cli.view"
        assert not [name for name in names if name.startswith(heavy)]


# in a browser

@pytest.mark.sweep
@NEEDED
def test_a_browser_shows_the_page(tmp_path):
    with viewing(SCENE) as (_, port):
        until(port, lambda found: found["parts"])
        shown = dom(f"http://127.0.0.1:{port}/", tmp_path / "profile")
    assert "Natural frequencies" in shown and "<math" in shown
    assert "has ended" not in re.sub(r"(?s)<script.*?</script>", "", shown)


@pytest.mark.sweep
@NEEDED
def test_what_moves_is_paused_and_goes_on_by_a_button_that_keys_reach(tmp_path):
    moving = ('<svg viewBox="0 0 9 9"><circle r="1"><animate attributeName="r" values="1;2" dur="1s" '
              'repeatCount="indefinite"/></circle></svg>')
    paused = "main.querySelector('svg').animationsPaused()"
    tried = f"(pause.focus(), document.activeElement === pause), (pause.click(), {paused}), (pause.click(), {paused})"
    text = page(State(3, "t", (moving,)), "n")
    assert measured(text, tmp_path, f"[!pause.hidden, {tried}].map(Number).join('')") == 1110
    text = page(State(3, "t", ("<p>nothing moves</p>",)), "n")
    assert measured(text, tmp_path, "Number(pause.hidden)") == 1


@pytest.mark.sweep
@NEEDED
def test_a_browser_follows_the_file(tmp_path):
    """By the title of the tab, which the script of the page sets from what it fetches."""
    with viewing(SCENE) as (_, port):
        until(port, lambda found: found["parts"])
        browser = subprocess.Popen([BROWSER, *QUIET, f"--user-data-dir={tmp_path}/profile", "--remote-debugging-port=0",
                                    f"http://127.0.0.1:{port}/"], stderr=subprocess.PIPE, text=True)
        try:
            debugging = next(int(found[1]) for line in browser.stderr
                             if (found := re.search(r"ws://127\.0\.0\.1:(\d+)/", line)))
            _titled(debugging, "A block & <b>its</b> spring")
            Path("scene.yaml").write_text(BROKEN)
            until(port, lambda found: found["errors"])
            Path("scene.yaml").write_text(SCENE.replace("A block", "Another block"))
            _titled(debugging, "Another block & <b>its</b> spring")
        finally:
            browser.kill()
            browser.communicate()


def _titled(port, title):
    """Wait until a tab has this title."""
    end, found = time.monotonic() + 60, None
    while time.monotonic() < end:
        connection = HTTPConnection("127.0.0.1", port, timeout=300)
        connection.request("GET", "/json")
        found = [unescape(tab["title"]) for tab in json.loads(connection.getresponse().read()) if tab["type"] == "page"]
        if title in found:
            return
        time.sleep(0.1)
    raise AssertionError(found)


@pytest.mark.sweep
@NEEDED
@pytest.mark.parametrize("width", [360, 1280])
def test_the_caret_stands_under_what_is_wrong_and_no_word_under_the_button(tmp_path, width):
    error = "scene.yaml:3:40: error: unknown key\n" + 60 * " " + "{slid: x}\n" + 61 * " " + "^^^^\nhint: slide"
    text = page(State(1, "t", ('<p>one</p><svg><circle r="1"><animate/></circle></svg>',), (error,)), "n")
    size = f"--window-size={width},740"
    lines = "(errors.scrollHeight - 14.4) / parseFloat(getComputedStyle(errors).lineHeight)"
    assert 3.5 < measured(text, tmp_path, lines, size) < 4.6
    beside = "main.getBoundingClientRect().left - pause.getBoundingClientRect().right"
    assert measured(text, tmp_path, f"Math.max({beside}, pause.offsetWidth / innerWidth - 0.999)", size) > 0
