"""Tools in the version that tests/requirements-dev.txt names: another version formats and warns differently."""
import re
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
WANTED = ROOT / "tests" / "requirements-dev.txt"
INSTALL = ".venv/bin/python -m pip install -r tests/requirements-dev.txt"


def pinned(name):
    """The path of a tool: beside this Python, in .venv, or on the PATH. Ends the program where the version is another."""
    wanted = re.search(rf"^{name}==(\S+)$", WANTED.read_text(), re.M)[1]
    for folder in (Path(sys.executable).parent, ROOT / ".venv" / "bin", None):
        tool = shutil.which(name, path=folder)
        if tool:
            said = subprocess.run([tool, "--version"], capture_output=True, text=True).stdout
            if re.search(rf"version {re.escape(wanted)}\b", said):
                return tool
    sys.exit(f"{name} {wanted} is needed. To install it: {INSTALL}")
