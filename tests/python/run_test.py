#!/usr/bin/python3
"""Runs with results on disk: equal to the command's, observed, interrupted, refused, resumed."""
import os
import signal
import warnings

import numpy as np
from support import BALL, FolderTest, command, free_block, ixos, main


def short_ball():
    return ixos.Scene(BALL).set("Time Integrator/Time Step Control/Final Time=0.05", "Output/Fields Interval=0")


class RunTest(FolderTest):
    def test_a_run_is_the_commands_run(self):
        scene = short_ball()
        scene.write(self.folder / "scene.xml")
        done = ixos.Scene(self.folder / "scene.xml").run(self.folder / "python")
        self.assertEqual(done.status, "completed")
        self.assertEqual(done.steps, 50)
        status, _ = command(self.folder / "scene.xml", "--output", self.folder / "command", "--quiet")
        self.assertEqual(status, 0)
        mine, other = done.results, ixos.results(self.folder / "command")
        self.assertEqual(mine.columns, other.columns)
        for column in mine.columns:
            if column != "wall_seconds":
                np.testing.assert_array_equal(mine[column], other[column], column)
        self.assertEqual(mine.scene.as_dict(), other.scene.as_dict())
        self.assertEqual(mine.summary["scheme"], "Average Vector Field")
        self.assertEqual(mine.history.dtype["step"], np.int64)

    def test_the_folder_is_named_after_the_scene(self):
        free_block(steps=2).write(self.folder / "block.xml")
        before = os.getcwd()
        os.chdir(self.folder)
        self.addCleanup(os.chdir, before)
        ixos.Scene("block.xml").run()
        self.assertEqual(len(ixos.results("block.results")["time"]), 3)
        with self.assertRaisesRegex(ValueError, "output"):
            free_block().run()

    def test_measures_are_those_of_the_history(self):
        seen = []

        def look(simulation):
            seen.append({**simulation.energies, "min_gap": simulation.contact["min_gap"],
                         "linear_momentum_y": simulation.linear_momentum[1]})

        done = short_ball().run(self.folder / "run", observer=look)
        self.assertEqual(len(seen), 50)
        for name in seen[0]:
            np.testing.assert_allclose([row[name] for row in seen], done.results[name][1:], rtol=1e-14, atol=1e-18)

    def test_numbers_have_the_names_of_the_history(self):
        scene = short_ball().set("Output/Probes/tip/Point={0, 7}")
        seen = []
        done = scene.run(self.folder / "run", observer=lambda simulation: seen.append(simulation.row()))
        table = done.results
        self.assertLess({"time", "contact_force_y", "tip_uy", "tip_vx", "min_gap", "total_energy"}, set(seen[0]))
        self.assertEqual(set(table.columns) - set(seen[0]),
                         {"step", "time_step", "newton_iterations", "linear_iterations", "wall_seconds"})
        for name in seen[0]:
            np.testing.assert_array_equal([row[name] for row in seen], table[name][1:], name)
        simulation = scene.simulation()
        self.assertEqual(simulation["contact_force_y"], table["contact_force_y"][0])
        with self.assertRaisesRegex(ixos.InputError, 'column "contact_force" does not exist; did you mean "contact_force_.?"'):
            simulation["contact_force"]  # pylint: disable=pointless-statement

    def test_progress_is_told_within_steps_too(self):
        seen = []
        done = short_ball().run(self.folder / "run", progress=lambda p: seen.append((p.within_step, p.iteration, p.residual, p.bound)))
        self.assertEqual(sum(1 for within, *_ in seen if not within), done.steps)
        self.assertEqual(sum(1 for _, iteration, *_ in seen if iteration > 0), done.newton_iterations)
        for before, after in zip(seen, seen[1:]):
            if not after[0]:  # the step ended
                self.assertLessEqual(before[2], before[3])

    def test_an_observer_sees_each_stage(self):
        scene = short_ball()
        scene.set("Stages/Fall/Time Integrator/Time Step Control/Final Time=0.02",
                  "Stages/Rise/Time Integrator/Type=Newmark",
                  "Stages/Rise/Time Integrator/Time Step Control/Final Time=0.03")
        seen = []
        done = scene.run(self.folder / "run", observer=lambda s: seen.append((s.time, s.scheme, s.energies["kinetic_energy"])))
        self.assertEqual([scheme for _, scheme, _ in seen], 20 * ["Average Vector Field"] + 30 * ["Newmark"])
        np.testing.assert_allclose([time for time, _, _ in seen], done.results["time"][1:])
        np.testing.assert_allclose([energy for _, _, energy in seen], done.results["kinetic_energy"][1:], rtol=1e-14)
        self.assertEqual([stage["name"] for stage in done.results.summary["stages"]], ["Fall", "Rise"])

    def test_an_observer_may_remove_itself(self):
        def once(simulation):
            seen.append(simulation.time)
            simulation.observers.remove(once)

        seen = []
        self.assertEqual(short_ball().run(self.folder / "run", observer=once).steps, 50)
        self.assertEqual(seen, [0.001])

    def test_an_observers_exception_ends_the_run_with_a_checkpoint(self):
        def stop(simulation):
            if simulation.time > 0.0195:
                raise KeyError("enough")

        scene = short_ball()
        with self.assertRaisesRegex(KeyError, "enough"):
            scene.run(self.folder / "run", observer=stop)
        self.assertEqual(ixos.results(self.folder / "run").summary["status"], "interrupted")
        whole = scene.run(self.folder / "whole")
        resumed = scene.run(self.folder / "run", restart=self.folder / "run/checkpoint.h5")
        self.assertEqual(resumed.steps, 50)
        for column in ("kinetic_energy", "min_gap"):
            np.testing.assert_array_equal(resumed.results[column], whole.results[column])

    def test_a_restart_leaves_views_valid(self):
        for settings in ((), ("Materials/Ball/Density=6e-7",)):  # a changed scene resumes from u and v alone
            scene = short_ball().set("Time Integrator/Type=Bathe Composite")
            checkpoint = scene.run(self.folder / "run", overwrite=True).checkpoint
            simulation, places = scene.set(*settings).simulation(), set()
            for _ in range(4):
                simulation.step(0.001)
                places |= {simulation.u.ctypes.data, simulation.v.ctypes.data, simulation.a.ctypes.data}
            self.assertEqual(len(places), 6)
            simulation.run(self.folder / "other", restart=checkpoint, overwrite=True)
            self.assertAlmostEqual(simulation.time, 0.05)
            self.assertLessEqual({simulation.u.ctypes.data, simulation.v.ctypes.data, simulation.a.ctypes.data}, places)

    def test_control_c_ends_the_run(self):
        def press(simulation):
            if len(pressed) < 5:
                pressed.append(simulation.time)
            else:
                os.kill(os.getpid(), signal.SIGINT)

        pressed = []
        with self.assertRaises(KeyboardInterrupt):
            short_ball().run(self.folder / "run", observer=press)
        self.assertEqual(ixos.results(self.folder / "run").summary["steps"], 6)

    def test_results_of_another_scene_stay(self):
        scene = short_ball()
        scene.run(self.folder / "run")
        scene.materials.Ball.density = 1e-6
        with self.assertRaisesRegex(ixos.InputError, "results of another scene"):
            scene.run(self.folder / "run")
        self.assertEqual(scene.run(self.folder / "run", overwrite=True).status, "completed")

    def test_runs_are_refused_with_the_commands_words(self):
        folder, file, damaged = self.folder / "run", self.folder / "scene.xml", self.folder / "damaged.h5"
        scene = short_ball()
        scene.run(folder)
        scene.materials.Ball.density = 1e-6
        scene.write(file)
        damaged.write_text("no checkpoint")
        absent = self.folder / "absent.h5"
        for kind, status, options, arguments in (
                (ixos.InputError, 2, ["--output", folder], {"output": folder}),
                (ixos.InputError, 2, ["--output", folder, "--restart", absent], {"output": folder, "restart": absent}),
                (ixos.InputError, 2, ["--output", folder, "--restart", damaged],
                 {"output": folder, "restart": damaged}),
                (ixos.FileError, 4, ["--output", file], {"output": file})):
            with self.assertRaises(kind) as caught:
                ixos.Scene(file).run(**arguments)
            done, words = command(file, *options)
            self.assertEqual((done, words.splitlines()[-1]), (status, f"ixos: {caught.exception}"))

    def test_a_run_that_fails_is_warned_of(self):
        scene = short_ball()
        scene.nonlinear_solver.maximum_iterations = 1
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            done = scene.run(self.folder / "run")
        self.assertEqual(done.status, "diverged")
        self.assertTrue(any("the run ended at t = 0 T0, after 0 steps" in str(w.message) for w in caught))

    def test_lines_are_told(self):
        lines = []
        done = free_block(steps=4).run(self.folder / "run", log=lines.append)
        self.assertEqual(done.jumps, {"count": 0, "released": 0, "largest": 0})
        free_block(steps=4).run(self.folder / "run", log=lines.append, restart=self.folder / "run")
        self.assertTrue(any(line.startswith("Resumes from") for line in lines), lines)

    def test_warnings_have_the_commands_words(self):
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            simulation = free_block().simulation()
        self.assertEqual([str(warning.message) for warning in caught], simulation.warnings)
        self.assertIn("the density is", simulation.warnings[0])
        self.assertTrue(issubclass(caught[0].category, ixos.SceneWarning))


class ResultsTest(FolderTest):
    def test_an_empty_cell_is_nan_and_a_cut_row_is_left_out(self):
        (self.folder / "history.csv").write_text("step,time,min_gap\n0,0,\n1,0.5,2.25\n2,1.")
        results = ixos.results(self.folder)
        np.testing.assert_array_equal(results["step"], [0, 1])
        np.testing.assert_array_equal(results["min_gap"], [np.nan, 2.25])
        self.assertEqual(results.summary, {})
        with self.assertRaisesRegex(KeyError, "it has: step, time, min_gap"):
            results["gap"]

    def test_missing_and_damaged_files_are_refused(self):
        with self.assertRaisesRegex(ixos.FileError, "history.csv does not exist"):
            ixos.results(self.folder)
        (self.folder / "history.csv").write_text("step,time\n0,x\n1,1\n")
        with self.assertRaisesRegex(ixos.FileError, "history.csv: could not convert"):
            ixos.results(self.folder)


if __name__ == "__main__":
    main()
