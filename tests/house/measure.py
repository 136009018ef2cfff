"""The house in figures: `python tests/house/measure.py` prints the table; the tests beside it hold its bounds."""

import ast
import sys
from collections import defaultdict
from fnmatch import fnmatchcase
from functools import cache
from pathlib import Path
from statistics import median

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))       # run as a script it finds the tree that it is in
sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from house.uses import Uses

PACKAGE = Path(__file__).resolve().parents[2] / "vibcli"
FLOORS = (      # from the ground up; a room imports rooms of lower floors only
    ("base",), ("numerics", "symbolic", "plots"), ("notation", "language"), ("elements",), ("scene",),
    ("mechanics", "drawing"), ("analyses",), ("results",), ("quantities",), ("reader", "inverse"),
    ("check", "report"), ("evidence", "homework"), ("manual", "api"), ("cli", "bench"))
FLOOR = {room: floor for floor, rooms in enumerate(FLOORS) for room in rooms}
FLAT = ("__init__", "__main__")         # the files that stand in no room
GROUND = 2          # floors that serve everyone: what is called there counts as no visit
LATER = ("evidence", "homework")        # rooms that the plan of the house did not know
TREES = ("tree", "quantity", "literal")
NODES = "vibcli.symbolic.expression"
LOADER = "named_elements"       # of language/: what it loads is loaded for those who ask it
LOADERS = ("load", "Lazy", "LazyKind")
SPRING = """\
parameters: {m: 2 kg, k: 800 N/m}
bodies: {b: {mass: m, slide: x}}
springs: {s: {k: k, between: [ground, b]}}
"""


def module_of(path, package=PACKAGE):
    """The dotted name of a file, `vibcli` for the package itself."""
    return ".".join((package.name, *path.relative_to(package).with_suffix("").parts)).removesuffix(".__init__")


def room_of(module):
    """The room of a module: the first name below the package; the package itself is `__init__`."""
    return [*module.split("."), "__init__"][1]


def lines_for_types(nodes):
    """The lines under `if TYPE_CHECKING:`, which never run."""
    return {line for node in nodes if isinstance(node, ast.If) and _last_name(node.test) == "TYPE_CHECKING"
            for line in range(node.lineno, node.end_lineno + 1)}


