"""The text of a launch file without comments, and without actions that it makes and never adds.

One for ROS 1 does nothing.
"""

from __future__ import annotations

import contextlib
from collections.abc import Iterable

from ...files import PackageFiles
from ...languages.python.file import PythonFile, parse_python
from ...lazy_regex import regex
from ...source import Span
from ...unreadable import UnreadableError
from .never_launched import never_launched
from .text import uncommented
from .uncalled_functions import ENTRY, uncalled_functions

MARKUP = (".launch", ".xml")
OF_ROS1 = regex(r"<node\b[^>]*\btype\s*=|\$\((?:find|arg)\s")
OF_ROS2 = regex(r"<node\b[^>]*\bexec\s*=|\$\((?:var|find-pkg-share)\s")


def live_text(files: PackageFiles, path: str) -> str:
    """Return the text of a file without comments; of a launch file in Python, without what nothing there reads, too.

    A node that is taken out of the launch description leaves the paths of its files behind, which nothing opens.
    """
    text = files.readable_text(path)
    if path.endswith(MARKUP) and is_for_ros1(text):
        return ""
    if path.endswith(".py") and ENTRY in text:
        with contextlib.suppress(UnreadableError):  # another rule reports it
            text = without_unread(parse_python(files.source(path)))
    return uncommented(path, text)


def without_unread(file: PythonFile, more: Iterable[Span] = ()) -> str:
    """Return the text of a file without the values that are bound to local names which nothing reads, and some more."""
    return without(file.source.text, (*never_launched(file), *uncalled_functions(file), *more))


def without(text: str, spans: Iterable[Span]) -> str:
    """Return a text without some places, which may lie in each other."""
    kept, at = "", 0
    for span in sorted(spans, key=lambda each: each.start):
        kept, at = kept + text[at : span.start], max(at, span.end)
    return kept + text[at:]


def is_for_ros1(text: str) -> bool:
    """Return whether a text is a launch file that only roslaunch takes."""
    bare = uncommented(".launch", text) if "<launch" in text else ""
    return OF_ROS1.search(bare) is not None and OF_ROS2.search(bare) is None
