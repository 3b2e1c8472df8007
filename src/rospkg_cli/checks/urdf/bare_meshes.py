"""Meshes that a robot names by a path alone, without a scheme: nothing looks for them in its folder (URD002)."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Collection

from ...files import PackageFiles
from ...languages.xml.parser import Document
from ...lazy_regex import regex
from ...package.package_facts import PackageFacts
from ...source import Span

BARE = regex(r"(?:\./|\.\./)*[\w-][\w. +-]*(?:/[\w. +-]+)*\.(?:stl|dae|obj|glb|gltf|ply)", re.IGNORECASE)
"""A relative path; with what a substitution fills in it may be anything."""
FOUND = regex(r"\$\(find +[\w-]+ *\)/[^\s$]+")
"""An absolute path, which is no URL either."""


def bare_meshes(document: Document, files: PackageFiles, package: PackageFacts) -> dict[tuple[Span, str], str]:
    """Return the place and the path of each such mesh, and the URL of the one file of that name in the package."""
    found = {}
    for element in document.root.walk() if document.root.tag == "robot" else ():
        filename = element.attributes.get("filename") if element.tag == "mesh" else None
        if filename is not None and FOUND.fullmatch(filename.value):
            found[filename.value_span, filename.value] = f"file://{filename.value}"
        elif filename is not None and BARE.fullmatch(filename.value):
            end = f"/{posixpath.basename(filename.value)}"
            known = [each for each in package.share_files or files.paths if f"/{each}".endswith(end)]
            if len(known) == 1:
                found[filename.value_span, filename.value] = f"package://{package.name}/{known[0]}"
    return found


def is_relative(found: Collection[tuple[Span, str]]) -> bool:
    """Return whether Gazebo does not find one of such meshes either: it does by what xacro makes of `$(find …)`."""
    return not all(FOUND.fullmatch(path) for _, path in found)


def without_scheme(found: dict[tuple[Span, str], str], *, is_shown: bool) -> tuple[str, str]:
    """Return the message on such meshes, and the advice."""
    (_, path), url = next(iter(found.items()))
    them = f"`{path}` and {len(found) - 1} more are no URLs" if len(found) > 1 else f"`{path}` is no URL"
    when = "" if is_shown else ", as soon as one of them shows this robot"
    return f"{them}: RViz and MoveIt take no path without a scheme, and don't find the mesh{when}", f"write `{url}`"
