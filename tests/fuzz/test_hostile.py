"""Hostile files through the whole command line: refused in words, at once, in little memory, and nothing is run."""

import resource
import subprocess
import sys
from pathlib import Path

import pytest
from support.counting import calls

from vibcli.cli.program import run

SCENE = "bodies: {{a: {{mass: 1 kg, slide: x}}}}\nsprings: {{s: {{k: {}, between: [ground, a]}}}}\n"
FEW, MANY = 10**5, 3 * 10**6     # calls of functions: for a wrong expression, for a scene of many lines
MEMORY = 1 << 30   # bytes of address space: NumPy alone maps some hundred megabytes
EXTRA, SLIP = 64 * 1024, []     # kilobytes that a hostile file takes more than a short one, whose memory is kept


def chain(n):
    springs = "".join(f"  s{i}: {{k: 1 N/m, between: [b{i - 1}, b{i}]}}\n" for i in range(1, n))
    return "bodies:\n" + "".join(f"  b{i}: {{mass: 1 kg, slide: x{i}}}\n" for i in range(n)) + (
        "springs:\n  s0: {k: 1 N/m, between: [ground, b0]}\n" + springs)


def matrices(n):
    row = "[" + ", ".join(["1"] * n) + "]"
    return "matrices:\n  K: [" + ", ".join([row] * n) + "]\n"


def pendulum(n):
    """Links that each carry the next."""
    links = "".join(f"  b{i}: {{mass: 1, at: [0, -{i + 1}], pin: {{at: [0, -{i}], by: phi{i}"
                    + (f", carrier: b{i - 1}" if i else "") + "}}\n" for i in range(n))
    return "gravity: 9.81\nbodies:\n" + links


EXPRESSIONS = {
    "brackets": "(" * 70 + "1" + ")" * 70,
    "many_brackets": "(" * 100000 + "1" + ")" * 100000,
    "powers": "9**9**9**9",
    "powers_of_powers": "2" + "^2" * 100000,
    "big_power": "10^999999999",
    "root_power": "2^(2^40)*1 N/m",
    "factorial": "factorial(10^8)",
    "long_sum": "1" + "+1" * 50000,
    "long_product": "k" + "*k" * 900,
    "long_name": "k" * 1999,
    "two_thousand": "1" + "+1" * 1100,
    "digits": "9" * 1900,
    "exponent": "1e99999999999999999999",
    "matrix": "Matrix(['__import__(\"os\").system(\"touch HACKED\")'])",
    "solve": "solve('x', 'open(\"HACKED\", \"w\")')",
    "attributes": "k.__class__.__mro__[1].__subclasses__()",
    "formatted": "f'{open(\"HACKED\", \"w\")}'",
    "walrus": "(k := 3)",
    "import": "__import__('os').system('touch HACKED')",
    "class": "().__class__.__bases__[0]",
    "lambda": "(lambda: 0)()",
    "minus": "-" * 1900 + "1",
    "primes": "x" + "'" * 1900,
    "indices": "omega[" * 300 + "1" + "]" * 300,
    "functions": "sin(" * 300 + "1" + ")" * 300,
    "escape": '"\\e]52;c;aGk=\\a"',
    "tower": "exp(exp(exp(exp(exp(9)))))",
    "sexagesimal": ":".join(["59"] * 500),
}
FILES = {
    "deep_lists": "a: " + "[" * 30000,
    "deep_mappings": "{a: " * 30000,
    "five_hundred_lists": "a: " + "[" * 500 + "]" * 500,
    "doubled_keys": "bodies: {a: {mass: 1 kg, slide: x}}\nbodies: {b: {mass: 2 kg, slide: y}}\n",
    "keys_that_are_one": "parameters: {on: 1 kg, 1: 2 kg, 1.0: 3 kg, yes: 4 kg}\n",
    "sexagesimal": "title: a\ngravity: " + ":".join(["59"] * 5000) + "\n",
    "hostile_names": "parameters: {\"x=__import__('os').system('touch HACKED')\": 2 kg}\n"
                     "bodies: {\"b, *args): open('HACKED', 'w') #\": {mass: 1 kg, slide: \"lambda: 0\"}}\n",
    "infinities": "parameters: {m: 1e400 kg, k: 1e-400 N/m, c: .inf, d: .nan}\nbodies: {a: {mass: m, slide: x}}\n",
    "not_utf_8": "title: \udcff\udcfe\n",
    "aliases": "a: &a [x, x, x]\n" + "".join(f"{chr(98 + i)}: &{chr(98 + i)} [*{chr(97 + i)}, *{chr(97 + i)}]\n"
                                            for i in range(20)),
    "merge": "a: &a {b: 1}\nc: {<<: *a}\n",
    "tag": "title: !!python/object/apply:os.system ['touch HACKED']\n",
    "keys": "".join(f"k{i}: 1\n" for i in range(60000)),
    "body_keys": "bodies:\n  a: {" + ", ".join(f"k{i}: 1" for i in range(60000)) + "}\n",
    "parameters": "parameters:\n" + "".join(f"  p{i}: 1 kg\n" for i in range(15000)),
    "circle": "parameters:\n" + "".join(f"  p{i}: p{(i + 1) % 6000}\n" for i in range(6000)),
    "unknown_names": "parameters:\n" + "".join(f"  p{i}: q{i}\n" for i in range(12000)),
    "coordinates": chain(2001) + "constraints:\n  c: {equal: [x0, 2*x1]}\n",
    "list_of_coordinates": "coordinates: [" + ", ".join(f"x{i}" for i in range(60000)) + "]\n",
    "carriers": "bodies:\n" + "".join(f"  b{i}: {{mass: 1 kg, at: [0, 0], weld: b{(i + 1) % 9000}}}\n"
                                      for i in range(3000)),
    "matrices": matrices(2000),
    "one_matrix": "matrices:\n  M: [[" + "1, " * 1999 + "1]]\n",
    "cases": "bodies: {a: {mass: 1 kg, slide: x}}\ncases:\n" + "".join(f"  c{i}: {{title: t}}\n" for i in range(30000)),
    "escapes": 'title: "\\e[2J\\e]0;x\\a"\nbodies: {"\\e[31m": {mass: 1 kg, slide: x}}\n',
    "names": "bodies: {__class__: {mass: __class__, slide: __init__}}\n",
    "question": "question: " + "{" * 4000 + "\nbodies: {a: {mas: 1 kg, slide: x}}\n",
    "null": "title: a\0b\n",
    "bell": "title: a\x07b\n",
    "right_to_left": "title: a\u202eb\n",
    "mebibyte": "# " + "x" * 2**20,
}
SOUND = {       # odd, but answered: there is a stiffness, or a motion of first order
    "stiffness_alone": matrices(80),
    "dampers_alone": "bodies: {a: {slide: x}}\ndampers: {d: {c: 1 N*s/m, between: [ground, a]}}\n",
}


