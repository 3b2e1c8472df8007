"""What may be written at a place: names of dependencies, packages, executables, arguments, types, parameters."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator

from ..light_dataclasses import dataclass
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
DECLARED = re.compile(
    r"""<(?:arg|let)\s[^<>]*?\bname\s*=\s*["'](\w+)|DeclareLaunchArgument\(\s*(?:name\s*=\s*)?["'](\w+)"""
    r"""|\b(?:arg|let):\s*\{?\s*name:\s*["']?(\w+)"""
)
"""An argument, in a text that may be broken while it is written."""
PASSED = re.compile(
    r"""<include\s[^<>]*[^/]>(?:(?!</include>).)*<arg\s+name\s*=\s*["'](\w*)$"""
    r"""|launch_arguments\s*=[^}\]]*[{(,]\s*["'](\w*)$""",
    re.DOTALL,
)
FILE = re.compile(r"[\w.-]+\.(?:launch|py|xml|ya?ml)\b")
FIELD = re.compile(r"(?:^|\n)([\w/]*)$")
KEY = re.compile(r"(?:^|\n)[ \t]+([\w.]*)$")


@dataclass(frozen=True)
class Writing:
    """A place of a text that is being written, in a file of the package in a folder."""

    world: LookupWorld
    folder: str
    path: str
    """Relative to the package."""
    text: str
    offset: int

    @property
    def before(self) -> str:
        return self.text[max(0, self.offset - NEAR) : self.offset]

    @property
    def after(self) -> str:
        return self.text[self.offset : self.offset + NEAR]


def completions(world: LookupWorld, folder: str, path: str, text: str, offset: int) -> tuple[int, list[str]]:
    """Return the number of characters before the offset that are begun, and the names that may stand there."""
    writing = Writing(world, folder, path, text, offset)
    for applies, pattern, names in OFFERS:
        found = pattern.search(writing.before) if applies(path) else None
        if found:
            typed = found.group(found.lastindex or 0)
            return len(typed), sorted({name for name in names(writing) if name.startswith(typed)})[:MAX]
    return 0, []


def is_launch(path: str) -> bool:
    return path.endswith((".launch", ".launch.xml", ".launch.yaml", ".launch.py")) or (
        path.startswith("launch/") and path.endswith((".py", ".xml", ".yaml"))
    )


def dependencies(at: Writing) -> Iterable[str]:
    return {*at.world.workspace.names, *at.world.workspace.index.all()}


def packages(at: Writing) -> Iterable[str]:
    return {*at.world.workspace.names, *at.world.workspace.index.packages}


def executables(at: Writing) -> Iterator[str]:
    """Yield those of the package that the same element or call names, else of those around."""
    opening, closing = ("(", ")") if at.path.endswith(".py") else ("<", ">")
    element = at.before[at.before.rfind(opening) + 1 :] + at.after.partition(closing)[0]
    for name in OF_PACKAGE.findall(element) or OF_PACKAGE.findall(at.before + at.after):
        facts = at.world.workspace.named(name)
        yield from facts.executables if facts else ()


def configurations(at: Writing) -> Iterator[str]:
    yield from (name for found in DECLARED.findall(at.text) for name in found if name)
    if file := at.world.package(at.folder).file(LaunchFile, at.path):
        yield from (each.name.literal for each in file.arguments if each.name.literal)
        yield from (each.literal for each in file.assigned if each.literal)


def passed_arguments(at: Writing) -> Iterator[str]:
    """Yield the arguments of the launch file that is named last before the place."""
    files = FILE.findall(at.before)
    for facts in at.world.workspace.packages:
        for signature in facts.launch_files:
            if files and signature.source.rpartition("/")[2] == files[-1]:
                yield from signature.declared


def types(at: Writing) -> Iterator[str]:
    yield from PRIMITIVES
    yield from (f"{package}/{name}" for package, names in CORE_MESSAGES.items() for name in names)
    for facts in at.world.workspace.packages:
        for name in facts.interfaces:
            kind, base = name.split("/", 1)
            if kind == "msg":
                yield base if facts.folder == at.folder else f"{facts.name}/{base}"


def parameters(at: Writing) -> Iterator[str]:
    for facts in at.world.workspace.packages:
        yield from (each.name for each in facts.parameters if not each.tail)


Offer = tuple[Callable[[str], bool], "re.Pattern[str]", Callable[[Writing], Iterable[str]]]

OFFERS: tuple[Offer, ...] = (
    (lambda path: path == "package.xml", TAG, dependencies),
    (is_launch, PACKAGE, packages),
    (is_launch, EXECUTABLE, executables),
    (is_launch, CONFIGURATION, configurations),
    (is_launch, PASSED, passed_arguments),
    (lambda path: path.endswith((".msg", ".srv", ".action")), FIELD, types),
    (lambda path: path.endswith((".yaml", ".yml")), KEY, parameters),
)
