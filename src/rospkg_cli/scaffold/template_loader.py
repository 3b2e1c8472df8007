"""The files of a template, read only where they are: no link leads out of the template's folder."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from jinja2 import Environment, FileSystemLoader

from . import OwnFaultError
from .bounds import MAX_TEXT


class SourceLoader(FileSystemLoader):
    """Reads sources below some folders, each a file of bounded size."""

    def get_source(self, environment: Environment, template: str) -> tuple[str, str, Callable[[], bool]]:
        """Return text, path and whether that is still so; raises OwnFaultError for what is not to be read."""
        for folder in map(Path, self.searchpath):
            if ".." not in template.split("/") and (folder / template).exists():
                check_source(folder / template, folder.parent if folder.name == "files" else folder)
                break
        return super().get_source(environment, template)


def check_source(path: Path, folder: Path) -> None:
    """Raise OwnFaultError for a link that leads out of a folder, for what is not a file, and for one that is too large.

    Raises OSError where there is nothing.
    """
    name = path.relative_to(folder).as_posix()
    path.lstat()
    if not path.resolve().is_relative_to(folder.resolve()):
        raise OwnFaultError(f"`{name}` is a link that leads out of the template: it is not read")
    if not path.is_file():
        raise OwnFaultError(f"`{name}` is not a file")
    if path.stat().st_size > MAX_TEXT:
        raise OwnFaultError(f"`{name}` has {path.stat().st_size:,} bytes; at most {MAX_TEXT:,} are read")
