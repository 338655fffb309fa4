"""clang-tidy, by .clang-tidy and in the pinned version, over what has changed.

    .venv/bin/python tests/habits/tidy.py                changed since origin/main; without one, or on it, since HEAD~1
    .venv/bin/python tests/habits/tidy.py --base REV     changed since a commit
    .venv/bin/python tests/habits/tidy.py --all          every source that is built
    .venv/bin/python tests/habits/tidy.py FILE ...       these

A header is read through a source that includes it. Needs build/compile_commands.json, so a configured build; --build names
another folder. Exit code 1 if anything is found.
"""
import argparse
import json
import os
import re
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from habits.pinned import pinned  # noqa: E402
from tracked import C_FILES, ROOT, tracked  # noqa: E402


def git(*arguments):
    done = subprocess.run(["git", "-C", ROOT, *arguments], capture_output=True, text=True)
    return done.stdout.strip() if done.returncode == 0 else None


def changed(base):
    """C and C++ files that differ from a commit, in the work tree too."""
    if base is None:
        base = git("merge-base", "HEAD", "origin/main")
        if base in (None, git("rev-parse", "HEAD")):
            base = "HEAD~1"
    names = git("diff", "--name-only", "--diff-filter=d", base)
    if names is None:
        sys.exit(f"{base} is no commit here")
    return [name for name in names.splitlines() if name.endswith(C_FILES)]


def own_first(header, includer):
    """Sorts the source that goes with a header before all others."""
    return Path(includer).stem != Path(header).stem, includer


def sources_of(files, built):
    """The built sources through which all of the files are read, and the headers that no built source includes."""
    includers = {}
    for name in tracked(*C_FILES):
        for header in re.findall(r'^[ \t]*#[ \t]*include[ \t]*"([^"\n]+)"', (ROOT / name).read_text(encoding="utf-8"), re.M):
            includers.setdefault(Path(header).name, []).append((header, name))
    sources, unread = set(), []
    for file in files:
        found, seen = [file], {file}
        for name in found:  # grows: by what includes the file, and what includes that
            if name in built:
                sources.add(name)
                break
            for header, includer in sorted(includers.get(Path(name).name, []), key=lambda pair: own_first(name, pair[1])):
                if name.endswith("/" + header.lstrip("./")) and includer not in seen:
                    seen.add(includer)
                    found.append(includer)
        else:
            unread.append(file)
    return sorted(sources), unread


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--all", action="store_true")
    parser.add_argument("--base", metavar="REV")
    parser.add_argument("--build", type=Path, default=ROOT / "build", metavar="DIR")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("files", nargs="*", metavar="FILE")
    options = parser.parse_args()
    tool, commands = pinned("clang-tidy"), options.build / "compile_commands.json"
    if not commands.exists():
        sys.exit(f"{commands} is missing: run `cmake --preset release`")
    entries = (Path(entry["directory"], entry["file"]) for entry in json.loads(commands.read_text()))
    built = {str(file.relative_to(ROOT)) for file in entries if file.is_relative_to(ROOT)} & set(tracked(*C_FILES))
    if options.all:
        sources, unread = sorted(built), []
    else:
        files = [os.path.relpath(file, ROOT) for file in options.files] or changed(options.base)
        sources, unread = sources_of(files, built)
    print(*(f"{file} is not read: no built source has it" for file in unread), sep="\n", end="\n" if unread else "")

    def read(source):
        return subprocess.run([tool, "--quiet", "-p", options.build, ROOT / source], capture_output=True, text=True)

    found, failed = {}, []
    with ThreadPoolExecutor(options.jobs) as pool:
        for source, done in zip(sources, pool.map(read, sources)):
            told = False
            for finding in re.split(r"^(?=\S+:\d+:\d+: (?:warning|error):)", done.stdout, flags=re.M):
                # a header's finding comes with every source; one in a library's header is about the library
                own = finding.startswith(str(ROOT)) or ": error:" in finding.split("\n")[0]
                told |= own
                if own and finding not in found:
                    found[finding] = True
                    print(finding.replace(f"{ROOT}/", "").rstrip(), flush=True)
            if done.returncode != 0 and not told:
                failed.append(source)
                print(f"{source}: clang-tidy ended with {done.returncode}", done.stdout + done.stderr, sep="\n", flush=True)
    print(f"{len(sources)} sources: {len(found) or 'no'} findings" + (f", {len(failed)} not read" if failed else ""))
    sys.exit(bool(found or failed))


if __name__ == "__main__":
    main()
