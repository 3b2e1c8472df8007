"""os.path, os, glob and pathlib over the package's folder. Paths are POSIX paths, whatever runs us."""

from __future__ import annotations

import posixpath
from collections.abc import Callable, Mapping

from .conversion import lift
from .iterables import pure
from .operators import clean, path_join
from .sandbox_filesystem import MAGIC, ROOT, OutsideError, SandboxFilesystem, fits
from .state import EvaluationState, Intrinsic
from .truthiness import truth
from .values import Call, Constant, Globbed, Opened, Sequence, Text, Value


def text_of(call: Call, name: str = "path", position: int = 0) -> str | None:
    value = call.get(name, position)
    return value.text if isinstance(value, Text) else None


def joined(machine: EvaluationState, call: Call) -> Value | None:
    return path_join(list(call.positional), call.span)


def absolute(machine: EvaluationState, call: Call) -> Value | None:
    text = text_of(call)
    return None if text is None else Text(call.span, posixpath.normpath(posixpath.join(machine.cwd, text)))


def relative(machine: EvaluationState, call: Call) -> Value | None:
    text, start = text_of(call), text_of(call, "start", 1)
    if text is None or (start is None and len(call.positional) > 1):
        return None
    here = posixpath.join(machine.cwd, text), posixpath.join(machine.cwd, start or "")
    return Text(call.span, posixpath.relpath(*here))


def asks(test: Callable[[SandboxFilesystem, str], bool]) -> Intrinsic:
    """Return the intrinsic of a question about one path; what lies outside of the package can't be told."""

    def intrinsic(machine: EvaluationState, call: Call) -> Value | None:
        text = text_of(call)
        try:
            return (
                None
                if text is None
                else Constant(call.span, test(machine.folder, machine.folder.inside(text, machine.cwd)))
            )
        except OutsideError:
            return None

    return intrinsic


def is_kind(kind: str) -> Callable[[SandboxFilesystem, str], bool]:
    def test(folder: SandboxFilesystem, path: str) -> bool:
        found = folder.kind(path)
        if found == "unknown":
            raise OutsideError
        return found == kind

    return test


def names(machine: EvaluationState, call: Call) -> Value | None:
    text = text_of(call)
    if text is None and call.arguments:
        return None
    try:
        inside = machine.folder.inside(text or ".", machine.cwd)
        found = machine.folder.names(inside) if machine.folder.kind(inside) == "dir" else None
    except OutsideError:
        return None
    return None if found is None else machine.new_list(call.span, [Text(call.span, name) for name in found])


def walked(machine: EvaluationState, call: Call) -> Value | None:
    text = text_of(call, "top")
    if text is None or call.get("topdown", 1) is not None:
        return None
    try:
        inside = machine.folder.inside(text, machine.cwd)
        rows = list(machine.folder.walk(inside)) if machine.folder.kind(inside) == "dir" else []
    except OutsideError:
        return None
    found: list[Value] = []
    for path, folders, files in rows:
        below = path[len(inside) :].lstrip("/")
        machine.tick(1 + len(folders) + len(files))
        found.append(lift((posixpath.join(text, below) if below else text, folders, files), call.span))
    return machine.new_list(call.span, found)


def globbed(machine: EvaluationState, call: Call) -> Value | None:
    pattern, recursive = text_of(call, "pathname"), call.get("recursive")
    flag = truth(recursive) if recursive else False
    if pattern is None or flag is None or call.rest or {a.name for a in call.arguments} - {"", "pathname", "recursive"}:
        return None
    try:
        found = machine.folder.glob(pattern, recursive=flag, cwd=machine.cwd)
    except OutsideError:
        return None
    return recorded(machine, call, pattern, found)


