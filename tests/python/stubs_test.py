#!/usr/bin/python3
"""Compares the stubs of ixos._core with the module."""
import ast
import inspect
import unittest

from support import ROOT, ixos, main

from ixos import stubs

STUBS = ast.parse((ROOT / "python/ixos/_core.pyi").read_text(encoding="utf-8"))


def names(body):
    """The public names that statements define."""
    found = {node.name for node in body if isinstance(node, (ast.ClassDef, ast.FunctionDef))}
    found |= {node.target.id for node in body if isinstance(node, ast.AnnAssign)}
    return {name for name in found if not name.startswith("_")}


def public(thing):
    return {name for name in vars(thing) if not name.startswith("_")}


class StubsTest(unittest.TestCase):
    def test_the_module_has_what_its_stubs_say(self):
        imported = {alias.name for node in STUBS.body if isinstance(node, ast.ImportFrom) for alias in node.names}
        self.assertEqual(names(STUBS.body), public(ixos._core) - imported)

    def test_each_class_has_what_its_stubs_say(self):
        for node in STUBS.body:
            if isinstance(node, ast.ClassDef) and not issubclass(getattr(ixos._core, node.name), Exception):
                kept = {"folder"} if node.name == "RunResult" else set()  # of an object, not of its class
                self.assertEqual(names(node.body) - kept, public(getattr(ixos._core, node.name)), node.name)

    def test_what_scripts_import_from_the_lists_has_a_stub(self):
        stubbed = ast.parse(stubs.text()).body
        there = {node.name for node in stubbed if isinstance(node, (ast.ClassDef, ast.FunctionDef))}
        there |= {target.id for node in stubbed if isinstance(node, ast.Assign) for target in node.targets}
        imported = {alias.name for file in (ROOT / "python/ixos").glob("*.py")
                    for node in ast.walk(ast.parse(file.read_text(encoding="utf-8")))
                    if isinstance(node, ast.ImportFrom) and node.level == 1 and node.module == "lists"
                    for alias in node.names}
        self.assertIn("SceneLists", imported)
        self.assertLessEqual(imported, there)

    def test_the_package_is_typed(self):
        kinds = [ixos.Fields, ixos.Results, ixos.Scene, ixos.Study, ixos.StudyResults]
        for name, thing in [(f"{kind.__name__}.{name}", thing) for kind in kinds for name, thing in vars(kind).items()]:
            thing = getattr(thing, "fget", getattr(thing, "func", getattr(thing, "__func__", thing)))
            if not inspect.isfunction(thing) or name.split(".")[1].startswith("_") and not name.endswith("__init__"):
                continue
            signature = inspect.signature(thing)
            bare = [word for word, parameter in signature.parameters.items()
                    if word not in ("self", "cls") and parameter.annotation is parameter.empty]
            self.assertEqual(bare, [], name)
            self.assertTrue(name.endswith("__init__") or signature.return_annotation is not signature.empty, name)

    def test_all_of_the_package_is_there(self):
        for name in ixos.__all__:
            self.assertTrue(hasattr(ixos, name), name)


if __name__ == "__main__":
    main()
