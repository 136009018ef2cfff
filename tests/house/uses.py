"""Functions, classes, methods and constants that a package defines and never uses, by the syntax trees of its files.

What only something unused uses is unused too. A function or class is used where its file names it, or where another
file imports it or takes it of the module; a method, where anything takes an attribute of its name. What files that are
loaded by name offer (`FACES`) may be taken of anything, and named by a text: `getattr(module, f"{word}_data")`.
"""

import ast
import re
from itertools import chain

from vibcli.analyses import ANALYSES

FACES = ("bench", "cli", "drawing.symbols", "elements", "evidence.methods", "evidence.stress.families",
         "evidence.subjects", "homework.exports", "homework.mistakes", "language.sections", "quantities",
         "reader.sections", "report.formats", "report.sections",
         *("analyses." + row[0].replace("/", ".") for row in ANALYSES.values()))
ANY = r"\w+"
FUNCTION = (ast.FunctionDef, ast.AsyncFunctionDef)


class Uses(ast.NodeVisitor):
    """What the files of a package define, and what they use of it, each with the definitions around the use."""

    def __init__(self, package, trees, nodes, door=""):
        """trees, nodes: {module: its syntax tree, all nodes of this}; `door`: the manual's page of the room `api`, the
        names of which Python calls from outside."""
        self.package, self.modules, self.door = package, set(trees), set(re.findall(r"\w+", door))
        self.defined, self.found, self.patterns = {}, {}, {}
        self.offered_to_others, self.by_name = set(), set()
        for module, tree in trees.items():
            self.module, self.around, self.names = module, (), _modules_named(nodes[module], self.modules)
            for node in tree.body:
                self._define(node)
            self.visit(tree)

    def _define(self, node, owner=""):
        if isinstance(node, (*FUNCTION, ast.ClassDef)):
            self.defined[self.module, owner + node.name] = node.end_lineno - node.lineno + 1
        elif isinstance(node, ast.Assign) and not owner:
            for target in node.targets:
                for name in target.elts if isinstance(target, ast.Tuple) else (target,):
                    if isinstance(name, ast.Name) and not name.id.startswith("__"):
                        self.defined[self.module, name.id] = 1
        if isinstance(node, ast.ClassDef) and not owner:
            for inner in node.body:
                self._define(inner, node.name + ".")

    def _use(self, *key):
        self.found.setdefault(key, set()).add(self.around)

    def visit(self, node):
        if not isinstance(node, (*FUNCTION, ast.ClassDef)):
            return super().visit(node)
        for decorator in node.decorator_list:
            self.visit(decorator)
        name = ".".join([*(self.around[-1][1:] if self.around else ()), node.name])
        outside = self.around
        if (self.module, name) in self.defined:
            self.around = (*outside, (self.module, name))
            if isinstance(node, ast.ClassDef) and any(self._is_foreign(base) for base in node.bases):
                self.offered_to_others.add((self.module, name))
        for child in ast.iter_child_nodes(node):
            if child not in node.decorator_list:
                self.visit(child)
        self.around = outside
        return None

    def _is_foreign(self, base):
        """Is a base of another package, which calls what its heirs define?"""
        return isinstance(base, ast.Attribute) and isinstance(base.value, ast.Name) and base.value.id not in self.names

    def visit_Name(self, node):
        if isinstance(node.ctx, ast.Load):
            self._use(self.module, node.id)

    def visit_ImportFrom(self, node):
        for alias in node.names:
            self._use(node.module, alias.name)

    def visit_Attribute(self, node):
        of = self.names.get(node.value.id) if isinstance(node.value, ast.Name) else None
        self._use(of, node.attr)
        self.generic_visit(node)

    def visit_Constant(self, node):
        if isinstance(node.value, str) and node.value.isidentifier():
            self._use("text", node.value)

    def visit_Call(self, node):
        if isinstance(node.func, ast.Name) and node.func.id == "getattr" and len(node.args) > 1:
            of, pattern = node.args[0], _pattern(node.args[1])
            if pattern != ANY:
                self.patterns.setdefault(pattern, set()).add(self.around)
            elif isinstance(of, ast.Name) and of.id in self.names:
                self.by_name.add(self.names[of.id])
        self.generic_visit(node)

    def unused(self):
        """{(module, name): lines} of what nothing uses that is used itself, from the code outside definitions on."""
        used = set()
        while more := {place for place in self.defined if place not in used and self._is_used(place, used)}:
            used |= more
        return {place: lines for place, lines in self.defined.items() if place not in used}

    def _is_used(self, place, used):
        module, name = place
        owner, _, word = name.rpartition(".")
        if word.startswith("pytest_"):      # a hook
            return True
        if owner and (word.startswith("__") or (module, owner) in self.offered_to_others):
            return (module, owner) in used
        if module.startswith(self.package + ".api.") and word in self.door:
            return not owner or (module, owner) in used
        by_name = module in self.by_name or module.removeprefix(self.package + ".").startswith(FACES)
        ways = [self.found.get((module, word), ())] if not owner else []
        ways += [self.found.get((of, word), ()) for of in (None, "text") if owner or by_name]
        named = (uses for pattern, uses in self.patterns.items() if re.fullmatch(pattern, word))
        return any(used.issuperset(around) for uses in chain(ways, named) for around in uses)


def _modules_named(nodes, modules):
    """{name in a file: module of the package}."""
    found = {}
    for node in nodes:
        if isinstance(node, ast.ImportFrom):
            found |= {alias.asname or alias.name: f"{node.module}.{alias.name}" for alias in node.names
                      if f"{node.module}.{alias.name}" in modules}
        elif isinstance(node, ast.Import):
            found |= {alias.asname: alias.name for alias in node.names if alias.asname and alias.name in modules}
    return found


def _pattern(node):
    """The names that a text put together may be, as a regular expression."""
    if isinstance(node, ast.Constant):
        return re.escape(str(node.value))
    if isinstance(node, ast.JoinedStr):
        return "".join(map(_pattern, node.values))
    if isinstance(node, ast.BinOp):
        return _pattern(node.left) + _pattern(node.right)
    return ANY
