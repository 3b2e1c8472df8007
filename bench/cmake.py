"""Does the CMake reader stand whatever real CMake files hold, and does it refuse what CMake refuses?

python -m bench.cmake FOLDER... [--mutations 2000] [--seed 1] [--cmake cmake] [--no-lint]

For every CMakeLists.txt and *.cmake below the folders: the tokens tile the text, commands and arguments lie in order
inside it, and the evaluation of its package ends without an exception.  Whether the text is CMake at all is asked of
the real CMake, on real files and on damaged ones: it reads a whole file before it runs any of it, and what it is given
begins with `return()`.  At last every checkout is linted: no rule may crash.  Exits with 1 where anything is amiss.
"""

from __future__ import annotations

import argparse
import json
import random
import subprocess
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Iterator, Sequence
from pathlib import Path

from rospkg_cli.disk import DiskTree
from rospkg_cli.engine.discovery.discover import packages_below
from rospkg_cli.files import PackageFiles
from rospkg_cli.languages.cmake.command_blocks import nest
from rospkg_cli.languages.cmake.lexer import tokens
from rospkg_cli.languages.cmake.parser import parse
from rospkg_cli.package.cmake.cmake_project import CMake
from rospkg_cli.package.package import Package
from rospkg_cli.source import Source

from .mutate import mutate

WORDS = (
    " ", "\n", "\t", "(", ")", "()", '"', "\\", "\\\n", "\\;", "#", "#[[", "[[", "]]", "[=[", "]=]", ";", "${x}", "${",
    "}", "$<1:a>", "$(MAKE)", "$", "@x@", "=", '-Da="b c"', '"a"', '"a"b', 'a"b"', "[[a]]b", "if(x)\n", "endif()\n",
    "else()\n", "elseif(y)\n", "foreach(i a b)\n", "endforeach()\n", "while(x)\n", "endwhile()\n", "function(f)\n",
    "endfunction()\n", "macro(m)\n", "endmacro()\n", "block()\n", "endblock()\n", "set(a b)\n", "set (a b)", "a b(c)\n",
    "AND", "\r", "é", "\u00a0", "\f", "\0",
)  # fmt: skip


def files_below(folder: Path) -> Iterator[tuple[Path, str]]:
    for path in sorted(folder.rglob("*")):
        if (path.name == "CMakeLists.txt" or path.suffix == ".cmake") and path.is_file():
            yield path, path.read_bytes().decode("utf-8", "replace").replace("\r\n", "\n")


def astray(text: str) -> str:
    """Return what is wrong with the spans of a text, "" if they tile it."""
    at = 0
    for token in tokens(text):
        if token.start != at or not token.text or text[at : token.end] != token.text:
            return f"token at {at}"
        at = token.end
    if at != len(text):
        return f"tokens end at {at} of {len(text)}"
    at = 0
    for command in parse(Source("CMakeLists.txt", text)).commands:
        named = text[command.name_span.start : command.name_span.end].lower() == command.name
        if not at <= command.span.start < command.span.end <= len(text) or not named:
            return f"command at {command.span}"
        inner = command.inner.start
        for argument in command.arguments:
            if not inner <= argument.span.start < argument.span.end <= command.inner.end:
                return f"argument at {argument.span}"
            inner = argument.span.end
        at = command.span.end
    return ""


def is_refused(text: str) -> bool:
    """Return whether our reader takes a text for CMake."""
    found = parse(Source("CMakeLists.txt", text))
    return bool(found.problems or nest(found.commands)[1])


def cmake_refuses(text: str, cmake: str, folder: Path) -> bool:
    """Return whether CMake itself does not read a text; it runs nothing of it."""
    file = folder / "asked.cmake"
    file.write_bytes(b"return()\n" + text.encode("utf-8", "replace"))
    done = subprocess.run([cmake, "-P", str(file)], capture_output=True, text=True, check=False, timeout=60)
    return done.returncode != 0 or "CMake Error" in done.stderr


def compare(title: str, texts: Sequence[tuple[str, str]], cmake: str) -> int:
    count: Counter[str] = Counter()
    with tempfile.TemporaryDirectory() as scratch:
        for name, text in texts:
            we, they = is_refused(text), cmake_refuses(text, cmake, Path(scratch))
            word = "differ" if we != they else "both refuse it" if we else "both take it"
            count[word] += 1
            if we != they:
                print(f"  {name}: {'we refuse' if we else 'CMake refuses'} it")
    print(f"{title}: " + ", ".join(f"{number} {what}" for what, number in sorted(count.items())))
    return count["differ"]


def evaluated(folders: Sequence[Path]) -> Counter[str]:
    """Evaluate every package, and count how that ends; an exception is let through."""
    count: Counter[str] = Counter()
    slowest = 0.0
    for package in (each for folder in folders for each in packages_below(folder)):
        begun = time.process_time()
        parts = Package(PackageFiles(DiskTree(package))).parts(CMake)
        slowest = max(slowest, time.process_time() - begun)
        for cmake in parts.good:
            count["packages"] += 1
            count["commands"] += len(cmake.calls)
            count["arguments"] += sum(len(call.words) for call in cmake.calls)
            count["arguments with a hole"] += sum("\0" in text for call in cmake.calls for text in call.texts)
            count["cut short"] += bool(cmake.stopped)
            count["read files that we can't see"] += cmake.reads_unknown_files
        count["broken"] += bool(parts.broken)
    print(
        "evaluated: " + ", ".join(f"{number} {what}" for what, number in count.items()) + f"; at most {slowest:.2f} s"
    )
    return count


def crashes(folder: Path) -> int:
    command = [sys.executable, "-m", "rospkg_cli", "lint", "--pedantic", "--jobs", "1", "--format", "json", str(folder)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    report = json.loads(done.stdout) if done.stdout else {"findings": []}
    crashed = [each for each in report["findings"] if each["code"] == "RPK005"]
    for each in crashed:
        print(f"  {folder.name}: {each['path']}: {each['message']}")
    return len(crashed) + (done.returncode == 3 and not crashed)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folders", nargs="+", type=Path)
    parser.add_argument("--mutations", type=int, default=2000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--cmake", default="cmake")
    parser.add_argument("--no-lint", action="store_true")
    options = parser.parse_args()
    real = [(str(path), text) for folder in options.folders for path, text in files_below(folder)]
    lists = sum(path.endswith("CMakeLists.txt") for path, _ in real)
    print(f"{lists} CMakeLists.txt and {len(real) - lists} other CMake files of {len(options.folders)} folders")
    chance = random.Random(options.seed)
    picked = [chance.choice(real) for _ in range(options.mutations)]
    damaged = [(f"{path} {number}", mutate(text, WORDS, chance)) for number, (path, text) in enumerate(picked)]
    odd = [(path, said) for path, text in real + damaged if (said := astray(text))]
    print(f"spans: {len(real) + len(damaged)} texts, {len(odd)} astray", *odd[:20], sep="\n  " if odd else "")
    wrong = len(odd) + compare("real", real, options.cmake) + compare("damaged", damaged, options.cmake)
    evaluated(options.folders)
    if not options.no_lint:
        crashed = sum(map(crashes, options.folders))
        print(f"linted: {crashed} crashes")
        wrong += crashed
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
