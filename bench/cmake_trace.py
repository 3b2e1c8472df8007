"""Do we say of CMake files what the real CMake does with them?

python -m bench.cmake_trace FOLDER... [--only NAME...] [--every 1] [--limit 100] [--off] [--verbose]

Every package that ament_cmake builds is configured by the real CMake in the world of cmake_world.py, with
`--trace-expand` and BUILD_TESTING on (and off, with --off).  Each command of the package that CMake ran is looked for
among those that we say it runs, at its line, with its arguments:

  equal      the same command with the same arguments
  unsure     ours has holes or may not run at all, and fits
  missed     CMake ran a command that is not in ours
  unseen     CMake ran a command of a file of which we say that we can't see it
  invented   we are sure of a command that CMake did not run (up to where its run ended)

and so for the facts that rules go by: targets, links, installs, packages that are looked for, components, interfaces.
"""

from __future__ import annotations

import argparse
import json
import re
import shutil
import sys
import tempfile
from collections import Counter, defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from rospkg_cli.engine.discovery.discover import packages_below
from rospkg_cli.languages.cmake.evaluated_command import EvaluatedCommand
from rospkg_cli.languages.cmake.list_text import split_list
from rospkg_cli.languages.cmake.values import BINARY, PREFIX, SOURCE, UNKNOWN, Word
from rospkg_cli.package.cmake.cmake_project import CMake

from .cmake_world import World, make_world, name_of, open_package

BLOCKS = frozenset("if elseif else endif foreach endforeach while endwhile function endfunction macro endmacro block "
                   "endblock".split())  # fmt: skip
FACTS = re.compile(
    r"install|project|find_package|add_(executable|library|subdirectory|custom_target|test)|target_\w+|"
    r"set_target_properties|ament_\w+|rclcpp_\w+|pluginlib_\w+|rosidl_\w+|generate_parameter_\w+|pybind11_\w+"
)
PYTHON = re.compile(r"(?:local/)?lib/python3(?:\.\d+)?/(?:site|dist)-packages")
ANYTHING = re.compile(f";?(?:{re.escape(UNKNOWN)})+;?")
"""A hole in a text: it may stand for no element of a list."""
Place = tuple[str, int, str]
"""File, line and name of a command."""


@dataclass
class Verdict:
    package: Path
    testing: bool
    ended: bool = True
    """Whether CMake came to the end of CMakeLists.txt."""
    count: Counter[str] = field(default_factory=Counter)
    facts: Counter[str] = field(default_factory=Counter)
    told: list[str] = field(default_factory=list)

    def note(self, word: str, name: str, text: str = "") -> None:
        self.count[word] += 1
        if FACTS.fullmatch(name):
            self.facts[word] += 1
        if text:
            self.told.append(f"{word:<9}{text}")


def traced(trace: Path, source: Path, build: Path, prefix: Path) -> Iterator[tuple[Place, tuple[str, ...]]]:
    """Yield the commands of a package that CMake ran; the folders are written as we write them."""
    for line in trace.read_text(encoding="utf-8", errors="replace").splitlines():
        entry = json.loads(line)
        if "cmd" in entry and Path(entry["file"]).is_relative_to(source) and entry["cmd"].lower() not in BLOCKS:
            path = Path(entry["file"]).relative_to(source).as_posix()
            args = (PYTHON.sub("lib/python", arg) for arg in entry["args"])
            replaced = (a.replace(str(source), SOURCE).replace(str(build), BINARY) for a in args)
            yield (path, entry["line"], entry["cmd"].lower()), tuple(a.replace(str(prefix), PREFIX) for a in replaced)


def fits(call: EvaluatedCommand, args: Sequence[str]) -> bool:
    """Return whether arguments, as many as are written, are such as our words leave open."""
    pairs = list(call.by_argument())
    return len(pairs) == len(args) and all(
        argument_fits(words, [arg] if argument.kind != "unquoted" else [each for each in split_list(arg) if each])
        for (argument, words), arg in zip(pairs, args, strict=True)
    )


def argument_fits(words: Sequence[Word], args: Sequence[str]) -> bool:
    reached = {0}
    """How many elements may be used up before the next word."""
    for word in words:
        pattern = re.compile(ANYTHING.sub(".*", re.escape(word.text)), re.DOTALL)
        after = set(reached) if word.maybe or (not word.text.strip(UNKNOWN) and not word.quoted) else set()
        for at in reached:
            more = len(args) - at if UNKNOWN in word.text and not word.quoted else 1
            for end in range(at + 1, min(len(args), at + more) + 1):
                if pattern.fullmatch(";".join(args[at:end])):
                    after.add(end)
        reached = after
    return len(args) in reached


def is_sure(call: EvaluatedCommand) -> bool:
    return not call.maybe and not any(word.maybe or UNKNOWN in word.text for word in call.words)


def compare(cmake: CMake, real: Sequence[tuple[Place, tuple[str, ...]]], verdict: Verdict) -> None:
    ours: dict[Place, list[int]] = defaultdict(list)
    for index, call in enumerate(cmake.calls):
        source = cmake.file(call.path).source
        if call.name not in BLOCKS and (verdict.testing or not call.testing):
            ours[(call.path, source.position(call.command.span.start)[0], call.name)].append(index)
    used: set[int] = set()
    missed = []
    for place, args in real:
        there = [i for i in ours[place] if i not in used or cmake.calls[i].maybe]
        near = sorted((i for i in there if fits(cmake.calls[i], args)), key=lambda i: not is_sure(cmake.calls[i]))
        if near:
            used.add(near[0])
            sure = is_sure(cmake.calls[near[0]])
            text = "" if sure else f"{place[0]}:{place[1]} {place[2]}{shown(cmake.calls[near[0]])}"
            verdict.note("equal" if sure else "unsure", place[2], text if FACTS.fullmatch(place[2]) else "")
        else:
            missed.append((place, args, [shown(cmake.calls[i]) for i in ours[place]]))
    last = max(used, default=-1)
    for place, args, instead in missed:
        seen = any(file.path == place[0] for file in cmake.files) or not cmake.reads_unknown_files
        verdict.note("missed" if seen else "unseen", place[2], f"{place[0]}:{place[1]} {place[2]}({' '.join(args)})"
                     + "".join(f"\n{'':13}ours: {each}" for each in instead[:3]))  # fmt: skip
    for place, indices in ours.items():
        for index in indices:
            if index not in used and index <= last and not cmake.calls[index].maybe:
                verdict.note("invented", place[2], f"{place[0]}:{place[1]} {place[2]}{shown(cmake.calls[index])}")


