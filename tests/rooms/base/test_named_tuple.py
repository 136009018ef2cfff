"""Named tuples of our own beside those of `typing`: same classes, same behaviour, same refusals."""

import copy
import inspect
import pickle
import typing

import pytest

from vibcli.base import named_tuple


class Ours(named_tuple.NamedTuple):
    """A place with a name."""

    x: float
    y: "float" = 0.5
    name: str = ""

    LIMIT = 3

    @property
    def turned(self) -> "Ours":
        return self._replace(x=-self.y, y=self.x)


class Theirs(typing.NamedTuple):
    x: float
    y: "float" = 0.5
    name: str = ""


class Below(Ours):
    def doubled(self) -> "Below":
        return self._replace(x=2*self.x)


class Deeper(Below):
    colour: str = "red"


class Nothing(named_tuple.NamedTuple):
    pass


def test_they_are_made_printed_and_compared_as_those_of_typing():
    for values, named in [((1.0,), {}), ((1.0, 2.0), {"name": "a"}), ((), {"x": 3.0, "name": "b"})]:
        ours, theirs = Ours(*values, **named), Theirs(*values, **named)
        assert ours == theirs == tuple(theirs) and hash(ours) == hash(theirs)
        assert repr(ours) == repr(theirs).replace("Theirs", "Ours")
        assert ours._asdict() == theirs._asdict() and (ours.x, ours.y, ours.name) == tuple(theirs)
        assert ours._replace(y=7) == theirs._replace(y=7)
        assert pickle.loads(pickle.dumps(ours)) == copy.deepcopy(ours) == ours and type(copy.copy(ours)) is Ours
    for member in ("_fields", "_field_defaults", "__match_args__"):
        assert getattr(Ours, member) == getattr(Theirs, member), member
    assert Ours._make([1, 2, "c"]) == (1, 2, "c") and Ours(1.0, 2.0).turned == Ours(-2.0, 1.0)
    assert [str(each) for each in inspect.signature(Ours).parameters.values()] == ["x", "y=0.5", "name=''"]
    assert Nothing() == () and repr(Nothing()) == "Nothing()"


def test_they_are_as_small_and_as_closed():
    assert not hasattr(Ours(1.0), "__dict__") and Ours(1.0).__sizeof__() == Theirs(1.0).__sizeof__()
    with pytest.raises(AttributeError):
        Ours(1.0).x = 2.0
    with pytest.raises(AttributeError):
        Ours(1.0).colour = "red"
    match Ours(1.0, 2.0):
        case Ours(x, y):
            assert (x, y) == (1.0, 2.0)


def test_a_class_below_one_has_its_fields():
    assert type(Below(1.0).doubled()) is Below and Below(1.0).doubled() == (2.0, 0.5, "")
    assert Below._fields == Ours._fields
    assert Deeper(1.0, name="a") == (1.0, 0.5, "a") and Deeper._fields == Ours._fields and Deeper.colour == "red"


@pytest.mark.parametrize(("values", "named", "words"), [
    ((), {}, "Ours.__new__() missing 1 required positional argument: 'x'"),
    ((1, 2, "a", 4), {}, "takes from 2 to 4 positional arguments but 5 were given"),
    ((1,), {"colour": "red"}, "Ours.__new__() got an unexpected keyword argument 'colour'"),
    ((1,), {"x": 2}, "Ours.__new__() got multiple values for argument 'x'"),
])
def test_what_does_not_fit_the_fields_is_refused(values, named, words):
    with pytest.raises(TypeError) as refusal:
        Ours(*values, **named)
    assert words in str(refusal.value)


def test_changes_of_unknown_fields_and_fields_out_of_order_are_refused():
    with pytest.raises(TypeError, match="no fields colour"):
        Ours(1.0)._replace(colour="red")
    with pytest.raises(TypeError, match="without a default follows"):
        class Wrong(named_tuple.NamedTuple):
            x: float = 1.0
            y: float
