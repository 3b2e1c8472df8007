"""YAML files that code opens and rcl never reads: no parameter files, whatever is in them."""

from __future__ import annotations

import posixpath
import re

from ...files import ReaderInput
from ...lazy_regex import regex
from ..file_role import role_of
from ..launch.launch_file import LaunchFile
from ..manifest import Manifest

PARSES = {
    ".py": regex(r"\bYAML\s*\(|\byaml\.load|\b(?:safe|full|unsafe)_load\s*\("),
    ".cpp": regex(r"\bYAML::Load"),
}
SUFFIXES = {".py": ".py", ".cpp": ".cpp", ".cc": ".cpp", ".cxx": ".cpp", ".hpp": ".cpp", ".h": ".cpp"}
TEXTS = (".sh", ".bash", ".md", ".rst", ".txt", ".service", ".yaml", ".yml", ".py")
HANDS_ON = regex(r"launch_ros|LaunchDescription|parameter_overrides|automatically_declare|params[-_]file")
"""What a program has that starts nodes, or makes parameters of what it reads."""


def is_for_code(path: str, reading: ReaderInput) -> bool:
    """Return whether all that opens a file is code: a launch file for single values, or a program by its own parser."""
    from ..launch.opened_yaml import is_given, is_handed_on, is_only_read, references_to  # few files are opened so

    name, manifest = posixpath.basename(path), reading.parts(Manifest).only
    own = manifest.name if manifest is not None else ""
    launches = [each for each in reading.parts(LaunchFile).good if not each.is_ros1]
    naming = [each for each in launches if name in each.source.text]
    if any(is_given(name, each, own) for each in naming) or is_given_by_text(name, reading):
        return False
    if any(references_to(name, each, own) or is_only_read(name, each) for each in naming):
        return not any(is_handed_on(name, each, own) for each in naming)
    return any(opens(code, name, reading) for code in reading.files.paths if role_of(code) != "test")


def opens(code: str, name: str, reading: ReaderInput) -> bool:
    """Return whether a program parses YAML and names a file, and makes no parameters of it."""
    kind = SUFFIXES.get(posixpath.splitext(code)[1], "")
    if not kind or not reading.files.holds(code, name.encode()):
        return False
    text = reading.files.readable_text(code)
    return PARSES[kind].search(text) is not None and HANDS_ON.search(text) is None


def is_given_by_text(name: str, reading: ReaderInput) -> bool:
    """Return whether a page or a script gives a node a file of a name."""
    word = re.compile(rf"params[-_]file\S*[ \t]*\S*{re.escape(name)}")
    mark = name.encode()
    paths = (path for path in reading.files.paths if path.endswith(TEXTS) and reading.files.holds(path, mark))
    return any(word.search(reading.files.readable_text(path)) for path in paths)
