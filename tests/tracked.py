"""The files of the project, for the tests that read sources: layers, words, format."""
import os
import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
C_FILES = (".h", ".c", ".cpp")


def tracked(*endings):
    """Paths from the root of the files that git tracks or would track. A copy without git is walked instead."""
    command = ["git", "-C", ROOT, "ls-files", "-z", "--cached", "--others", "--exclude-standard"]
    try:
        found = subprocess.run(command, capture_output=True, text=True, check=True).stdout.split("\0")
    except (OSError, subprocess.CalledProcessError):
        found = walked()
    return sorted({name for name in found if name.endswith(endings) and (ROOT / name).is_file()})


def walked():
    for folder, below, files in os.walk(ROOT):
        below[:] = [name for name in below if not name.startswith((".", "build", "__pycache__"))]
        yield from ((Path(folder) / name).relative_to(ROOT).as_posix() for name in files)
