"""Files and folders that the scripts of a repository write: `mkdir -p`, `> path`, `cp`, `git clone … path`, `-o`."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator
from functools import cached_property, lru_cache
from itertools import pairwise

from ...files import PackageFiles
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.launch.joined_path import OPEN
from .container_files import BARE, OF_CONTAINER, OF_WORKFLOW, SHELL, files_called
from .shell_words import WORD, ShellWords

SCRIPTS = regex(r"(?i)\.(?:sh|bash|zsh|mk)$|(?:^|/)(?:makefile|justfile)$")
CONTINUED = regex(r"\\\n\s*")
COMMENT = regex(r"(?m)(?:^|(?<=\s))#[^\n]*")
COMMANDS = regex(r"\n|;|&&|\|\|?|(?<![>&\d])&(?![>&])|\b(?:do|then|else)\s|(?<=\s)[({]\s")
REDIRECTED = regex(rf"(?<![-=<])(?:\d|&)?>>?\|?[ \t]*(?![&(])({WORD.pattern})")
GIVEN = regex(rf"(?:^|\s)(?:-o|-O|--[\w-]*out(?:put)?(?:[-_](?:file|path|dir|folder))?)(?:[ \t]+|=)({WORD.pattern})")
"""Options of most programs for what they write: `-o a.urdf`, `--python_out=src`."""
FIRST = frozenset("sudo RUN exec time env run: run - -- @ command eval ! { ( if while".split())
"""What stands before a program."""
MAKERS, MOVERS = frozenset("mkdir touch tee".split()), frozenset("cp mv ln rsync install scp".split())
INTO = {"unzip": "-d", "tar": "-C", "wget": "-P", "cp": "-t", "mv": "-t", "ln": "-t"}
"""The option of a program for the folder that it writes into."""
URL = regex(r"(?:\w+://|git@)\S+/([\w.-]+?)(?:\.git)?/?(?:[?#]\S*)?")
CREATES_PACKAGE = "ros2 pkg create"
"""A script with it shows how the package was made."""
STEPS = frozenset({"cd", "pushd", "WORKDIR"})


@dataclass(frozen=True)
class ScriptOutputs:
    """Rule input: the paths that scripts of the repository write, each from where it is written."""

    files: PackageFiles
    names: frozenset[str] = frozenset()
    """How scripts outside may call the folder of the package."""

    def has(self, path: str, *, is_folder: bool = False) -> bool:
        """Return whether a script writes a file of the package, or a folder or something in it."""
        wanted = tuple(posixpath.normpath(path).split("/"))
        return any(self.fits(parts, wanted, is_own, is_folder) for parts, is_own in self.written)

    def fits(self, parts: tuple[str, ...], wanted: tuple[str, ...], is_own: bool, is_folder: bool) -> bool:
        here = tuple(self.files.folder.split("/")) if self.files.folder else ()
        starts = [(*here, *wanted), *((name, *wanted) for name in self.names)]
        starts += [wanted] if is_own or not here else []
        for start in starts:
            for at in range(len(parts) - len(start) + 1):
                is_whole = is_folder or len(parts) == at + len(start)
                is_led = start[0] in self.names or all(each in ("..", OPEN) for each in parts[:at])
                if is_whole and is_led and all(map(may_be, parts[at:], start)):
                    return True
        return False

    @cached_property
    def written(self) -> frozenset[tuple[tuple[str, ...], bool]]:
        """The parts of each path, and whether it is one of a script of the package itself."""
        start = f"{self.files.folder}/" if self.files.folder else ""
        found = set[tuple[tuple[str, ...], bool]]()
        for path, text in scripts_of(self.files):
            for each in outputs(text):
                found.add((parts_of(each), path.startswith(start)))
        return frozenset(found)


def parts_of(path: str) -> tuple[str, ...]:
    """Return the parts of a path; "/" is the first of one that leads elsewhere from everywhere."""
    parts = (part for part in posixpath.normpath(path).split("/") if part not in ("", "."))
    return ("/", *parts) if path.startswith("/") else tuple(parts)


def may_be(pattern: str, part: str) -> bool:
    """Return whether a part of a path, of which something is known, may be another one."""
    if OPEN not in pattern:
        return pattern == part
    stem = posixpath.splitext(pattern)[0].replace(OPEN, "").strip("._-")
    return bool(stem) and re.fullmatch(".*".join(map(re.escape, pattern.split(OPEN))), part) is not None


def scripts_of(files: PackageFiles) -> Iterator[tuple[str, str]]:
    """Yield the scripts, containers and workflows of the repository with their paths."""
    for whole, path in files_called(files, SCRIPTS, OF_CONTAINER, OF_WORKFLOW, BARE):
        text = whole.readable_text(path)
        if not BARE.search(path) or SCRIPTS.search(path) or OF_CONTAINER.search(path) or SHELL.match(text):
            yield path, text


@lru_cache(maxsize=512)
def outputs(text: str) -> tuple[str, ...]:
    """Return the paths that a script writes; each missing file asks for those of all scripts."""
    return () if CREATES_PACKAGE in text else tuple(dict.fromkeys(written_in(text)))


def written_in(text: str) -> Iterator[str]:
    """Yield the paths that a script writes, from where it starts and from where its steps have led."""
    text = COMMENT.sub("", CONTINUED.sub(" ", text))
    words, here = ShellWords(text), ""
    for command in COMMANDS.split(text):
        given = WORD.findall(REDIRECTED.sub("", command))
        while given and (given[0] in FIRST or re.match(r"\w+=", given[0])):
            given = given[1:]
        if given[1:] and given[0] in STEPS:
            here = posixpath.join(here, words.of(given[1])[0])
        found = [*REDIRECTED.findall(command), *GIVEN.findall(command)]
        found += written_by(posixpath.basename(given[0]).lstrip("@-"), given[1:]) if given else []
        for each in (value for word in found for value in words.of(word)):
            yield each
            if here:
                yield posixpath.join(here, each)


def written_by(program: str, words: list[str]) -> list[str]:
    """Return the words of a command, and paths made of them, that it writes."""
    plain = [each for each in words if not each.startswith("-")]
    folder = next((after for option, after in pairwise(words) if option == INTO.get(program)), "")
    if program in MAKERS:
        return plain
    if program in MOVERS and (folder or plain[1:]):
        folder, sources = (folder, plain) if folder else (plain[-1], plain[:-1])
        return [folder, *(f"{folder}/{posixpath.basename(unended(each))}" for each in sources)]
    if program in ("wget", "curl", "git"):
        return fetched_by(program, words, folder)
    return [folder] if folder else []


def fetched_by(program: str, words: list[str], folder: str) -> list[str]:
    """Return what is fetched from the web: into the folder that stands behind its address, or under its own name."""
    if program == "git" and "clone" not in words[:3]:
        return []
    found = list[str]()
    for word, after in zip(words, [*words[1:], ""], strict=True):
        if match := URL.fullmatch(unended(word.strip("\"'"))):
            is_given = program == "git" and after and not after.startswith("-")
            found.append(after if is_given else posixpath.join(folder, match[1]))
    return found


def unended(word: str) -> str:
    return word.rstrip("\"'").rstrip("/")