def write(tmp_path, text):
    path = tmp_path / "hostile.yaml"
    path.write_text(text, encoding="utf-8", errors="surrogateescape")
    return str(path)


def refused(path, capsys, *command):
    code, spent = calls(run, [*command, path])
    out, err = capsys.readouterr()
    assert code in (3, 4), (code, err[:300])
    assert not out or command == ("check",) or (code == 4 and "Natural frequencies" not in out)
    assert "error" in err
    assert err.replace("\n", "").isprintable()
    assert len(err) < 100_000
    assert not Path("HACKED").exists()
    return spent, err


@pytest.mark.parametrize("name", EXPRESSIONS)
def test_expressions(name, tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    text = EXPRESSIONS[name]
    quoted = text if text.startswith('"') else "'" + text.replace("'", "''") + "'"
    spent, _ = refused(write(tmp_path, SCENE.format(quoted)), capsys, "solve")
    assert spent < FEW


@pytest.mark.parametrize("name", FILES)
def test_files(name, tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    spent, _ = refused(write(tmp_path, FILES[name]), capsys, "solve")
    assert spent < MANY


@pytest.mark.parametrize("name", SOUND)
def test_odd_files_that_are_sound_are_answered(name, tmp_path, capsys):
    code, spent = calls(run, ["solve", write(tmp_path, SOUND[name])])
    out, err = capsys.readouterr()
    assert (code, err) == (0, "")
    assert "neutral: it can move freely" in out
    assert spent < MANY


@pytest.mark.parametrize("text", [*EXPRESSIONS.values()][:6], ids=[*EXPRESSIONS][:6])
def test_expected_answers(text, tmp_path, capsys):
    scene = SCENE.format("3 N/m") + f"answers:\n  omega[1]: '{text}'\n"
    spent, _ = refused(write(tmp_path, scene), capsys, "check")
    assert spent < FEW


PEAK = """import sys
from vibcli.cli.program import run
code = run(["solve", sys.argv[1]])
print(next(line.split()[1] for line in open("/proc/self/status") if line.startswith("VmHWM")))
sys.exit(code)"""


def peak_of(path):
    """(the process, kilobytes of memory at most) of solving a file."""
    done = subprocess.run([sys.executable, "-c", PEAK, path], capture_output=True, text=True, preexec_fn=limited,
                          env={"OPENBLAS_NUM_THREADS": "1", "PATH": ""}, timeout=30)
    return done, int((done.stdout.split() or [MEMORY])[-1])


def of_a_slip(folder):
    """The same of a short file with a slip, found once."""
    if not SLIP:
        SLIP.append(peak_of(write(folder, "bodies: {a: {mas: 1 kg}}\n"))[1])
    return SLIP[0]


def limited():
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    resource.setrlimit(resource.RLIMIT_CPU, (20, 20))


@pytest.mark.parametrize("name", ["deep_lists", "aliases", "keys", "coordinates", "matrices", "carriers", "mebibyte"])
def test_little_memory_is_enough(name, tmp_path):
    done, peak = peak_of(write(tmp_path, FILES[name]))
    assert done.returncode == 3, done.stderr[-300:]
    assert "Traceback" not in done.stderr
    assert peak <= of_a_slip(tmp_path) + EXTRA


def test_large_scenes_that_are_sound_are_answered(tmp_path, capsys):
    huge = "bodies: {a: {shape: disc, radius: 1e50 m, mass: 1e59 kg, at: [1e50 m, 0], move: [x, y, phi]}}\n"
    for text in (chain(200), pendulum(12), huge):
        assert run(["frequencies", write(tmp_path, text)]) == 0
        assert "mode" in capsys.readouterr().out


def test_names_and_titles_are_only_text(tmp_path, capsys):
    text = ("title: '{0.__class__} %s $HOME `id` \\e[31m'\nparameters: {__init__: 2 kg}\n"
            "bodies: {__class__: {mass: __init__, slide: __dict__}}\n"
            "springs: {__doc__: {k: 8 N/m, between: [ground, __class__]}}\nanswers: {'omega[1]': 2 rad/s}\n")
    path = write(tmp_path, text)
    assert run(["solve", path]) == 0
    out = capsys.readouterr().out
    assert "{0.__class__} %s $HOME `id`" in out
    assert "\x1b" not in out
    assert run(["check", path]) == 0
