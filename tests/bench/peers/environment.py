"""An environment of the peers' packages under build/, made where it is missing or its list has changed."""
import os
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
BUILD = HERE.parents[2] / "build"


def run_in(name, requirements):
    """Runs this script again in build/<name>, with the packages of a file; one that cannot be installed is left out."""
    folder, wanted = BUILD / name, (HERE / requirements).read_text()
    if pathlib.Path(sys.prefix) == folder:
        return
    python, installed = folder / "bin" / "python", folder / requirements
    if not installed.exists() or installed.read_text() != wanted:
        subprocess.run([sys.executable, "-m", "venv", folder], check=True)
        install = [python, "-m", "pip", "install", "--quiet", "-c", HERE / requirements]
        if subprocess.run([*install, "-r", HERE / requirements]).returncode != 0:
            for line in filter(lambda line: line and not line.startswith("#"), wanted.splitlines()):
                if subprocess.run([*install, line]).returncode != 0:
                    print(f"{line}: could not be installed", file=sys.stderr)
        installed.write_text(wanted)
    os.execv(python, [str(python), *sys.argv])
