"""Changes that seed a fault into the files of a package; each fails where the package is no longer as it expects."""

from __future__ import annotations

from collections.abc import Callable

Files = dict[str, str]


def edit(files: Files, path: str, old: str, new: str, count: int = 1) -> None:
    assert old in files[path], f"{old!r} is not in {path}:\n{files[path]}"
    files[path] = files[path].replace(old, new, count)


def swap(path: str, old: str, new: str, count: int = 1) -> Callable[[Files], None]:
    return lambda files: edit(files, path, old, new, count)


def drop(*paths: str) -> Callable[[Files], None]:
    return lambda files: [files.pop(path) for path in paths] and None


def put(path: str, text: str) -> Callable[[Files], None]:
    return lambda files: files.update({path: text})


def line(path: str, holding: str, new: str = "") -> Callable[[Files], None]:
    """Replace the first line that holds a text."""

    def change(files: Files) -> None:
        lines = files[path].splitlines(keepends=True)
        at = next(number for number, text in enumerate(lines) if holding in text)
        lines[at] = new
        files[path] = "".join(lines)

    return change


def before(path: str, holding: str, new: str) -> Callable[[Files], None]:
    """Put a line above the first one that holds a text."""

    def change(files: Files) -> None:
        at = files[path].index(holding)
        start = files[path].rfind("\n", 0, at) + 1
        files[path] = files[path][:start] + new + files[path][start:]

    return change


def both(*changes: Callable[[Files], None]) -> Callable[[Files], None]:
    def change(files: Files) -> None:
        for each in changes:
            each(files)

    return change