class House:
    """The files of a package with their syntax trees and imports."""

    def __init__(self, package=PACKAGE):
        self.package = package
        self.trees = {module_of(path, package): ast.parse(path.read_text(encoding="utf-8"))
                      for path in sorted(package.rglob("*.py"))}
        self.nodes = {module: list(ast.walk(tree)) for module, tree in self.trees.items()}
        self.written = {module: self._imports(module) for module in self.trees}
        self.imports = {module: sorted(found | self._dispatched(module)) for module, found in self.written.items()}
        self._unused = None

    def _imports(self, module):
        """{(module imported, line)}, at any depth of the file, those of types alone left out; relative imports are none
        of the project's."""
        found, for_types = set(), lines_for_types(self.nodes[module])
        for node in self.nodes[module]:
            if isinstance(node, ast.Import):
                names = [alias.name for alias in node.names]
            elif isinstance(node, ast.ImportFrom):
                assert node.level == 0, f"{module}:{node.lineno}: relative import"
                names = [f"{node.module}.{alias.name}" for alias in node.names]
            else:
                continue
            if node.lineno in for_types:
                continue
            for name in names:
                if name.split(".")[0] == self.package.name:
                    while name not in self.trees:
                        name = name.rpartition(".")[0]
                    found.add((name, node.lineno))
        return found - {(module, line) for _, line in found}

    def _dispatched(self, module):
        """{(module, line)} of what a module imports by the names in a table."""
        return {(name, node.lineno) for node in self.nodes[module] if isinstance(node, ast.Call)
                for name in self._by_name(module, node) if name != module}

    def _by_name(self, module, call):
        """The modules that a call imports by name, import_module(f"vibcli.ROOM.{name}") or load(name, room): those of
        which the tables tell that the file takes from the face of the folder; of none, its own."""
        called = call.func.id if isinstance(call.func, ast.Name) else None
        if called == "import_module" and not module.endswith(f".{LOADER}"):
            folder, name = _pattern(call.args[0]).split("*")[0].rstrip("."), "*"
        elif called in LOADERS and call.args and self._takes(module, LOADER):
            name, room = (*map(_pattern, call.args), "elements")[:2]
            folder = f"{self.package.name}.{room}"
        else:
            return ()
        words = self._words(folder, module) if "*" in name else {name}
        return {f"{folder}.{word}".replace("/", ".") for word in words if fnmatchcase(word, name)} & self.trees.keys()

    def _takes(self, module, source):
        """The names that a module takes from files of that name."""
        return {alias.name for node in self.nodes[module] if isinstance(node, ast.ImportFrom)
                and f"{node.module}".endswith(source) for alias in node.names}

    def _words(self, folder, module):
        """The texts in the tables that a module takes from the face of a folder; where it takes none its own."""
        taken, told = self._takes(module, folder), self.nodes.get(folder, ())
        tables = {node.targets[0].id: node for node in told if isinstance(node, ast.Assign)}
        needed = [tables[name] for name in taken if name in tables] or [self.trees[module]]
        for node in needed:     # grows by the tables that a table is made of
            needed += [tables[part.id] for part in ast.walk(node) if isinstance(part, ast.Name)
                       and part.id in tables and tables[part.id] not in needed]
        return {part.value for node in needed for part in ast.walk(node)
                if isinstance(part, ast.Constant) and isinstance(part.value, str)}

    def upward(self):
        """Imports from a room on the same floor or a higher one, as text; the package itself opens the door, api/."""
        return [f"{module}:{line} imports {name}" for module, imports in self.imports.items() for name, line in imports
                if room_of(name) not in (room_of(module), "__init__") and room_of(module) not in FLAT
                and FLOOR[room_of(name)] >= FLOOR[room_of(module)]]

    def arrows(self, without=()):
        """{(room, room that it imports)}, those of some rooms left out where asked."""
        pairs = {(room_of(module), room_of(name)) for module, imports in self.imports.items() for name, _ in imports}
        return {(a, b) for a, b in pairs if a != b and not {a, b} & {*FLAT, *without}}

    def arrows_of_the_plan(self):
        """Those between the rooms that the plan of the house knew."""
        return self.arrows(without=LATER)

    def floors(self):
        """The number of rooms on the longest way down."""
        below, known = defaultdict(set), {}
        for a, b in self.arrows():
            below[a].add(b)

        def height(room, above=()):
            if room not in known:
                inner = [height(other, (*above, room)) for other in below[room] if other not in above]
                known[room] = 1 + max(inner, default=0)
            return known[room]

        return max(map(height, list(below)))

    def circles(self, by_name=False):
        """Files that import each other, at any depth of import, by the names in a table too where asked, as sorted
        tuples of modules (Tarjan 1972)."""
        every = self.imports if by_name else self.written
        graph = {module: {name for name, _ in imports} for module, imports in every.items()}
        number, low, stack, found = {}, {}, [], []

        def visit(module):
            number[module] = low[module] = len(number)
            stack.append(module)
            for name in graph[module]:
                if name not in number:
                    visit(name)
                    low[module] = min(low[module], low[name])
                elif name in stack:
                    low[module] = min(low[module], number[name])
            if low[module] == number[module]:
                circle = stack[stack.index(module):]
                del stack[stack.index(module):]
                if len(circle) > 1:
                    found.append(tuple(sorted(circle)))

        sys.setrecursionlimit(10_000)
        for module in graph:
            if module not in number:
                visit(module)
        return found

    def functions(self, *rooms):
        """(module, function) of all functions, of all rooms or those named."""
        return [(module, node) for module, nodes in self.nodes.items() if not rooms or room_of(module) in rooms
                for node in nodes if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef))]

    def lengths(self):
        """{function: its lines, with signature and docstring}."""
        return {f"{module}.{node.name}:{node.lineno}": node.end_lineno - node.lineno + 1
                for module, node in self.functions()}

    def taking_problem(self):
        """Functions of mechanics and analyses that take the whole problem."""
        return [f"{module}.{node.name}" for module, node in self.functions("mechanics", "analyses")
                if any(arg.arg == "problem" for arg in node.args.args)]

    def subscripts(self):
        """Subscripts of syntax trees by number."""
        return [f"{module}:{node.lineno}" for module, nodes in self.nodes.items() for node in nodes
                if isinstance(node, ast.Subscript) and isinstance(node.slice, ast.Constant)
                and isinstance(node.slice.value, int) and _last_name(node.value) in TREES]

    def set_from_outside(self):
        """Attributes of other objects that are assigned, but for the nodes of the table that shares them and for what
        `sys` lets a program set."""
        found = []
        for module, nodes in self.nodes.items():
            if module == NODES:
                continue
            for node in nodes:
                if isinstance(node, ast.Attribute) and isinstance(node.ctx, ast.Store) and not (
                        isinstance(node.value, ast.Name) and node.value.id in ("self", "cls", "sys")):
                    found.append(f"{module}:{node.lineno}")
        return found

    def with_several_bases(self):
        """Classes that are put together of several."""
        return [f"{module}.{node.name}" for module, nodes in self.nodes.items() for node in nodes
                if isinstance(node, ast.ClassDef) and len(node.bases) > 1]

    def annotated(self):
        """The share of parameters with a type, `self` and `cls` left out."""
        args = [arg for _, node in self.functions() for arg in (*node.args.args, *node.args.kwonlyargs)
                if arg.arg not in ("self", "cls")]
        return sum(arg.annotation is not None for arg in args) / len(args)

    def class_names(self):
        """{name of a public class: modules} of those that several modules define."""
        found = defaultdict(list)
        for module, nodes in self.nodes.items():
            for node in nodes:
                if isinstance(node, ast.ClassDef) and not node.name.startswith("_"):
                    found[node.name].append(module)
        return {name: modules for name, modules in found.items() if len(modules) > 1}

    def unused(self):
        """{(module, name): lines} of what nothing in the package uses."""
        if self._unused is None:
            page = self.package / "manual" / "python.py"
            told = page.read_text(encoding="utf-8") if page.exists() else ""
            self._unused = Uses(self.package.name, self.trees, self.nodes, told).unused()
        return self._unused

    def lines(self):
        return sum(path.read_text(encoding="utf-8").count("\n") for path in self.package.rglob("*.py"))


