"""Where a package refers to plugins: parameter files, RViz configs, robots. Names are found by the key before them.

Only whole, literal names of the forms `package/Class` and `namespace::Class` count; what a template or a launch file
computes is not considered.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from ...files import PackageFiles, ReaderInput
from ...lazy_regex import regex
from ...ros.rviz_plugins import LISTS
from ...source import Span
from ...unreadable import UnreadableError
from ..file_role import role_of
from ..plugin import PluginUse
from .nested_blocks import reading_of
from .unlisted_blocks import is_unlisted
from .unspawned_controllers import SpawnedNames, is_of_something

NAME = r"(?P<name>[A-Za-z_]\w*(?:/|::)\w+(?:(?:/|::)\w+)*)"
KEY = r"""(["']?)(?:\w*plugin(?:_name)?|plugin_type|(?:[\w/]+\.)*type|Class)\1"""
YAML = regex(rf"""^[ ]*(?:-[ ]+)?{KEY}[ ]*:[ ]+(["']?){NAME}\2[ ]*(?:\#.*)?$""", re.MULTILINE)
RVIZ = regex(r"""^[ ]*(?:-[ ]+)?Class:[ ]+(["']?)(?P<name>[A-Za-z_]\w*(?:/|::)\w[\w ]*?)\1[ ]*$""", re.MULTILINE)
"""The names of RViz displays and tools may have blanks."""
XML = regex(rf"""<plugin>\s*{NAME}\s*</plugin>|<param\s+name="\w*plugin">\s*{NAME.replace("name", "value")}\s*</""")
LIST = regex(rf"(?m)^(?P<indent>[ ]*)(?P<list>{'|'.join(LISTS)}):")
TEMPLATES = frozenset({"j2", "jinja", "jinja2", "in", "em", "tmpl"})
"""Endings of templates: what is literal in one stays in what is made of it."""
PATTERNS = {"yaml": YAML, "yml": YAML, "rviz": RVIZ, "urdf": XML, "xacro": XML}


def plugin_uses(reading: ReaderInput) -> tuple[PluginUse, ...]:
    spawned = SpawnedNames(reading.files)
    return tuple(use for path in reading.files.paths for use in uses_in(reading.files, path, spawned))


def uses_in(files: PackageFiles, path: str, spawned: SpawnedNames) -> Iterator[PluginUse]:
    plain, _, ending = path.rpartition(".")
    pattern = PATTERNS.get(plain.rpartition(".")[2] if ending in TEMPLATES else ending)
    roles = ("run", "launch", "test") if pattern is YAML else ("run", "launch")
    if pattern is None or role_of(path) not in roles:
        return
    try:
        text = files.source(path).text
    except UnreadableError:
        return
    if pattern is XML:
        text = without_comments(text)
    for match in pattern.finditer(text):
        group = "name" if match["name"] else "value"
        reading = reading_of(text, at := match.start(group)) if pattern is YAML else "read"
        is_idle = pattern is YAML and (is_unlisted(text, at) or spawned.is_unspawned(path, text, at))
        kind = kind_at(text, match.start()) if pattern is RVIZ else ""
        if reading != "unread":
            span = Span(*match.span(group))
            is_plain = pattern is YAML and is_of_something(text, at)
            yield PluginUse(match[group], path, span, reading == "read" and not is_idle, kind, is_plain)


def kind_at(text: str, start: int) -> str:
    """Return the kind of the list that a line of an RViz config is in; "" for none."""
    line = text[start:].partition("\n")[0]
    indent = len(line) - len(line.lstrip(" "))
    around = [each["list"] for each in LIST.finditer(text, 0, start) if len(each["indent"]) <= indent]
    return LISTS[around[-1]] if around else ""


def without_comments(text: str) -> str:
    """Return an XML text with blanks in the place of its comments; one that is never closed stays."""
    pieces, at = [], 0
    while (start := text.find("<!--", at)) >= 0 and (end := text.find("-->", start + 4)) >= 0:
        pieces += [text[at:start], " " * (end + 3 - start)]
        at = end + 3
    return "".join([*pieces, text[at:]])
