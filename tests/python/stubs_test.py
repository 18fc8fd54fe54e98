#!/usr/bin/python3
"""Compares the stubs of ixos._core with the module."""
import ast
import unittest

from support import ROOT, ixos, main

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

    def test_all_of_the_package_is_there(self):
        for name in ixos.__all__:
            self.assertTrue(hasattr(ixos, name), name)


if __name__ == "__main__":
    main()
