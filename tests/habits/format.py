"""Whether all C and C++ files are as clang-format leaves them, by .clang-format and in the pinned version.

    .venv/bin/python tests/habits/format.py [FILE ...]           files that are not, a line each; exit code 1 if any is not
    .venv/bin/python tests/habits/format.py --fix [FILE ...]     formats them

Without files, all that git tracks.
"""
import argparse
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from habits.pinned import pinned  # noqa: E402
from tracked import C_FILES, ROOT, tracked  # noqa: E402


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--fix", action="store_true")
    parser.add_argument("files", nargs="*", metavar="FILE")
    options = parser.parse_args()
    tool, files = pinned("clang-format"), options.files or [str(ROOT / file) for file in tracked(*C_FILES)]
    if options.fix:
        sys.exit(subprocess.run([tool, "-i", *files]).returncode)
    said = subprocess.run([tool, "--dry-run", *files], capture_output=True, text=True).stderr
    faults = sorted({line.split(":")[0].removeprefix(f"{ROOT}/") for line in said.splitlines()
                     if "[-Wclang-format-violations]" in line or ": error:" in line})
    print(*(f"{file} is not formatted" for file in faults), sep="\n", end="\n" if faults else "")
    print(f"{len(files)} files: {len(faults) or 'no'} faults" +
          ("; to format them: .venv/bin/python tests/habits/format.py --fix" if faults else ""))
    sys.exit(bool(faults))


if __name__ == "__main__":
    main()
