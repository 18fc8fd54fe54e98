#!/usr/bin/python3
"""Scenes in Python: completion, values, units, refusals with the command's text."""
import ast
import copy
import unittest

import numpy as np
from support import BALL, DRIVER, FolderTest, command, free_block, ixos, main

from ixos import lists, names, stubs


class ListsTest(unittest.TestCase):
    def test_completion_shows_the_valid_parameters(self):
        scene = ixos.Scene(BALL)
        self.assertLessEqual({"mesh", "materials", "time_integrator", "run", "simulation"}, set(dir(scene)))
        self.assertIn("youngs_modulus", dir(scene.materials.Ball))
        self.assertIn("Ball", scene.materials._ipython_key_completions_())
        self.assertIn("Young's Modulus", scene.materials.Ball._ipython_key_completions_())
        self.assertIn("Young's modulus", type(scene.materials.Ball).youngs_modulus.__doc__)

    def test_names_and_identifiers_are_one_parameter(self):
        scene = ixos.Scene(BALL)
        scene.materials.Ball.density = 1e-6
        self.assertEqual(scene["Materials/Ball/Density"], 1e-6)
        scene["Materials/Ball/Density"] = 2
        self.assertEqual(scene.materials["Ball"].density, 2.0)
        self.assertIn("Materials/Ball/Density", scene)
        del scene["Materials/Ball/Density"]
        self.assertNotIn("Materials/Ball/Density", scene)
        scene.interactions["Wall"].contact_element = "Q1C4"
        self.assertEqual(list(scene.interactions), ["Wall"])

    def test_what_is_not_given_has_its_default(self):
        scene = ixos.Scene()
        self.assertEqual(scene.mesh.type, "Disk")
        scene.mesh.type = "Box"
        scene.mesh.type = None
        self.assertEqual(scene.mesh.type, "Disk")
        self.assertIsNone(scene.histories["Motion"].rate_ramp.rate)  # must be given

    def test_every_value_comes_back(self):
        scene = ixos.Scene()
        scene.mesh.box.lengths = (0.1, 2)
        scene.mesh.box.divisions = [8, 4]
        scene.output.energies = False
        scene.output.reactions = ["left", "right"]
        scene["Linear Solver/Belos/Tolerance"] = 1e-9
        back = ixos.Scene.parse(scene.xml())
        self.assertEqual(back.mesh.box.lengths, [0.1, 2.0])
        self.assertEqual(back.mesh.box.divisions, [8, 4])
        self.assertIs(back.output.energies, False)
        self.assertEqual(back.output.reactions, ["left", "right"])
        self.assertEqual(back["Linear Solver/Belos/Tolerance"], 1e-9)
        self.assertEqual(back.as_dict(), scene.as_dict())

    def test_values_of_numpy(self):
        scene = ixos.Scene()
        scene.mesh.box.lengths = np.array([0.1, 2])
        scene.mesh.disk.rings = np.int64(3)
        scene.output.energies = np.bool_(False)
        scene.materials["Rubber"].density = np.float64(1) / 3
        self.assertEqual(scene.mesh.box.lengths, [0.1, 2.0])
        self.assertEqual(scene.mesh.disk.rings, 3)
        self.assertIs(scene.output.energies, False)
        self.assertEqual(scene.materials.Rubber.density, 1 / 3)

    def test_numbers_have_units(self):
        scene = free_block()
        scene.materials.Rubber.youngs_modulus = "3 GPa"  # of 2 GPa, the scene's unit
        scene.mesh.box.lengths = "{4, 2} um"
        complete = scene.complete()
        self.assertEqual(complete.materials.Rubber.youngs_modulus, 1.5)
        self.assertEqual(complete.mesh.box.lengths, [4000.0, 2000.0])

    def test_a_copy_is_independent(self):
        scene = free_block()
        for other in (scene.copy(), copy.copy(scene), copy.deepcopy(scene)):
            self.assertIsInstance(other, ixos.Scene)
            self.assertEqual(other.as_dict(), scene.as_dict())
            other.materials.Rubber.density = 7
            self.assertEqual(scene.materials.Rubber.density, 3.0)


class CatalogueTest(unittest.TestCase):
    def walk(self, kind):
        yield kind
        for inner in kind._classes.values():
            yield from self.walk(inner)

    def test_identifiers_are_distinct_and_hide_no_function(self):
        for kind in self.walk(lists.SceneLists):
            known = [*kind._description["parameters"], *(name for name in kind._classes if name != "<any name>")]
            identifiers = [names.identifier(name) for name in known]
            self.assertEqual(len(set(identifiers)), len(known), kind)
            for word in identifiers:
                self.assertTrue(word.isidentifier(), word)
                self.assertFalse(hasattr(lists.List, word), word)
        for word in lists.SceneLists._identifiers:
            self.assertNotIn(word, vars(ixos.Scene), word)

    def test_every_parameter_is_documented(self):
        for kind in self.walk(lists.SceneLists):
            for name, entry in kind._description["parameters"].items():
                self.assertIn(entry["documentation"], getattr(kind, names.identifier(name)).__doc__)
                self.assertTrue(entry["documentation"], name)

    def test_stubs_have_every_parameter(self):
        classes = {node.name: node for node in ast.parse(stubs.text()).body if isinstance(node, ast.ClassDef)}
        for kind in self.walk(lists.SceneLists):
            fields = {node.target.id for node in classes[kind.__name__].body if isinstance(node, ast.AnnAssign)}
            self.assertEqual(fields, set(kind._identifiers), kind)


