"""Keeps identifiers that gave way to better ones out of the code. The list, and how to write it: tests/words.txt.

    python3 tests/words/words.py                old names that stand in the code, a line each; exit code 1 if any do
    python3 tests/words/words.py --self-test    plants old names in memory and checks that each is found
"""
import re
import sys
from fnmatch import fnmatchcase
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from tracked import C_FILES, ROOT, tracked  # noqa: E402

LIST = ROOT / "tests" / "words.txt"

# What a C++ file consists of, as far as names are concerned. The first alternative that fits counts.
TOKEN = re.compile(r"""
    (?P<include>  ^[ \t]*\#[ \t]*include\b[^\n]*)
  | (?P<comment>  //(?:\\\n|[^\n])*  |  /\*.*?(?:\*/|\Z))
  | (?P<raw>      (?:u8|[uUL])?R"(?P<mark>[^()\\\s]{0,16})\(.*?\)(?P=mark)")
  | (?P<string>   (?:u8|[uUL])?"(?:\\.|[^"\\\n])*")
  | (?P<number>   \.?[0-9](?:'?[0-9A-Za-z_.]|(?<=[eEpP])[+-])*)
  | (?P<letter>   (?:u8|[uUL])?'(?:\\.|[^'\\\n])+')
  | (?P<name>     [A-Za-z_][A-Za-z0-9_]*)
""", re.X | re.S | re.M)


def names(text):
    """(line, name) of every name in the code: neither in comments nor in literals."""
    line, seen = 1, 0
    for token in TOKEN.finditer(text):
        if token.lastgroup == "name":
            line += text.count("\n", seen, token.start())
            seen = token.start()
            yield line, token["name"]


def read_list(text):
    """Lines of the list: old names as (where, old, new), exempt ones as (where, word); and what is wrong with it."""
    old_names, exempt, faults = [], [], []
    for number, line in enumerate(text.splitlines(), 1):
        words = line.split("#")[0].split()
        if words[:1] == ["exempt"] and len(words) >= 4:
            exempt.append((words[1], words[2]))
        elif words[:1] != ["exempt"] and len(words) == 3:
            old_names.append(tuple(words))
        elif words:
            faults.append(f"tests/words.txt:{number} is neither `WHERE OLD NEW` nor `exempt WHERE WORD REASON`")
    return old_names, exempt, faults


def list_faults(old_names, exempt, files):
    """Lines of the list that can find nothing."""
    faults = [f"tests/words.txt: no file fits {where}" for where in sorted({where for where, *_ in old_names + exempt})
              if not any(fnmatchcase(file, where) for file in files)]
    faults += [f"tests/words.txt: {old} and {new} end in the same word" for _, old, new in old_names
               if last_part(old) == last_part(new)]
    return faults


def last_part(name):
    return name.split("::")[-1]


def word_faults(old_names, exempt, texts):
    """texts: source text by file. One line for every old name in the code."""
    faults = []
    for file, text in texts.items():
        spared = {word for where, word in exempt if fnmatchcase(file, where)}
        better = {last_part(old): (old, new) for where, old, new in old_names if fnmatchcase(file, where)}
        for line, name in names(text) if better else ():
            if name in better and name not in spared:
                faults.append(f"{file}:{line} says {name}: {better[name][0]} is now {better[name][1]}")
    return faults


PLANTED = r'''#include "contact/touch.h"
// touch in a comment \
   touch goes on
/* touch
   touch */
const char* key = "touch \" touch"; char quote = '"', touched = '\'';
const char* text = R"x(touch "touch" )" touch)x";
int million = 1'000'000, hex = 0xtouch; double small = 1e-3;
int untouched = touch_count;
int found = drape::touch;  // line 10
#define FOUND(x) touch##x
'''


def self_test():
    old_names, exempt, failed = read_list("core/a.h drape::touch drape::contact  # why\n* drape_old drape_new\n"
                                          "exempt core/key.h touch a TOML key\nexempt core/key.h\ntwo words\n\n")
    if len(old_names) != 2 or exempt != [("core/key.h", "touch")] or len(failed) != 2:
        return [f"the list was read as {old_names}, {exempt}, {failed}"]
    texts = {"core/a.h": PLANTED, "core/b.h": "touch", "core/key.h": "touch drape_old"}
    found = word_faults(old_names + [("core/k*", "touch", "contact")], exempt, texts)
    planted = ["core/a.h:10 says touch: drape::touch is now drape::contact",
               "core/a.h:11 says touch: drape::touch is now drape::contact",
               "core/key.h:1 says drape_old: drape_old is now drape_new"]
    print(*(f"planted: {fault}" for fault in found), sep="\n")
    stale = list_faults(old_names + [("gone.h", "a", "b"), ("*", "a::c", "b::c")], exempt, texts)
    return [] if found == planted and len(stale) == 2 else [f"planted were {planted}", f"found were {found}, {stale}"]


def main():
    if sys.argv[1:] == ["--self-test"]:
        faults = self_test()
    elif len(sys.argv) > 1:
        sys.exit(__doc__)
    else:
        texts = {file: (ROOT / file).read_text(encoding="utf-8") for file in tracked(*C_FILES)}
        old_names, exempt, faults = read_list(LIST.read_text(encoding="utf-8"))
        faults += list_faults(old_names, exempt, texts) + word_faults(old_names, exempt, texts)
        print(f"{len(old_names)} old names, {len(texts)} files: {len(faults) or 'no'} faults")
    print(*faults, sep="\n", end="\n" if faults else "")
    sys.exit(bool(faults))


if __name__ == "__main__":
    main()
