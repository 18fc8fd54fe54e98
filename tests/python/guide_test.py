#!/usr/bin/python3
"""Runs the code of docs/python.md, block after block, and examines what it made."""
import contextlib
import io
import os
import re
import warnings

from support import BALL, ROOT, FolderTest, ixos, main

PAGE = (ROOT / "docs/python.md").read_text(encoding="utf-8")


class GuideTest(FolderTest):
    def test_the_code_runs(self):
        (self.folder / "ball.xml").write_text(BALL.read_text())
        before = os.getcwd()
        os.chdir(self.folder)
        self.addCleanup(os.chdir, before)
        names, printed = {}, io.StringIO()
        with contextlib.redirect_stdout(printed), warnings.catch_warnings():
            warnings.simplefilter("ignore", ixos.SceneWarning)
            for block in re.findall(r"```python\n(.*?)```", PAGE, re.DOTALL):
                exec(compile(block, "docs/python.md", "exec"), names)  # pylint: disable=exec-used
        self.assertIn('there is no parameter "densty" here; did you mean "Density"?', printed.getvalue())
        self.assertIn("completed 50 ", printed.getvalue())
        self.assertEqual(len(names["lowest"]), 50)
        self.assertEqual(names["whole"].shape, (57, 2))

    def test_the_members_exist(self):
        simulation = ixos.Scene(BALL).simulation()
        table = PAGE.split("## Step by step")[1].split("## Meshes")[0]
        for cell in re.findall(r"^\| (`.*?) \|", table, re.MULTILINE):
            for name in re.findall(r"`(\w+)", cell):
                self.assertTrue(hasattr(simulation, name), name)


if __name__ == "__main__":
    main()
