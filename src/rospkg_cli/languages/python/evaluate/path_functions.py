"""os.path, os, glob and pathlib over the package's folder. Paths are POSIX paths on every system."""

from __future__ import annotations

import posixpath
from collections.abc import Callable, Mapping

from .conversion import from_python
from .iterables import plain_function
from .operators import normalized_path, path_join
from .sandbox_filesystem import MAGIC, ROOT, OutsideError, SandboxFilesystem, glob_matches
from .state import EvaluationState, Intrinsic
from .truthiness import truth
from .values import Call, Constant, GlobResult, OpenedFile, Sequence, Text, Value


def text_of(call: Call, name: str = "path", position: int = 0) -> str | None:
    value = call.get(name, position)
    return value.text if isinstance(value, Text) else None


def join_paths(state: EvaluationState, call: Call) -> Value | None:
    return path_join(list(call.positional), call.span)


def abspath(state: EvaluationState, call: Call) -> Value | None:
    text = text_of(call)
    return None if text is None else Text(call.span, posixpath.normpath(posixpath.join(state.cwd, text)))


def relpath(state: EvaluationState, call: Call) -> Value | None:
    text, start = text_of(call), text_of(call, "start", 1)
    if text is None or (start is None and len(call.positional) > 1):
        return None
    here = posixpath.join(state.cwd, text), posixpath.join(state.cwd, start or "")
    return Text(call.span, posixpath.relpath(*here))


def path_test(test: Callable[[SandboxFilesystem, str], bool]) -> Intrinsic:
    """Return the intrinsic of a test of one path; the answer is unknown outside of the package."""

    def intrinsic(state: EvaluationState, call: Call) -> Value | None:
        text = text_of(call)
        try:
            return (
                None if text is None else Constant(call.span, test(state.folder, state.folder.inside(text, state.cwd)))
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


def listdir(state: EvaluationState, call: Call) -> Value | None:
    text = text_of(call)
    if text is None and call.arguments:
        return None
    try:
        inside = state.folder.inside(text or ".", state.cwd)
        found = state.folder.names(inside) if state.folder.kind(inside) == "dir" else None
    except OutsideError:
        return None
    return None if found is None else state.computed_list(call.span, [Text(call.span, name) for name in found])


def walk(state: EvaluationState, call: Call) -> Value | None:
    text = text_of(call, "top")
    if text is None or call.get("topdown", 1) is not None:
        return None
    try:
        inside = state.folder.inside(text, state.cwd)
        rows = list(state.folder.walk(inside)) if state.folder.kind(inside) == "dir" else []
    except OutsideError:
        return None
    found: list[Value] = []
    for path, folders, files in rows:
        below = path[len(inside) :].lstrip("/")
        state.tick(1 + len(folders) + len(files))
        found.append(from_python((posixpath.join(text, below) if below else text, folders, files), call.span))
    return state.computed_list(call.span, found)


def glob(state: EvaluationState, call: Call) -> Value | None:
    pattern, recursive = text_of(call, "pathname"), call.get("recursive")
    flag = truth(recursive) if recursive else False
    if pattern is None or flag is None or call.rest or {a.name for a in call.arguments} - {"", "pathname", "recursive"}:
        return None
    try:
        found = state.folder.glob(pattern, recursive=flag, cwd=state.cwd)
    except OutsideError:
        return None
    return record_glob(state, call, pattern, found)


def record_glob(state: EvaluationState, call: Call, pattern: str, found: list[str], *, path: bool = False) -> Sequence:
    """Return the matches, and record the glob."""
    try:
        shown = state.folder.inside(pattern, state.cwd)
        matches = tuple(state.folder.inside(each, state.cwd) for each in found)
    except OutsideError:
        shown, matches = pattern, tuple(found)
    result = state.computed_list(call.span, [Text(call.span, each, is_path=path) for each in found])
    result.origin = GlobResult(call.span, shown, matches, state.certain)
    state.globs.append(result.origin)
    return result


def pathlib_glob(state: EvaluationState, path: str, pattern: str) -> list[str]:
    """Return what pathlib's glob gives: hidden files match as well, and a final `**` gives only folders."""
    found = [state.folder.inside(path, state.cwd)]
    for part in [part for part in pattern.split("/") if part]:
        following: list[str] = []
        for each in found:
            state.tick()
            if part == "**":
                following += [top for top, _, _ in state.folder.walk(each)]
            elif MAGIC.search(part):
                following += [
                    posixpath.join(each, n)
                    for n in state.folder.names(each)
                    if glob_matches(n.lstrip("."), part) or glob_matches(n, part)
                ]
            elif state.folder.kind(posixpath.join(each, part)) is not None:
                following.append(posixpath.join(each, part))
        found = sorted(set(following))
    below = state.folder.inside(path, state.cwd)
    return [normalized_path(posixpath.join(path, each[len(below) :].lstrip("/"))) for each in found]


def as_path(state: EvaluationState, call: Call) -> Value | None:
    return path_join(list(call.positional) or [Text(call.span, ".")], call.span, path=True)


def chdir(state: EvaluationState, call: Call) -> Value | None:
    text = text_of(call)
    if text is None:
        return None
    inside = posixpath.normpath(posixpath.join(state.cwd, text))
    if inside != ROOT and not inside.startswith(ROOT + "/"):
        return None
    state.cwd = inside
    return Constant(call.span, None)


def open_file(state: EvaluationState, call: Call) -> Value | None:
    text, mode = text_of(call, "file"), call.get("mode", 1)
    if text is None or (mode is not None and not (isinstance(mode, Text) and mode.text in ("r", "rt", "rU"))):
        return None
    try:
        inside = state.folder.inside(text, state.cwd)
    except OutsideError:
        return None
    return OpenedFile(call.span, inside) if state.folder.files.exists(inside) else None


PATH_FUNCTIONS: Mapping[str, Intrinsic] = {
    "os.path.join": join_paths,
    "os.path.abspath": abspath,
    "os.path.realpath": abspath,
    "os.path.relpath": relpath,
    "os.path.dirname": plain_function(posixpath.dirname),
    "os.path.basename": plain_function(posixpath.basename),
    "os.path.split": plain_function(posixpath.split),
    "os.path.splitext": plain_function(posixpath.splitext),
    "os.path.normpath": plain_function(posixpath.normpath),
    "os.path.isabs": plain_function(posixpath.isabs),
    "os.path.commonpath": plain_function(posixpath.commonpath),
    "os.path.commonprefix": plain_function(posixpath.commonprefix),
    "os.path.exists": path_test(lambda folder, path: folder.kind(path) is not None),
    "os.path.lexists": path_test(lambda folder, path: folder.kind(path) is not None),
    "os.path.isfile": path_test(is_kind("file")),
    "os.path.isdir": path_test(is_kind("dir")),
    "os.listdir": listdir,
    "os.walk": walk,
    "os.getcwd": lambda state, call: Text(call.span, state.cwd),
    "os.chdir": chdir,
    "os.fspath": lambda state, call: Text(call.span, t) if (t := text_of(call)) is not None else None,
    "glob.glob": glob,
    "glob.iglob": glob,
    "pathlib.Path": as_path,
    "pathlib.PurePath": as_path,
    "pathlib.PosixPath": as_path,
    "pathlib.PurePosixPath": as_path,
    "pathlib.Path.cwd": lambda state, call: Text(call.span, state.cwd, is_path=True),
    "open": open_file,
    "io.open": open_file,
    "codecs.open": open_file,
}
