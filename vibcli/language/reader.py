"""What reading a file collects: diagnostics, expressions, names, records; and the words of its messages."""

from vibcli.base.diagnostics import quoted
from vibcli.base.errors import Diagnostic
from vibcli.language.document.document import Mapping, Sequence
from vibcli.symbolic.parser import plain_name

MOST_PROBLEMS = 100


def article(noun):
    return ("an " if noun[0] in "aeiou" else "a ") + noun


class TooManyErrors(Exception):
    """More is wrong with a file than anybody reads."""


class Reader:
    """Collects what reading a file yields beside its values: diagnostics, every expression, the expressions that
    move something (a bare name there is a coordinate), those that load or tie it, names that are good in one expression
    alone as {id: (name, dimension)}, and every reference as (Name, namespaces, what is wanted).
    `sound` tells whether the scene was read whole, apart from what is asked of it; `files`: what was read beside it."""

    def __init__(self, files=None):
        self.files = {} if files is None else files
        self.diagnostics, self.expressions, self.motions, self.loads, self.references = [], [], [], [], []
        self.local_names, self.named_places = {}, []
        self.sound = True

    def report(self, where, message, hint=None):
        self.diagnostics.append(Diagnostic(where, message, hint))
        if len(self.diagnostics) == MOST_PROBLEMS:
            self.diagnostics.append(Diagnostic(where, "too many problems: reading stops here", "mend these first"))
            raise TooManyErrors

    def columns_of(self, scene, name, read):
        """What `read(scene, name)` gives, once for a file however many cases use it."""
        if (scene, name) not in self.files:
            self.files[scene, name] = read(scene, name)
        return self.files[scene, name]

    def expected(self, node, what, hint=None):
        self.report(node.where, f"expected {what}, found {_found(node)}", hint)


def _found(node):
    if isinstance(node, Mapping):
        return "a mapping"
    if isinstance(node, Sequence):
        return "a list"
    return quoted(node.text) if node.text.strip() else "nothing"


class Expression:
    """A parsed expression with its place, and the dimension that its field wants (None: settled elsewhere)."""

    __slots__ = ("dimension", "scalar", "tree", "unit")

    def __init__(self, scalar, tree, unit, dimension):
        self.scalar, self.tree, self.unit, self.dimension = scalar, tree, unit, dimension

    @property
    def text(self):
        return self.scalar.text

    @property
    def where(self):
        return self.scalar.where


class Reference:
    """A reference to something named elsewhere, with its place."""

    __slots__ = ("text", "where")

    def __init__(self, text, where):
        self.text, self.where = text, where


class Record:
    """One element as written: its declared kind, its name, its values and the place of each key."""

    __slots__ = ("element", "keys", "name", "values", "where")

    def __init__(self, element, name, where, values, keys):
        self.element, self.name, self.where, self.values, self.keys = element, name, where, values, keys

    def __getitem__(self, key):
        return self.values[key]

    def get(self, key, default=None):
        return self.values.get(key, default)

    def __contains__(self, key):
        return key in self.values

    def place(self, key):
        return self.keys.get(key, self.where)


def check_name(node, reader, forbidden=()):
    """A name chosen by the writer, Greek letters spelt out; None and a diagnostic where it is not one."""
    name = plain_name(node.text)
    if not name.isidentifier() or not name.isascii() or len(name) > 32:
        return reader.report(node.where, f"{quoted(node.text)} is not a name",
                             "a name starts with a letter, a to z or Greek, and goes on with letters, digits and _, at "
                             "most 32")
    if name in forbidden:
        return reader.report(node.where, f"'{node.text}' is a word of the language and cannot be a name here",
                             "choose another name")
    return name
