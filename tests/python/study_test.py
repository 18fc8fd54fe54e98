#!/usr/bin/python3
"""Studies in Python, also as the only rank of mpirun."""
import math

from support import BALL, DRIVER, FolderTest, ixos, main

STUDY = f"""<ParameterList name="Small">
  <Parameter name="Scene" type="string" value="{BALL}"/>
  <ParameterList name="Common">
    <Parameter name="Time Integrator/Time Step Control/Final Time" type="double" value="0.02"/>
    <Parameter name="Output/Fields Interval" type="int" value="0"/>
    <Parameter name="Output/Probes/Top/Point" type="Array(double)" value="{{0, 12.2547}}"/>
  </ParameterList>
  <ParameterList name="Axes">
    <ParameterList name="Time Step">
      <Parameter name="Parameter" type="string" value="Time Integrator/Time Step Control/Time Step"/>
      <Parameter name="Values" type="Array(string)" value="{{0.01, 0.005}}"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="Reference">
    <ParameterList name="Settings">
      <Parameter name="Time Integrator/Time Step Control/Time Step" type="double" value="0.001"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="Question">
    <Parameter name="Connect" type="string" value="Time Step"/>
  </ParameterList>
</ParameterList>
"""


class StudyTest(FolderTest):
    def study(self, text=STUDY):
        (self.folder / "small.xml").write_text(text)
        return ixos.Study(self.folder / "small.xml")

    def test_runs_and_their_errors(self):
        study, seen = self.study(), []
        self.assertEqual(study.axes, {"Time Step": ["0.01", "0.005"]})
        self.assertEqual([run["labels"] for run in study.runs], [["0.01"], ["0.005"]])
        done = study.run(self.folder / "out", DRIVER,
                         observer=lambda row, count, reused: seen.append((row["name"], reused)))
        self.assertEqual(seen, [(name, False) for name in ("reference", "reference-check", "0.01", "0.005")])
        self.assertEqual(list(done.table["status"]), ["completed", "completed"])
        self.assertEqual(list(done.table["steps"]), [2, 4])
        self.assertEqual(list(done.table["Time Step"]), ["0.01", "0.005"])
        self.assertTrue(all(math.isfinite(error) for error in done.table["error_position"]))
        self.assertTrue(done.recommendation)
        self.assertTrue((self.folder / "out/study.csv").is_file())
        seen.clear()
        study.run(self.folder / "out", DRIVER, observer=lambda row, count, reused: seen.append(reused))
        self.assertEqual(seen, [True] * 4)

    def test_results_of_another_study_stay(self):
        self.study().run(self.folder / "out", DRIVER)
        other = self.study(STUDY.replace("{0.01, 0.005}", "{0.01}").replace('name="Small"', 'name="Other"'))
        with self.assertRaisesRegex(ixos.InputError, 'the study "Small" of'):
            other.run(self.folder / "out", DRIVER)
        self.assertEqual(len(other.run(self.folder / "out", DRIVER, overwrite=True).table), 1)

    def test_refusals_name_the_file(self):
        with self.assertRaisesRegex(ixos.InputError, r"small\.xml: .*Tim Step.*did you mean"):
            self.study(STUDY.replace("Control/Time Step", "Control/Tim Step", 2))

    def test_an_observers_exception_ends_the_study(self):
        def stop(row, count, reused):
            raise KeyError(row["name"])

        with self.assertRaisesRegex(KeyError, "reference"):
            self.study().run(self.folder / "out", DRIVER, observer=stop)


if __name__ == "__main__":
    main()
