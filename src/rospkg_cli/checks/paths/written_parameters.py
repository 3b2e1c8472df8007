"""Parameters that hold a path at which the nodes of a package only write: what parameter files give them is no file."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from ...files import PackageFiles
from ...package.params.parameter_file import ParameterFile
from ...source import Span
from .home_path_texts import CPP, without_comments


def is_of_written(path: str, place: Span, parameters: Iterable[ParameterFile], files: PackageFiles) -> bool:
    """Return whether a place of a parameter file is the value of one that all code which declares it only writes to."""
    blocks = [block for file in parameters if file.path == path for block in file.blocks]
    names = {each.name for block in blocks for each in block.parameters if each.value.span.holds(place)}
    return any(is_written(name, files) for name in names)


def is_written(name: str, files: PackageFiles) -> bool:
    from .path_flow import PathFlow  # few parameter files have such a path

    ends = [
        PathFlow(text, is_python=is_python).is_written(*calls) for text, is_python, calls in declarations(name, files)
    ]
    return bool(ends) and all(ends)


def declarations(name: str, files: PackageFiles) -> Iterator[tuple[str, bool, list[Span]]]:
    """Yield each file that names a parameter, without its comments, with where it does."""
    word = re.compile(rf"(?<=[\"']){re.escape(name)}(?=[\"'])")
    for path in files.paths:
        if path.endswith((".py", *CPP)) and not path.endswith(".launch.py") and name in files.readable_text(path):
            text = without_comments(path, files.readable_text(path))
            calls = [Span(*each.span()) for each in word.finditer(text)]
            if calls:
                yield text, path.endswith(".py"), calls
