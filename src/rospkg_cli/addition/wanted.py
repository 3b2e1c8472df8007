"""What was asked to be added or removed, and its parts."""

from __future__ import annotations

import re
from collections.abc import Sequence

from ..change import ChangeError
from ..light_dataclasses import dataclass
from ..package.interfaces.interface_file import InterfaceFile
from ..package.package import Package
from ..ros.interfaces import KINDS
from ..scaffold import ScaffoldError
from ..scaffold.interface import RequestedInterface, text_of
from ..scaffold.workspace import WorkspacePackages
from .asked_dependencies import without_asked
from .depend import depend_parts
from .dependency import AddedDependency, manifest_of
from .interface import interface_parts, parts_of
from .launch import SUFFIX, launch_parts
from .named import is_needed
from .new_file import NewFile
from .node import node_parts, node_place, requested_node
from .params import params_parts
from .part import Part
from .plugin import plugin_parts, plugin_that_is_there
from .possible_nodes import possible_nodes
from .unit_test import parts_of_test

WHATS = ("node", "plugin", "launch", "params", *KINDS, "test", "dependency")


@dataclass(frozen=True)
class Wanted:
    what: str
    """One of WHATS."""
    names: tuple[str, ...]
    """As they were typed: `talker:publisher`, `Status:"float32 level"`, `std_msgs`."""
    nodes: tuple[str, ...] = ()
    """What a launch file starts."""
    tag: str = ""
    """Of a dependency."""
    here: bool = False
    """Whether interfaces are generated in a package that generates none."""
    force: bool = False
    """Whether what was edited since is removed too."""


def parts_to_add(package: Package, wanted: Wanted, name: str, there: WorkspacePackages) -> Sequence[Part]:
    """Return the parts of one of the names; raises ChangeError and ScaffoldError for what can't be."""
    match wanted.what:
        case "node":
            place = node_place(package)
            return node_parts(place, requested_node(place, name, there))
        case "plugin":
            return plugin_parts(package, name)
        case "launch":
            return launch_parts(package, name, wanted.nodes)
        case "params":
            return params_parts(package, name)
        case "test":
            return parts_of_test(package, name, False)
        case "dependency":
            return depend_parts(package, (name,), wanted.tag)
        case _:
            return interface_parts(package, wanted.what, (name,), wanted.here)


def parts_to_remove(package: Package, wanted: Wanted, name: str, there: WorkspacePackages) -> Sequence[Part]:
    """Return the parts of what is there under a name; raises ChangeError where nothing is, or where it was edited."""
    parts = parts_that_are_there(package, wanted, name, there)
    return parts if wanted.what == "dependency" else without_asked(package, parts)


def parts_that_are_there(package: Package, wanted: Wanted, name: str, there: WorkspacePackages) -> Sequence[Part]:
    match wanted.what:
        case "node":
            return node_that_is_there(package, name, there, wanted.force)
        case "plugin":
            return plugin_that_is_there(package, name, wanted.force)
        case "launch":
            return launch_that_is_there(package, name, wanted.force)
        case "params":
            return existing(package, params_parts(package, name, wanted.force))
        case "test":
            return existing(package, parts_of_test(package, name, wanted.force))
        case "dependency":
            return dependency_that_is_there(package, name, wanted)
        case _:
            return interface_that_is_there(package, wanted.what, name, wanted.force)


def existing(package: Package, parts: Sequence[Part]) -> Sequence[Part]:
    """Return the parts of what has one file; raises ChangeError where that is not there."""
    path = next(each.path for each in parts if isinstance(each, NewFile))
    if not package.files.exists(path):
        raise ChangeError(f"there is no `{path}`; nothing was removed")
    return parts


def node_that_is_there(package: Package, name: str, there: WorkspacePackages, force: bool) -> Sequence[Part]:
    """Return the parts of a node, of whatever kind it is."""
    place = node_place(package)
    found: Sequence[Part] = ()
    for node in possible_nodes(package, name, there):
        if node.language not in place.template.languages:
            continue
        try:
            parts = node_parts(place, node, force)
        except ChangeError:  # nodes in this language can't be here
            continue
        source = [each for each in parts if isinstance(each, NewFile)][-1 if not is_script(parts) else -2]
        if not package.files.exists(source.path):
            continue
        found = found or parts
        if source.says(package.files.readable_text(source.path)) == source.says(source.text):
            return parts
    if not found:
        raise ChangeError(f"there is no source of a node `{name}` where `add` puts one; nothing was removed")
    if not force:
        raise ChangeError(f"the source of `{name}` is not as `add` writes it; --force removes it all the same")
    return found


def is_script(parts: Sequence[Part]) -> bool:
    return any(isinstance(each, NewFile) and each.path.startswith("scripts/") for each in parts)


NODE = re.compile(r"(?:package='|pkg=\"|pkg: )([\w.-]+)(?:',\s*executable='|\" exec=\"|\s+exec: )([\w.+-]+)")
"""What a launch file of ours says of a node that it starts."""


def launch_that_is_there(package: Package, name: str, force: bool) -> Sequence[Part]:
    """Return the parts of a launch file, with the nodes that it names; its format may be left out where one has it."""
    paths = [path.rpartition("/")[2] for path in package.files.below("launch")]
    alike = [each for each in paths if (end := SUFFIX.search(each)) and each[: end.start()] == name]
    name = alike[0] if len(alike) == 1 else name
    plain = existing(package, launch_parts(package, name, force=force))
    path = next(each.path for each in plain if isinstance(each, NewFile))
    nodes = [f"{owner}/{executable}" for owner, executable in NODE.findall(package.files.readable_text(path))]
    return launch_parts(package, name, nodes, force) if nodes else plain


def interface_that_is_there(package: Package, form: str, name: str, force: bool) -> Sequence[Part]:
    """Return the parts of an interface, with the text that its file has."""
    name = name.partition(":")[0]
    path = f"{form}/{name}.{form}"
    if not package.files.exists(path):
        raise ChangeError(f"there is no `{path}`; nothing was removed")
    text = package.files.readable_text(path)
    files = [each for each in package.parts(InterfaceFile).good if each.path == path]
    packages = tuple(dict.fromkeys(kind.package for each in files for kind in each.types if kind.package))
    found = RequestedInterface(form, name, written(form, name, text), packages)
    return tuple(parts_of(manifest_of(package), [found], force))


def written(form: str, name: str, text: str) -> str:
    """Return what `add` would write for the fields of a file; "" for fields that it would not take."""
    try:
        return text_of(form, name, text)
    except ScaffoldError:
        return ""


def dependency_that_is_there(package: Package, name: str, wanted: Wanted) -> Sequence[Part]:
    """Return the parts of a dependency; raises ChangeError where it is not declared, or something names it."""
    manifest = manifest_of(package)
    tags = sorted({each.tag for each in manifest.dependencies if each.name == name})
    if not tags:
        raise ChangeError(f"package.xml does not declare `{name}`; nothing was removed")
    if is_needed(package, name) and not wanted.force:
        raise ChangeError(f"files of the package still name `{name}`; --force removes the dependency all the same")
    others = [part for part in depend_parts(package, (name,)) if not isinstance(part, AddedDependency)]
    return (*(AddedDependency(name, tag=tag, force=wanted.force) for tag in tags), *others)
