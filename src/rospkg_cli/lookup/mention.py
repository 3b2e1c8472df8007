"""The names in a file that lead elsewhere: dependencies, executables, files, interfaces, functions, parameters."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Literal

from ..lazy_regex import regex
from ..light_dataclasses import dataclass
from ..package.file_role import role_of
from ..package.interfaces.interface_file import InterfaceFile
from ..package.launch.launch_file import LaunchFile
from ..package.manifest import Manifest
from ..package.params.parameter_file import ParameterFile
from ..package.setup.setup_py import SetupPy
from ..package.urdf.robot_file import RobotFile
from ..source import Span
from .lookup_package import LookupPackage, M

MentionKind = Literal["package", "executable", "component", "file", "interface", "function", "parameter", "rule"]

IGNORES = regex(r"rospkg: ignore\[([^\]\n]*)\]")
CODE = regex(r"[A-Z]{3}[0-9]{3}")


@dataclass(frozen=True)
class Mention:
    """A name at a place; `package` is the one that it is of, "" for the file's own."""

    kind: MentionKind
    name: str
    span: Span
    package: str = ""


def mention_at(package: LookupPackage, path: str, offset: int) -> Mention | None:
    """Return what stands at an offset of a file of a package: the shortest, where one lies in another."""
    found = [each for each in mentions(package, path) if each.span.start <= offset <= each.span.end]
    return min(found, key=lambda each: each.span.end - each.span.start, default=None)


def mentions(package: LookupPackage, path: str) -> Iterator[Mention]:
    """Yield what a file of a package names, in no order."""
    yield from ignored_rules(package, path)
    name = path.rpartition("/")[2]
    if path == "package.xml":
        yield from in_manifest(package)
    elif path in ("setup.py", "setup.cfg"):
        yield from in_setup(package, path)
    elif name.endswith((".msg", ".srv", ".action")):
        yield from in_file(package, path, InterfaceFile, in_interface)
    elif name.endswith((".urdf", ".xacro", ".sdf", ".world")):
        yield from in_file(package, path, RobotFile, in_robot)
    elif role_of(path) == "launch":
        yield from in_file(package, path, LaunchFile, in_launch_file)
    elif name.endswith((".yaml", ".yml")):
        yield from in_file(package, path, ParameterFile, in_parameters)


def in_file(
    package: LookupPackage, path: str, kind: type[M], read: Callable[[M], Iterator[Mention]]
) -> Iterator[Mention]:
    """Yield what the model of one file mentions, if it is of a kind."""
    file = package.file(kind, path)
    yield from read(file) if file else ()


def ignored_rules(package: LookupPackage, path: str) -> Iterator[Mention]:
    try:
        text = package.files.source(path).text
    except (OSError, UnicodeError):
        return
    for comment in IGNORES.finditer(text):
        for code in CODE.finditer(comment.group(1)):
            start = comment.start(1) + code.start()
            yield Mention("rule", code.group(), Span(start, start + 6))


def in_manifest(package: LookupPackage) -> Iterator[Mention]:
    for manifest in package.parts(Manifest).good:
        for each in manifest.dependencies:
            yield Mention("package", each.name, each.span)


def in_setup(package: LookupPackage, path: str) -> Iterator[Mention]:
    for setup in package.parts(SetupPy).good:
        for each in setup.entry_points:
            if each.path == path and each.module:
                span = Span(each.module_span.start, max(each.module_span.end, each.attribute_span.end))
                yield Mention("function", f"{each.module}:{each.attribute}", span)


def in_launch_file(file: LaunchFile) -> Iterator[Mention]:
    for node in file.nodes:
        package = node.package.literal if node.package else None
        if node.package and package:
            yield Mention("package", package, node.package.span)
        for kind, text in (("executable", node.executable), ("component", node.plugin)):
            if text and text.literal and package:
                yield Mention("executable" if kind == "executable" else "component", text.literal, text.span, package)
    for found in file.substitutions:
        if found.name in ("find-pkg-share", "find-pkg-prefix") and found.arguments and found.arguments[0].literal:
            yield Mention("package", found.arguments[0].literal, found.arguments[0].span)
    for reference in file.paths:
        yield Mention("file", reference.path, reference.span, reference.package)


def in_interface(file: InterfaceFile) -> Iterator[Mention]:
    for section in file.sections:
        for member in section.members:
            if not member.type.is_primitive:
                yield Mention("interface", f"msg/{member.type.base}", member.type.base_span, member.type.package)


def in_robot(file: RobotFile) -> Iterator[Mention]:
    for reference in file.references:
        if reference.path:
            yield Mention("file", reference.path, reference.span, reference.package)


def in_parameters(file: ParameterFile) -> Iterator[Mention]:
    for block in file.blocks:
        for each in block.parameters:
            yield Mention("parameter", each.name, each.key.span)
