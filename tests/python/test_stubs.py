"""The stub of the C++ module says what the module has, no more and no less."""

import ast
import inspect

import icespar
from icespar import _core

# What pybind11 adds by itself.
ADDED = {"name", "value"}


def public(names):
    return {name for name in names if not name.startswith("_") or name in ("__version__", "__eq__", "__call__")}


def stub_names(body):
    for node in body:
        if isinstance(node, ast.ClassDef | ast.FunctionDef):
            yield node.name
        elif isinstance(node, ast.AnnAssign):
            yield node.target.id
        elif isinstance(node, ast.Assign):
            yield node.targets[0].id


def test_the_stub_names_everything_in_the_module(root):
    tree = ast.parse((root / "python/icespar/_core.pyi").read_text())
    assert public(stub_names(tree.body)) == public(vars(_core))
    for node in tree.body:
        if not isinstance(node, ast.ClassDef) or node.name == "Error":
            continue
        real = public(vars(getattr(_core, node.name)))
        if "Enum" in map(ast.unparse, node.bases):
            real -= ADDED
        if "__eq__" not in set(stub_names(node.body)):
            real -= {"__eq__"}
        assert set(stub_names(node.body)) - {"__init__"} == real, node.name


def test_the_stub_has_the_functions_arguments(root):
    tree = ast.parse((root / "python/icespar/_core.pyi").read_text())
    for node in tree.body:
        if isinstance(node, ast.FunctionDef):
            names = [a.arg for a in (*node.args.args, *node.args.kwonlyargs)]
            signature = getattr(_core, node.name).__doc__.splitlines()[0]
            places = [signature.find(f"{name}:") for name in names]
            assert -1 not in places and places == sorted(places), (node.name, signature)
            assert signature.split("->")[0].count(":") == len(names), signature


def test_everything_public_has_a_docstring_and_is_listed():
    for name in icespar.__all__:
        assert name == "__version__" or inspect.getdoc(getattr(icespar, name)), name
