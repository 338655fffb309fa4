"""The examples of contact end with checks of their own; a failed one is a non-zero exit code."""
import re
import subprocess
import sys

import pytest
from scenes import ROOT


@pytest.mark.parametrize("example, options", [
    ("incline", []), ("capstan", []), ("ball_net", []), ("cusick", ["--quick"]),
    ("skirt", ["--quick"]), ("dress", ["--quick"]), ("imported", ["--quick"]),
])
def test_example(tmp_path, example, options):
    folder = ROOT / "examples" / example
    done = subprocess.run([sys.executable, folder / "run.py", tmp_path, *options], capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
    pictures = list(tmp_path.glob("*.png"))
    assert pictures and all(file.stat().st_size < 150_000 for file in pictures)
    for picture in re.findall(r"!\[[^]]*\]\(([^)]+)\)", (folder / "README.md").read_text()):
        assert (folder / picture).stat().st_size < 150_000
