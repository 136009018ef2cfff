"""Types: public functions say what they take and what they give; the checker passes over none."""

import ast
import tomllib

from house.measure import PACKAGE

STRICT = ("disallow_untyped_defs", "disallow_incomplete_defs", "disallow_any_generics", "warn_return_any")


def settings():
    """Those of the checker."""
    return tomllib.loads((PACKAGE.parent / "pyproject.toml").read_text(encoding="utf-8"))["tool"]["mypy"]


def exceptions():
    """Modules that the checker passes over."""
    return [part["module"] for part in settings()["overrides"] if part.get("ignore_errors")]


def lenient(checker):
    """Modules in which one of the strict checks is left out."""
    return {module for part in checker["overrides"] if any(part.get(check, True) is False for check in STRICT)
            for module in ([part["module"]] if isinstance(part["module"], str) else part["module"])}


def public(body, prefix=""):
    """(name, node) of the public functions and methods of a file, within classes too."""
    for node in body:
        if isinstance(node, ast.ClassDef):
            yield from public(node.body, f"{prefix}{node.name}.")
        elif isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)) and not node.name.startswith("_"):
            yield prefix + node.name, node


def untyped(tree):
    """["name(parameter)"] of the public functions and methods of a file."""
    found = []
    for name, node in public(tree.body):
        args = node.args
        every = [*args.posonlyargs, *args.args, *args.kwonlyargs, *filter(None, (args.vararg, args.kwarg))]
        found.extend(f"{name}({arg.arg})" for arg in every
                     if arg.annotation is None and arg.arg not in ("self", "cls"))
    return found


def silent(tree):
    """The public functions and methods of a file that do not say what they give."""
    return [name for name, node in public(tree.body) if node.returns is None]


def test_public_functions_say_what_they_take(house):
    assert [f"{module}.{name}" for module, tree in house.trees.items() for name in untyped(tree)] == []


def test_public_functions_say_what_they_give(house):
    assert [f"{module}.{name}" for module, tree in house.trees.items() for name in silent(tree)] == []


def test_what_a_function_does_not_say_it_gives_is_seen():
    tree = ast.parse("def f(): pass\ndef g() -> int: pass\nclass A:\n    @property\n    def h(self): pass\n"
                     "    def _i(self):\n        def j(): pass")
    assert silent(tree) == ["f", "A.h"]


def test_an_untyped_parameter_is_seen():
    tree = ast.parse("def f(x: int, y, *z, _w=1): pass\nclass A:\n    def g(self, x): pass\n    def _h(self, x): pass")
    assert untyped(tree) == ["f(y)", "f(_w)", "f(z)", "A.g(x)"]


def test_the_checker_passes_over_no_module():
    assert exceptions() == []


def test_all_rooms_are_checked_strictly():
    checker = settings()
    assert all(checker[check] for check in STRICT)
    assert lenient(checker) == set()


def test_a_module_that_is_not_checked_strictly_is_seen():
    assert lenient({"overrides": [{"module": "a.*", "warn_return_any": False}, {"module": ["b", "c"], STRICT[0]: False},
                                  {"module": "d", STRICT[1]: True}, {"module": "e"}]}) == {"a.*", "b", "c"}


def test_the_package_says_that_it_has_types():
    assert (PACKAGE / "py.typed").exists()