def shown(call: EvaluatedCommand) -> str:
    words = (word.text + ("?" if word.maybe else "") for word in call.words)
    text = "(" + " ".join(words) + ")" + (" maybe" if call.maybe else "")
    return text.replace(UNKNOWN, "∅").replace("\1", "~")


def judge(world: World, package: Path, testing: bool) -> Verdict | None:
    """Compare one package; None where CMake is not asked."""
    opened = open_package(package)
    cmake = opened.parts(CMake).only
    if cmake is None or not cmake.ends_a_package:
        return None
    verdict = Verdict(package, testing)
    with tempfile.TemporaryDirectory(dir=world.scratch) as folder:
        scratch = Path(folder)
        source, trace, prefix = scratch / "src" / name_of(opened), scratch / "trace", scratch / "install"
        shutil.copytree(package, source, symlinks=True, ignore_dangling_symlinks=True)
        names = {file.path.rpartition("/")[2] for file in cmake.files}
        done = world.configure(
            source, scratch / "build", f"-DBUILD_TESTING={'ON' if testing else 'OFF'}", "--trace-expand",
            "--trace-format=json-v1", f"--trace-redirect={trace}", f"-DCMAKE_INSTALL_PREFIX={prefix}",
            *(f"--trace-source={name}" for name in sorted(names)),
        )  # fmt: skip
        real = list(traced(trace, source, scratch / "build", prefix))
        lines = [place[1] for place, _ in real if place[0] == "CMakeLists.txt"]
        ends = [call for call in cmake.calls if call.path == "CMakeLists.txt" and not call.function and not call.maybe]
        ends = [call for call in ends if testing or not call.testing]
        end = cmake.root.source.position(ends[-1].command.span.start)[0] if ends else 0
        verdict.ended = max(lines, default=0) >= end
        if not verdict.ended:
            said = done.stderr.partition("CMake Error")[2]
            verdict.told.append("ended at " + " ".join(said.split())[:200])
        compare(cmake, real, verdict)
    return verdict


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folders", nargs="+", type=Path)
    parser.add_argument("--only", nargs="*", default=[], help="names of packages")
    parser.add_argument("--every", type=int, default=1, help="take each n-th package")
    parser.add_argument("--limit", type=int, default=sys.maxsize)
    parser.add_argument("--off", action="store_true", help="with BUILD_TESTING off, too")
    parser.add_argument("--verbose", action="store_true")
    options = parser.parse_args()
    verdicts: list[Verdict] = []
    with tempfile.TemporaryDirectory() as scratch:
        world = make_world(Path(scratch), options.folders)
        packages = [p for folder in options.folders for p in packages_below(folder.resolve())]
        packages = [p for p in packages if (p / "CMakeLists.txt").is_file()]
        picked = [p for p in packages if p.name in options.only] if options.only else packages[:: options.every]
        for package in picked[: options.limit]:
            for testing in (True, False) if options.off else (True,):
                verdict = judge(world, package, testing)
                if verdict is not None:
                    verdicts.append(verdict)
                    tell(verdict, options.verbose)
        print("commands that nobody defines here: " + ", ".join(sorted(world.commands)))
    return summary(verdicts)


def tell(verdict: Verdict, verbose: bool) -> None:
    wrong = verdict.count["missed"] + verdict.count["invented"]
    if verbose or wrong:
        figures = ", ".join(f"{number} {word}" for word, number in verdict.count.items())
        print(f"{verdict.package} (BUILD_TESTING {'on' if verdict.testing else 'off'}): {figures}")
        for line in (line for line in verdict.told if verbose or not line.startswith(("unsure", "unseen"))):
            print("    " + line.replace("\1", "~"))
        sys.stdout.flush()


def summary(verdicts: Sequence[Verdict]) -> int:
    packages = {verdict.package for verdict in verdicts}
    whole = {verdict.package for verdict in verdicts if verdict.ended} - {v.package for v in verdicts if not v.ended}
    print(f"{len(packages)} packages of {len({p.parts[:4] for p in packages})} repositories, {len(verdicts)} runs; "
          f"{len(whole)} packages run to their end")  # fmt: skip
    wrong = 0
    for title, counts in (("commands", [v.count for v in verdicts]), ("of them facts", [v.facts for v in verdicts])):
        count = sum(counts, Counter[str]())
        ran = sum(count.values()) - count["invented"]
        print(f"{title}: {ran} run by CMake, " + ", ".join(
            f"{count[word]} {word} ({count[word] / max(ran, 1):.2%})"
            for word in ("equal", "unsure", "unseen", "missed", "invented")
        ))  # fmt: skip
        wrong = count["missed"] + count["invented"]
    faultless = sum(not v.facts["missed"] and not v.facts["invented"] for v in verdicts)
    print(f"{faultless} of {len(verdicts)} runs without a fact missed or invented")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
