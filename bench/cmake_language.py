"""Does our evaluator run random programs as CMake runs them?

python -m bench.cmake_language [--programs 2000] [--seed 1] [--cmake cmake] [--show 10]

Programs of variables, lists, strings, conditions, loops, functions and macros are made at random, run by
`cmake -P --trace-expand`, and every command that ran is compared with ours, as in cmake_trace.py.  Lists in square
brackets, which CMake parts otherwise, are left out.  What we leave unsure is counted.  Exits with 1 where more than
two commands in a hundred are missed or invented.
"""

from __future__ import annotations

import argparse
import random
import re
import subprocess
import sys
import tempfile
from collections import Counter
from collections.abc import Sequence
from pathlib import Path

from rospkg_cli.example import manifest
from rospkg_cli.files import PackageFiles
from rospkg_cli.package.cmake.cmake_project import CMake
from rospkg_cli.package.package import Package
from rospkg_cli.tree import MemoryTree

from .cmake_trace import Verdict, compare, traced

SECONDS = 20
NAMES = ("a", "b", "c", "d")
TEXTS = (
    "x", "y", "z1", "src/a.cpp", "b.hpp", "", '""', '"x;y"', "x;y", '"x y"', "${a}", "${b}", '"${c}"', '"${a};${b}"',
    "${d}/x", "pre${a}", "${${e}}", "\\;", "ON", "OFF", "0", "1", "2", "-1", "NOTFOUND", "TRUE",
    '"a\\"b"', "x\\ y", "a", "b", "A-B_c",
)  # fmt: skip
PATTERNS = ("x", ".", "^x", "[xy]+", "(x|y)", "\\\\.cpp$", "([a-z]+)/", "z?1", "")
TESTS = (
    "{t}", "NOT {t}", "{n}", "NOT {n}", "{t} STREQUAL {t}", "{n} STREQUAL {t}", "{t} MATCHES \"{r}\"",
    "{n} IN_LIST {n}",
    "x IN_LIST {n}", "DEFINED {n}", "{n} EQUAL 1", "{t} LESS 2", "{n} AND {n}", "{n} OR NOT ({t})",
    "1.2 VERSION_LESS 1.10",
    "\"$({n})\" STREQUAL \"\"", "{n} VERSION_GREATER_EQUAL 1", "EXISTS \"$(CMAKE_CURRENT_SOURCE_DIR)/nothing\"",
)  # fmt: skip
LINES = (
    "set({n} {t})", "set({n} {t} {t})", "set({n})", "unset({n})", "set({n} $({n}) {t})", "set({n} {t} PARENT_SCOPE)",
    "set({n}_{n} {t})", "list(APPEND {n} {t} {t})", "list(PREPEND {n} {t})", "list(REMOVE_ITEM {n} {t})",
    "list(REMOVE_DUPLICATES {n})", "list(LENGTH {n} {n})", "list(GET {n} 0 {n})", "list(JOIN {n} {t} {n})",
    "list(REVERSE {n})", "list(SORT {n})", "list(FIND {n} {t} {n})", "list(SUBLIST {n} 0 1 {n})",
    "list(INSERT {n} 0 {t})",
    "list(POP_BACK {n} {n})", "list(POP_FRONT {n})", "list(FILTER {n} INCLUDE REGEX \"{r}\")", "list(REMOVE_AT {n} 0)",
    "list(TRANSFORM {n} APPEND {t})", "list(TRANSFORM {n} PREPEND {t})", "list(TRANSFORM {n} TOUPPER)",
    "list(TRANSFORM {n} REPLACE \"{r}\" \"q\")", "string(TOUPPER {t} {n})", "string(REPLACE x q {n} {t})",
    "string(REPLACE \";\" \" \" {n} \"$({n})\")", "string(REGEX REPLACE \"{r}\" \"q\" {n} {t})",
    "string(REGEX MATCH \"{r}\" {n} {t})", "string(REGEX MATCHALL \"{r}\" {n} {t})", "string(CONCAT {n} {t} {t})",
    "string(APPEND {n} {t})", "string(LENGTH {t} {n})", "string(SUBSTRING abcdef 1 2 {n})", "string(STRIP {t} {n})",
    "string(JOIN - {n} {t} {t})", "string(FIND {t} x {n})", "string(MAKE_C_IDENTIFIER {t} {n})",
    "get_filename_component({n} src/a.b.cpp NAME_WE)", "get_filename_component({n} {t} NAME)",
    "math(EXPR {n} \"1 + 2\")",
    "get_filename_component({n} {t} DIRECTORY)", "separate_arguments({n})", "f({t} {t})", "g({t} {t})", "f({t})",
    "cmake_parse_arguments(P \"FLAG\" \"ONE\" \"MANY\" FLAG {t} ONE {t} {t} MANY {t} {t})",
    "echo({n} $(P_ONE) $(P_MANY))",
    "echo($({n}))", "echo(\"$({n})\" {t})", "echo($(P_UNPARSED_ARGUMENTS) $(P_FLAG))", "option({n}_o \"\" ON)",
)  # fmt: skip
HEAD = """cmake_minimum_required(VERSION 3.20)
function(echo)
endfunction()
function(f p)
  echo(${p} ${ARGN} ${ARGC} ${ARGV0})
  set(a ${p} PARENT_SCOPE)
endfunction()
macro(g p)
  echo(${p} ${ARGN} "${ARGV}" ${ARGC})
  set(b ${ARGN})
endmacro()
set(e a)
"""