def _pattern(node):
    """A text, with * for what is computed."""
    if isinstance(node, ast.JoinedStr):
        return "".join(map(_pattern, node.values))
    if isinstance(node, ast.BinOp):
        return _pattern(node.left) + _pattern(node.right)
    return node.value if isinstance(node, ast.Constant) else "*"


def _last_name(node):
    while isinstance(node, ast.Attribute):
        return node.attr
    return node.id if isinstance(node, ast.Name) else None


def walked(args):
    """(rooms above the ground floors entered, moves between rooms, those of them into rooms above the ground floors) of
    one command in this process; the last are what the plan of the house counts, as it does no entry of the ground."""
    from vibcli.cli.program import run

    prefix, rooms, moves, up = str(PACKAGE) + "/", set(), 0, 0

    def room(frame):
        name = frame.f_code.co_filename
        return name[len(prefix):].removesuffix(".py").split("/")[0] if name.startswith(prefix) else None

    def profile(frame, event, _):
        nonlocal moves, up
        if event == "call" and (here := room(frame)) and frame.f_code.co_name != "<module>":
            rooms.add(here)
            caller = frame.f_back
            while caller is not None and room(caller) is None:
                caller = caller.f_back
            moved = caller is not None and room(caller) != here
            moves, up = moves + moved, up + (moved and FLOOR.get(here, GROUND) >= GROUND)

    sys.setprofile(profile)
    try:
        run(list(args))
    finally:
        sys.setprofile(None)
    return {name for name in rooms if FLOOR.get(name, GROUND) >= GROUND}, moves, up


@cache
def walks():
    """What is walked by `frequencies` of a mass on a spring, and by `check` of its max(x) once it is let go."""
    import contextlib
    import io
    import tempfile

    with tempfile.TemporaryDirectory() as folder:
        path, let_go = Path(folder) / "scene.yaml", Path(folder) / "let_go.yaml"
        path.write_text(SPRING)
        let_go.write_text(SPRING + "initial: {x: 1 cm}\nanswers: {max(x): 1 cm}\n")
        with contextlib.redirect_stdout(io.StringIO()):
            return walked(["frequencies", str(path)]), walked(["check", str(let_go)])


def main(house):
    (rooms, moves, up), (_, in_check, up_in_check) = walks()
    outside, lengths = house.set_from_outside(), house.lengths().values()
    flat = [entry for entry in PACKAGE.iterdir() if entry.suffix == ".py"]
    rooms_of = {room_of(module) for module in house.trees if "." in module}
    rows = [
        ("files directly in vibcli/ + rooms", f"{len(flat)} + {len(rooms_of - {p.stem for p in flat})}"),
        ("floors", house.floors()), ("import arrows between rooms", len(house.arrows())),
        (f"the same without {' and '.join(LATER)}", len(house.arrows_of_the_plan())),
        ("import circles of files", len(house.circles())),
        ("the same by the names in tables too", len(house.circles(by_name=True))),
        ("rooms that `frequencies` of a mass on a spring enters", f"{len(rooms)}: {' '.join(sorted(rooms))}"),
        ("moves between rooms in that run / in `check` of max(x)", f"{up} / {up_in_check}"),
        ("the same with those into the ground floors", f"{moves} / {in_check}"),
        ("functions of mechanics and analyses that take the whole problem", len(house.taking_problem())),
        ("subscripts of syntax trees", len(house.subscripts())),
        ("attributes set on an object from outside it, below results/",
         sum(FLOOR.get(room_of(place.split(":")[0]), 0) < FLOOR["results"] for place in outside)),
        ("the same in all rooms", f"{len(outside)} in {len({place.split(':')[0] for place in outside})} files"),
        ("classes with more than one base", len(house.with_several_bases())),
        ("annotated parameters", f"{house.annotated():.0%}"),
        ("lines of a function, median and most", f"{median(lengths):g} {max(lengths)}"),
        ("class names that mean several things", len(house.class_names())),
        ("names that nothing in vibcli uses", len(house.unused())),
        ("lines", house.lines()), ("files", len(house.trees))]
    for what, figure in rows:
        print(f"{what:66} {figure}")


if __name__ == "__main__":
    main(House())
