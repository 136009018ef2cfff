"""Types: public functions say what they take, and the checker passes over no room."""

import ast
import tomllib

from house.measure import PACKAGE


def exceptions():
    """Modules that the checker passes over."""
    settings = tomllib.loads((PACKAGE.parent / "pyproject.toml").read_text(encoding="utf-8"))["tool"]["mypy"]
    return [part["module"] for part in settings["overrides"] if part.get("ignore_errors")]


def untyped(tree):
    """["name(parameter)"] of the public functions and methods of a file."""
    found = []

    def visit(body, prefix):
        for node in body:
            if isinstance(node, ast.ClassDef):
                visit(node.body, f"{prefix}{node.name}.")
            elif isinstance(node, ast.FunctionDef) and not node.name.startswith("_"):
                args = node.args
                every = [*args.posonlyargs, *args.args, *args.kwonlyargs, *filter(None, (args.vararg, args.kwarg))]
                found.extend(f"{prefix}{node.name}({arg.arg})" for arg in every
                             if arg.annotation is None and arg.arg not in ("self", "cls"))
    visit(tree.body, "")
    return found


def test_public_functions_say_what_they_take(house):
    assert [f"{module}.{name}" for module, tree in house.trees.items() for name in untyped(tree)] == []


def test_an_untyped_parameter_is_seen():
    tree = ast.parse("def f(x: int, y, *z, _w=1): pass\nclass A:\n    def g(self, x): pass\n    def _h(self, x): pass")
    assert untyped(tree) == ["f(y)", "f(_w)", "f(z)", "A.g(x)"]


def test_the_checker_passes_over_no_module():
    assert exceptions() == []


def test_the_package_says_that_it_has_types():
    assert (PACKAGE / "py.typed").exists()
