"""M, C, G and K as they are printed."""

import json

import pytest

from vibcli.cli.program import run

CART = """
title: A pendulum on a cart
parameters: {M: 6 kg, m: 2 kg, L: 0.75 m, c: 3 N*s/m, g: 9.81 m/s^2}
gravity: g
bodies:
  cart: {mass: M, at: [0, 0], slide: x}
  bob: {mass: m, at: [0, -L], pin: {at: [0, 0], carrier: cart, by: phi}}
dampers: {d: {c: c, between: [[-1 m, 0], cart]}}
"""
PRINTED = """\
Matrices of M·q̈ + C·q̇ + K·q = 0

  Mass matrix M
     x      φ
  x  M + m  m·L
  φ  m·L    m·L²

  Damping matrix C
     x  φ
  x  c  0
  φ  0  0

  Stiffness matrix K
     x  φ
  x  0  0
  φ  0  m·L·g

  Mass matrix M, in numbers (SI units)
     x    φ
  x  8    1.5
  φ  1.5  1.125
"""


def printed(tmp_path, capsys, text, *options):
    path = tmp_path / "scene.yaml"
    path.write_text(text)
    code = run(["solve", str(path), *options])
    return code, capsys.readouterr()


def test_two_degrees_tell_their_matrices(tmp_path, capsys):
    code, told = printed(tmp_path, capsys, CART)
    assert code == 0 and PRINTED in told.out


def test_they_are_those_of_the_data(tmp_path, capsys):
    _, told = printed(tmp_path, capsys, CART, "--json")
    assert json.loads(told.out)["matrices"]["M"] == [[8.0, 1.5], [1.5, 1.125]]


def test_one_degree_tells_them_where_they_are_asked_for(tmp_path, capsys):
    one = "title: one\nparameters: {m: 2 kg, k: 8 N/m}\nbodies: {b: {mass: m, slide: x}}\n" \
          "springs: {s: {k: k, between: [ground, b]}}\n"
    assert "Matrices" not in printed(tmp_path, capsys, one)[1].out
    told = printed(tmp_path, capsys, one + "find: [matrices]\n")[1].out
    assert "Matrices of M·q̈ + K·q = 0" in told and "     x\n  x  8\n" in told and "Equations" not in told


@pytest.mark.parametrize("asked", [True, False])
def test_members_have_none(tmp_path, capsys, asked):
    bar = "title: bar\nparameters: {L: 1 m, EA: 1 kN, mu: 1 kg/m}\n" \
          "bars: {b: {length: L, EA: EA, mass_per_length: mu, left: clamped}}\n"
    code, told = printed(tmp_path, capsys, bar + "find: [matrices]\n" * asked)
    assert code == (4 if asked else 0) and ("no matrices" in told.err) is asked


def test_wide_ones_are_told_in_numbers(tmp_path, capsys):
    names = "abcdef"
    given = ", ".join(f"mass_of_{n}: 2 kg, stiffness_of_{n}: 8 N/m" for n in names)
    text = f"title: wide\nparameters: {{{given}}}\n"
    text += "bodies: {" + ", ".join(f"{n}: {{mass: mass_of_{n}, slide: x{n}}}" for n in names) + "}\nsprings: {"
    text += ", ".join(f"s{n}: {{k: stiffness_of_{n}, between: [{other}, {n}]}}"
                      for other, n in zip(("ground", *names), names, strict=False)) + "}\n"
    out = printed(tmp_path, capsys, text)[1].out
    told = out.partition("Matrices")[2].partition("Natural")[0]
    assert "Mass matrix M, in numbers" in told and "mass_of" not in told
    assert max(map(len, out.split("\n"))) <= 104
