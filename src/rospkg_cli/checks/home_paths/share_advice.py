"""Advice on how to name a file of the workspace, in place of the absolute path that it has on one machine."""

from __future__ import annotations

import posixpath

from ...lazy_regex import regex
from ..paths.home_path_texts import CPP
from .home_path import HomePath
from .home_paths import HomePaths
from .target_package import is_installed

ARGUMENT = r"\bDeclareLaunchArgument\([^()]*default_value\s*=\s*[\"']\Z|<arg\s[^<>]*\bdefault\s*=\s*[\"']\Z"
PARAMETER = r"\bdeclare_parameter(?:<[^<>]*(?:<[^<>]*>)?[^<>]*>)?\([^()]*,\s*[\"']\Z"
DEFAULTS = {regex(ARGUMENT): "argument", regex(PARAMETER): "parameter"}
"""What stands before the default of an argument or a parameter."""

WHY = {
    "is_unreached": "; nothing here leads to this function",
    "is_unread": "; nothing reads it",
    "is_written": "; something writes it, and misses no file",
    "is_unclaimed": "; neither code here nor a well-known node is shown to read it by this key",
    "is_off": "; it is switched off, or not chosen by default",
    "is_last_resort": "; it is tried only where something else failed before",
}
"""By the field of HomePath: why a missing file does no harm today."""


def advice(paths: HomePaths, found: HomePath) -> str:
    """Return how to name a file of the workspace on every machine, in the language of the file that names it."""
    package = found.of_package
    if is_included(paths, found):
        return "include it by its path below a folder of headers, and tell the target of that folder"
    if found.path.endswith("CMakeLists.txt"):
        return f"find `{package}` with find_package(), or write the path from ${{CMAKE_CURRENT_SOURCE_DIR}}"
    if is_made(paths, found):
        return f"{giver(paths, found)}: it is no file of the package"
    if found.path.endswith((".py", *CPP)):
        quote = "'" if found.path.endswith(".py") else '"'
        share, at = f"`get_package_share_directory({quote}{package}{quote})`", share_path(paths, found)
        return f"join {share} and `{at}`" if at else f"install it, and join {share} and its path there"
    if found.path.endswith(".xml") or "launch" in posixpath.basename(found.path):
        at = share_path(paths, found)
        return f"{'' if at else 'install it, and '}write `$(find-pkg-share {package})/{at or '…'}`"
    return image_advice(paths, found) or f"have the launch file give it, from the share directory of `{package}`"


def image_advice(paths: HomePaths, found: HomePath) -> str:
    """Return how the YAML of a map names its image, relative to its own folder; "" for any other value."""
    if not (found.is_image and found.path.endswith((".yaml", ".yml"))):
        return ""
    folder, name = posixpath.dirname(found.path), posixpath.basename(found.text)
    is_own = found.of_package == paths.facts.name
    is_intended = is_own and posixpath.dirname(found.below) == folder
    if is_intended or paths.files.exists(posixpath.join(folder, name)):
        return f"write `{name}`: a map's image is looked for next to this file"
    if "resolution:" not in paths.files.readable_text(found.path):
        return ""
    if is_own and paths.files.exists(found.below):
        near = posixpath.relpath(found.below, folder or ".")
        return f"write `{near}`: it is looked for from the folder of this file"
    return f"put the image next to this file, and write `{name}`: a map's image is looked for there"


def giver(paths: HomePaths, found: HomePath) -> str:
    """Return the advice what should give a path that differs by machine; it may be the default of a parameter here."""
    before = paths.files.source(found.path).text[: found.span.start]
    for begins, what in DEFAULTS.items():
        if begins.search(before):
            return f"give the {what} another default"
    return "let a parameter or an argument give it"


def is_included(paths: HomePaths, found: HomePath) -> bool:
    """Return whether a path is that of an `#include`."""
    source = paths.files.source(found.path)
    line = source.text[: found.span.start].rpartition("\n")[2]
    return found.path.endswith(CPP) and line.lstrip().startswith("#include")


def is_made(paths: HomePaths, found: HomePath) -> bool:
    """Return whether the package that a path leads into has no such file or folder: what runs may write it."""
    is_own = found.of_package == paths.facts.name and not found.is_image
    begins_so = any(each.startswith(f"{found.below}.") for each in paths.files.paths)
    return is_own and not (paths.files.is_there(found.below) or begins_so or share_path(paths, found))


def share_path(paths: HomePaths, found: HomePath) -> str:
    """Return the path of a file or folder in the share directory of its package; "" where it is surely not there."""
    facts = paths.workspace.named(found.of_package or "")
    if facts is None or not facts.knows("share_files"):
        return found.below
    if is_installed(found.below, facts):
        return found.below
    is_own = facts.name == paths.facts.name and paths.table is not None
    place = paths.table.destination_of(found.below) if is_own and paths.table is not None else None
    prefix = f"share/{facts.name}/"
    return place.removeprefix(prefix) if place is not None and place.startswith(prefix) else ""
