"""Values of parameters that well-known launch files replace by what an include gives them, or others by rewriting."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterable, Iterator

from ...package.launch.file_references import first_in
from ...package.launch.launch_file import LaunchFile
from ...package.launch.launched_parts import Include
from ...package.launch.text import LaunchText
from ...ros.replaced_parameters import replaces_for, replacing_argument
from ..paths.home_path_texts import without_comments
from .rewritten_yaml import REWRITES


def replaced_by_includes(path: str, node: str, parameter: str, launches: Iterable[LaunchFile]) -> Iterator[bool]:
    """Yield, for each include that is given a parameter file, whether it replaces a parameter of a node there.

    A launch file of a well-known package that never does starts no such node.
    """
    name = posixpath.basename(path)
    for launch in launches:
        for include in launch.includes if not launch.is_ros1 else ():
            if any(name in said(launch, value) for _, value in include.arguments):
                named = first_in(include.file, posixpath.dirname(launch.path))
                argument = replacing_argument(named.package, named.path, node, parameter) if named else None
                if argument is not None:
                    yield gives(launch, include, argument)
                elif named is None or not replaces_for(named.package):
                    yield False


def replaced_by_rewriting(path: str, parameter: str, launches: Iterable[LaunchFile]) -> Iterator[bool]:
    """Yield True for each launch file that names a parameter file and gives it another value by `RewrittenYaml`."""
    word = re.compile(rf"[\"']{re.escape(parameter)}[\"']\s*:")
    for launch in launches:
        text = without_comments(launch.path, launch.source.text) if launch.frontend == "python" else ""
        if REWRITES in text and posixpath.basename(path) in text and word.search(text):
            yield True


def gives(launch: LaunchFile, include: Include, argument: str) -> bool:
    """Return whether an include gives an argument something that is not empty."""
    return any(key.literal == argument and bool(said(launch, value)) for key, value in include.arguments)


def said(launch: LaunchFile, text: LaunchText) -> str:
    """Return a text as XML writes it; for one that is an argument alone, its default, or `…` where it has none."""
    match list(text.substitutions("var")):
        case [only] if only.shown == text.shown and only.arguments:
            defaults = [each.default for each in launch.arguments if each.name.literal == only.arguments[0].literal]
            return "".join(each.shown if each is not None else "…" for each in defaults[:1])
    return text.shown
