"""What may be written at a place: names of dependencies, packages, executables, arguments, types, parameters."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator

from ..package.launch.launch_file import LaunchFile
from ..ros.core_messages import CORE_MESSAGES
from ..ros.interfaces import PRIMITIVES
from ..ros.manifest import DEPENDENCY_TAGS
from .world import LookupWorld

MAX = 300
"""Names that are offered at once."""

NEAR = 400
"""Characters around a name in which the package of an executable is looked for."""

TAG = re.compile(rf"<({'|'.join(DEPENDENCY_TAGS)})\b[^<>]*>\s*([\w.+-]*)$")
PACKAGE = re.compile(
    r"""(?:\b(?:package|pkg)\s*[=:]\s*["']?|(?:FindPackageShare|get_package_share_directory)\(\s*["']"""
    r"""|\$\(find-pkg-share\s+)(\w*)$"""
)
EXECUTABLE = re.compile(r"""\b(?:executable|exec)\s*[=:]\s*["']?([\w.-]*)$""")
OF_PACKAGE = re.compile(r"""\b(?:package|pkg)\s*[=:]\s*["']?(\w+)""")
CONFIGURATION = re.compile(r"""(?:\$\(var\s+|LaunchConfiguration\(\s*["'])(\w*)$""")
FIELD = re.compile(r"(?:^|\n)([\w/]*)$")
KEY = re.compile(r"(?:^|\n)[ \t]+([\w.]*)$")


def completions(world: LookupWorld, folder: str, path: str, text: str, offset: int) -> tuple[int, list[str]]:
    """Return the number of characters before the offset that are begun, and the names that may stand there."""
    before = text[:offset]
    for applies, pattern, names in OFFERS:
        found = pattern.search(before[-NEAR:]) if applies(path) else None
        if found:
            typed = found.group(found.lastindex or 0)
            around = text[max(0, offset - NEAR) : offset + NEAR]
            offered = names(world, folder, path, around)
            return len(typed), sorted({name for name in offered if name.startswith(typed)})[:MAX]
    return 0, []


def is_launch(path: str) -> bool:
    return path.endswith((".launch", ".launch.xml", ".launch.yaml", ".launch.py")) or (
        path.startswith("launch/") and path.endswith((".py", ".xml", ".yaml"))
    )


def dependencies(world: LookupWorld, *_: str) -> Iterable[str]:
    return {*world.workspace.names, *world.workspace.index.all()}


def packages(world: LookupWorld, *_: str) -> Iterable[str]:
    return {*world.workspace.names, *world.workspace.index.packages}


def executables(world: LookupWorld, _: str, __: str, around: str) -> Iterator[str]:
    for name in OF_PACKAGE.findall(around):
        facts = world.workspace.named(name)
        yield from facts.executables if facts else ()


def configurations(world: LookupWorld, folder: str, path: str, _: str) -> Iterator[str]:
    if file := world.package(folder).file(LaunchFile, path):
        yield from (each.name.literal for each in file.arguments if each.name.literal)
        yield from (each.literal for each in file.assigned if each.literal)


def types(world: LookupWorld, folder: str, *_: str) -> Iterator[str]:
    yield from PRIMITIVES
    yield from (f"{package}/{name}" for package, names in CORE_MESSAGES.items() for name in names)
    for facts in world.workspace.packages:
        for name in facts.interfaces:
            kind, base = name.split("/", 1)
            if kind == "msg":
                yield base if facts.folder == folder else f"{facts.name}/{base}"


def parameters(world: LookupWorld, *_: str) -> Iterator[str]:
    for facts in world.workspace.packages:
        yield from (each.name for each in facts.parameters if not each.tail)


Offer = tuple[Callable[[str], bool], "re.Pattern[str]", Callable[[LookupWorld, str, str, str], Iterable[str]]]

OFFERS: tuple[Offer, ...] = (
    (lambda path: path == "package.xml", TAG, dependencies),
    (is_launch, PACKAGE, packages),
    (is_launch, EXECUTABLE, executables),
    (is_launch, CONFIGURATION, configurations),
    (lambda path: path.endswith((".msg", ".srv", ".action")), FIELD, types),
    (lambda path: path.endswith((".yaml", ".yml")), KEY, parameters),
)
