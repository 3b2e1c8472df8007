"""`file`: GLOB is evaluated over the package's files, the output of other forms is unknown."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator, Sequence

from ...light_dataclasses import replace
from .evaluated_command import EvaluatedCommand
from .interpreter import Interpreter
from .regex import glob
from .values import SOURCE, UNKNOWN, Word

OUTPUTS = {"READ": 1, "STRINGS": 1, "RELATIVE_PATH": 0, "TO_CMAKE_PATH": 1, "TO_NATIVE_PATH": 1, "REAL_PATH": 1,
           "SIZE": 1, "TIMESTAMP": 1, "READ_SYMLINK": 1, "MD5": 1, "SHA1": 1, "SHA256": 1}  # fmt: skip


def run_file(interpreter: Interpreter, call: EvaluatedCommand) -> None:
    operation = "".join(call.texts[:1]).upper()
    if operation in ("GLOB", "GLOB_RECURSE"):
        run_glob(interpreter, call, recurse=operation == "GLOB_RECURSE")
    elif operation in OUTPUTS and len(call.words) > OUTPUTS[operation] + 1:
        interpreter.set(call.texts[OUTPUTS[operation] + 1], interpreter.unknown())


def run_glob(interpreter: Interpreter, call: EvaluatedCommand, recurse: bool) -> None:
    """Set a variable to what the patterns match, each path with the position of its pattern."""
    words = list(call.words[2:])
    relative: Word | None = None
    patterns: list[Word] = []
    folders = not recurse
    while words:
        word = words.pop(0)
        if word.text == "RELATIVE" and words:
            relative = words.pop(0)
        elif word.text == "LIST_DIRECTORIES" and words:
            folders = words.pop(0).text.lower() in ("true", "on", "1")
        elif word.text not in ("CONFIGURE_DEPENDS", "FOLLOW_SYMLINKS"):
            patterns.append(word)
    if len(call.words) < 2:
        return
    base = interpreter.path(relative.text) if relative else None
    found: list[Word] = []
    for pattern in patterns:
        paths = matching_paths(interpreter, pattern, recurse, folders)
        if paths is None or (relative and base is None):
            found.append(replace(pattern, text=UNKNOWN))
        else:
            found += [replace(pattern, text=path_as_written(path, base)) for path in paths]
    interpreter.set(call.texts[1], tuple({word.text: word for word in found}.values()))


def matching_paths(interpreter: Interpreter, pattern: Word, recurse: bool, folders: bool) -> list[str] | None:
    path = interpreter.path(pattern.text)
    if path is None:
        return None
    candidates: Sequence[str] = interpreter.places if folders else interpreter.files.every
    interpreter.spend(len(candidates) >> 1)
    if not recurse:
        return glob(path, candidates)
    folder, last = posixpath.split(path)
    return match_recursively(interpreter, folder, last, candidates)


def match_recursively(interpreter: Interpreter, folder: str, last: str, candidates: Sequence[str]) -> list[str] | None:
    """Return the paths that match the last part of a pattern, at any depth below the folders that match the rest."""
    roots = [""] if not folder else glob(folder, interpreter.places)
    names = glob(last, {posixpath.basename(path) for path in candidates})
    if roots is None or names is None:
        return None
    interpreter.spend(len(roots) * len(candidates) >> 3)
    wanted = set(names)
    return list(dict.fromkeys(p for p in paths_below(roots, candidates) if posixpath.basename(p) in wanted))


def paths_below(roots: Sequence[str], paths: Sequence[str]) -> Iterator[str]:
    prefixes = tuple(f"{root}/" if root else "" for root in roots)
    return (path for path in paths if path.startswith(prefixes))


def path_as_written(path: str, base: str | None) -> str:
    return posixpath.join(SOURCE, path) if base is None else posixpath.relpath(path, base or ".")