def recorded(machine: EvaluationState, call: Call, pattern: str, found: list[str], *, path: bool = False) -> Sequence:
    """Return the matches, and remember what the glob matched."""
    try:
        shown = machine.folder.inside(pattern, machine.cwd)
        matches = tuple(machine.folder.inside(each, machine.cwd) for each in found)
    except OutsideError:
        shown, matches = pattern, tuple(found)
    result = machine.new_list(call.span, [Text(call.span, each, path=path) for each in found])
    result.origin = Globbed(call.span, shown, matches, machine.certain)
    machine.globs.append(result.origin)
    return result


def path_glob(machine: EvaluationState, path: str, pattern: str) -> list[str]:
    """Return what pathlib's glob gives: hidden files fit as well, and a last `**` gives folders alone."""
    found = [machine.folder.inside(path, machine.cwd)]
    for part in [part for part in pattern.split("/") if part]:
        following: list[str] = []
        for each in found:
            machine.tick()
            if part == "**":
                following += [top for top, _, _ in machine.folder.walk(each)]
            elif MAGIC.search(part):
                following += [
                    posixpath.join(each, n)
                    for n in machine.folder.names(each)
                    if fits(n.lstrip("."), part) or fits(n, part)
                ]
            elif machine.folder.kind(posixpath.join(each, part)) is not None:
                following.append(posixpath.join(each, part))
        found = sorted(set(following))
    below = machine.folder.inside(path, machine.cwd)
    return [clean(posixpath.join(path, each[len(below) :].lstrip("/"))) for each in found]


def as_path(machine: EvaluationState, call: Call) -> Value | None:
    return path_join(list(call.positional) or [Text(call.span, ".")], call.span, path=True)


def changed_folder(machine: EvaluationState, call: Call) -> Value | None:
    text = text_of(call)
    if text is None:
        return None
    inside = posixpath.normpath(posixpath.join(machine.cwd, text))
    if inside != ROOT and not inside.startswith(ROOT + "/"):
        return None
    machine.cwd = inside
    return Constant(call.span, None)


def opened(machine: EvaluationState, call: Call) -> Value | None:
    text, mode = text_of(call, "file"), call.get("mode", 1)
    if text is None or (mode is not None and not (isinstance(mode, Text) and mode.text in ("r", "rt", "rU"))):
        return None
    try:
        inside = machine.folder.inside(text, machine.cwd)
    except OutsideError:
        return None
    return Opened(call.span, inside) if machine.folder.files.exists(inside) else None


PATHS: Mapping[str, Intrinsic] = {
    "os.path.join": joined,
    "os.path.abspath": absolute,
    "os.path.realpath": absolute,
    "os.path.relpath": relative,
    "os.path.dirname": pure(posixpath.dirname),
    "os.path.basename": pure(posixpath.basename),
    "os.path.split": pure(posixpath.split),
    "os.path.splitext": pure(posixpath.splitext),
    "os.path.normpath": pure(posixpath.normpath),
    "os.path.isabs": pure(posixpath.isabs),
    "os.path.commonpath": pure(posixpath.commonpath),
    "os.path.commonprefix": pure(posixpath.commonprefix),
    "os.path.exists": asks(lambda folder, path: folder.kind(path) is not None),
    "os.path.lexists": asks(lambda folder, path: folder.kind(path) is not None),
    "os.path.isfile": asks(is_kind("file")),
    "os.path.isdir": asks(is_kind("dir")),
    "os.listdir": names,
    "os.walk": walked,
    "os.getcwd": lambda machine, call: Text(call.span, machine.cwd),
    "os.chdir": changed_folder,
    "os.fspath": lambda machine, call: Text(call.span, t) if (t := text_of(call)) is not None else None,
    "glob.glob": globbed,
    "glob.iglob": globbed,
    "pathlib.Path": as_path,
    "pathlib.PurePath": as_path,
    "pathlib.PosixPath": as_path,
    "pathlib.PurePosixPath": as_path,
    "pathlib.Path.cwd": lambda machine, call: Text(call.span, machine.cwd, path=True),
    "open": opened,
    "io.open": opened,
    "codecs.open": opened,
}