class RefusalTest(FolderTest):
    def refusal(self, call):
        with self.assertRaises(ixos.InputError) as caught:
            call()
        return f"ixos: {caught.exception}\n"

    def test_assignments_are_refused_with_the_commands_words(self):
        for path, value in (("Materials/Ball/Densty", 1), ("Materials/Ball/Density", "heavy"),
                            ("Meterials/Ball/Density", 1), ("Mesh/Disk/Rings", 1.5),
                            ("Materials/Ball/Young's Modulus", "2 MPaa")):
            scene = ixos.Scene(BALL)
            status, words = command(BALL, "--set", f"{path}={value}", "--check")
            self.assertEqual(status, 2)
            self.assertEqual(self.refusal(lambda: scene.__setitem__(path, value)), words)

    def test_scenes_are_refused_with_the_commands_words(self):
        for path, value in (("Materials/Ball/Density", -1), ("Materials/Ball/Poisson's Ratio", 0.5),
                            ("Materials/Ball/Young's Modulus", "2 nm"), ("Time Integrator/Type", "Newmarck"),
                            ("Interactions/Wall/Side Set", "surfase"),
                            ("Time Integrator/Time Step Control/Final Time", -1)):
            scene = ixos.Scene(BALL)
            scene[path] = value
            file = self.folder / "scene.xml"
            scene.write(file)
            status, words = command(file, "--check")
            self.assertEqual(status, 2)
            self.assertEqual(self.refusal(ixos.Scene(file).simulation), words)

    def test_files_are_refused_with_the_commands_words(self):
        broken = self.folder / "broken.xml"
        broken.write_text("<ParameterList><Parameter name='a' type='int' value='x'/></ParameterList>")
        for file in (self.folder / "absent.xml", broken):
            self.assertEqual(self.refusal(lambda: ixos.Scene(file)), command(file)[1])

    def test_dictionaries_are_refused_as_xml_is(self):
        scene = free_block()
        scene.mesh = {"Type": "Disk", "Box": {"Lengths": [1, 1]}}
        words = self.refusal(scene.simulation)
        self.assertIn('"Box" belongs to Type "Box", but Type is "Disk"', words)
        self.assertIn("did you mean", self.refusal(lambda: ixos.Scene({"Materials": {"Rubber": {"Densty": 1}}})))
        self.assertIn("did you mean", self.refusal(lambda: ixos.Scene({"Meterials": {}})))

    def test_a_refused_change_leaves_no_trace(self):
        scene = free_block()
        before = scene.as_dict()
        for call in (lambda: scene.materials["Steel"].__setattr__("densty", 1),
                     lambda: scene.__setattr__("materials", {"Rubber": {"Density": 2, "Densty": 1}}),
                     lambda: scene.set("Output/Energies=false", "Output/Energy=false")):
            self.assertIn("did you mean", self.refusal(call))
            self.assertEqual(scene.as_dict(), before)

    def test_a_default_needs_a_valid_name(self):
        scene = free_block()
        before = scene.as_dict()
        for call, words in ((lambda: setattr(scene.output, "energis", None), 'did you mean "Energies"'),
                            (lambda: scene.__setitem__("Outptu/Energies", None), 'did you mean "Output"'),
                            (lambda: scene.__setitem__("Outptu", None), '"Outptu"'),
                            (lambda: scene.__setitem__("Output", {"Energis": None}), 'did you mean "Energies"')):
            self.assertIn(words, self.refusal(call))
        self.assertEqual(scene.as_dict(), before)
        for name in ("Output/Energies", "Output/Probes", "Output", "Materials/Steel", "Materials/Steel/Density"):
            scene[name] = None  # valid names that the scene does not give
        scene.output = {"Energies": None}
        self.assertEqual(scene.as_dict(), {**before, "Output": {}})

    def test_elements_must_come_back(self):
        scene = free_block()
        for element in ("a, b", "{a", "a}", " a", "", [1, 2]):
            self.assertIn(f"Output/Reactions: the element {element!r} is not possible",
                          self.refusal(lambda: setattr(scene.output, "reactions", ["left", element])))
            self.assertIn(f"Output/Reactions: the element {element!r} is not possible",
                          self.refusal(lambda: setattr(scene, "output", {"Reactions": [element]})))
        self.assertNotIn("Output", scene)
        scene.output.reactions = ["upper left"]
        self.assertEqual(scene.output.reactions, ["upper left"])

    def test_lists_are_copied(self):
        scene = free_block()
        scene.materials["Steel"] = scene.materials.Rubber
        scene.materials.Rubber.density = 1
        self.assertEqual(scene.as_dict()["Materials"], {"Rubber": {"Density": 1.0}, "Steel": {"Density": 3.0}})

    def test_unknown_attributes(self):
        scene = free_block()
        with self.assertRaisesRegex(AttributeError, "there are: .*density"):
            scene.materials.Rubber.densty
        with self.assertRaisesRegex(ixos.InputError, 'did you mean "Density"'):
            scene.materials.Rubber.densty = 1
        self.assertFalse(hasattr(scene, "_repr_html_"))
        with self.assertRaises(TypeError):
            scene.materials.Rubber.density = object()


if __name__ == "__main__":
    if DRIVER == "ixos":
        print("IXOS_DRIVER names no command: its words cannot be compared")
    main()
