"""Names of signals are parsed once, and places on members are told from instants."""

import pytest

from vibcli.language.signal_names import SignalName, signal_name
from vibcli.language.signals_of_places import with_places
from vibcli.symbolic.parser import parse
from vibcli.symbolic.syntax import NameRef, parts_of

NAMES = {
    "x": SignalName("x"), "x''": SignalName("x", primes=2), "tip.x'": SignalName("tip", "x", primes=1),
    "disc.reaction.x": SignalName("disc", "reaction.x"), "hoist.force.1": SignalName("hoist", "force.1"),
    "rod.u(L/2)": SignalName("rod", "u", "L/2"), "rod.u'(L)": SignalName("rod", "u", "L", 1),
    "rod.u((a + b)/2)": SignalName("rod", "u", "(a + b)/2"),
}


@pytest.mark.parametrize(("text", "signal"), NAMES.items())
def test_a_name_is_parsed_and_written_again(text, signal):
    assert signal_name(text) == signal
    assert signal.text == text
    assert signal_name(signal.text) is signal_name(text)


def test_primes_may_follow_the_place_and_blanks_do_not_count():
    assert signal_name("rod.u(L)'") == signal_name("rod.u'(L)")
    assert signal_name("rod.u( L  / 2 )") == SignalName("rod", "u", "L / 2")


def test_words_of_a_part():
    assert (signal_name("disc.reaction.x").kind, signal_name("disc.reaction.x").axis) == ("reaction", "x")
    assert (signal_name("d.force").kind, signal_name("d.force").axis) == ("force", "")


@pytest.mark.parametrize(("text", "names"), [
    ("rod.u(L)", ["rod.u(L)"]), ("rod.u'(L)", ["rod.u(L)"]),
    ("2*rod.u(L) - rod.u(L/2) + x", ["rod.u(L)", "rod.u(L/2)", "x"]),
    ("sqrt(rod.force(0 m)^2)", ["rod.force(0 m)"]),
])
def test_a_place_belongs_to_the_name_of_a_member(text, names):
    assert sorted(name for name, *_ in parts_of(with_places(parse(text), {"rod"})).names) == sorted(names)


def test_what_follows_a_place_is_an_instant():
    tree = with_places(parse("rod.u'(L)(1 ms)"), {"rod"})
    assert tree.head == "value"
    assert tree.args[0] == NameRef(0, 9, "rod.u(L)", 1)


def test_elsewhere_brackets_hold_an_instant():
    for text in ("s.force(2 s)", "x(2 s)", "max(s.force)(1 s)"):
        assert with_places(parse(text), {"rod"}) == parse(text)


def test_an_index_holds_a_place():
    assert parse("mode[2][rod.u(L)]").indices == ("2", "rod.u(L)")
    assert parse("frf[wing.u(min(a, L)), drive](5 Hz)").indices == ("wing.u(min(a, L))", "drive")