def program(chance: random.Random) -> str:
    return HEAD + "".join(statements(chance, 0, chance.randint(4, 14))) + "echo(${a} | ${b} | ${c} | ${d})\n"


def statements(chance: random.Random, depth: int, count: int) -> list[str]:
    found = []
    for _ in range(count):
        kind, indent = chance.random() if depth < 3 else 1.0, "  " * depth
        if kind < 0.12:
            other = f"{indent}else()\n{body(chance, depth)}" if chance.random() < 0.5 else ""
            found.append(f"{indent}if({filled(chance, TESTS)})\n{body(chance, depth)}{other}{indent}endif()\n")
        elif kind < 0.2:
            over = filled(chance, ("{t} {t}", "IN LISTS {n}", "IN ITEMS {t} {t}", "RANGE 2", "$({n})"))
            begin = f"{indent}foreach(i {over})\n{indent}  echo(${{i}})\n"
            found.append(f"{begin}{body(chance, depth)}{indent}endforeach()\n")
        else:
            found.append(f"{indent}{filled(chance, LINES)}\n")
    return found


def body(chance: random.Random, depth: int) -> str:
    return "".join(statements(chance, depth + 1, chance.randint(1, 4)))


def filled(chance: random.Random, templates: Sequence[str]) -> str:
    """Return a template with a name for each {n}, a text for each {t}, and a pattern for each {r}."""
    text = re.sub(r"\$\((.*?)\)", r"${\1}", chance.choice(templates))
    for mark, choices in (("{n}", NAMES), ("{t}", TEXTS), ("{r}", PATTERNS)):
        while mark in text:
            text = text.replace(mark, chance.choice(choices), 1)
    return text


def judge(text: str, cmake: str, folder: Path) -> Verdict:
    source, trace = folder / "src", folder / "trace"
    source.mkdir(exist_ok=True)
    (source / "CMakeLists.txt").write_text(text)
    command = [cmake, "--trace-expand", "--trace-format=json-v1", f"--trace-redirect={trace}", "-P", "CMakeLists.txt"]
    try:
        subprocess.run(command, cwd=source, capture_output=True, check=False, timeout=SECONDS)
    except subprocess.TimeoutExpired:  # loops over what loops made long
        return Verdict(source, True, ended=False)
    files = MemoryTree.of({"package.xml": manifest(build_type="ament_cmake"), "CMakeLists.txt": text})
    (ours,) = Package(PackageFiles(files)).parts(CMake).good
    verdict = Verdict(source, True)
    compare(ours, list(traced(trace, source, Path("/bench/build"), Path("/bench/prefix"))), verdict)
    return verdict


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--programs", type=int, default=2000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--cmake", default="cmake")
    parser.add_argument("--show", type=int, default=10)
    options = parser.parse_args()
    chance = random.Random(options.seed)
    count: Counter[str] = Counter()
    shown = 0
    with tempfile.TemporaryDirectory() as folder:
        for number in range(options.programs):
            text = program(chance)
            verdict = judge(text, options.cmake, Path(folder).resolve())
            count += verdict.count
            if verdict.count["missed"] + verdict.count["invented"]:
                count["wrong programs"] += 1
                if shown < options.show:
                    shown += 1
                    print(f"---- program {number}\n{text[len(HEAD) :]}----")
                    print("\n".join(line for line in verdict.told if not line.startswith("unsure")))
    print(f"{options.programs} programs: " + ", ".join(f"{number} {word}" for word, number in count.most_common()))
    ran = count["equal"] + count["unsure"] + count["missed"]
    return 1 if count["missed"] + count["invented"] > ran / 50 else 0


if __name__ == "__main__":
    sys.exit(main())
