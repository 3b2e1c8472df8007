"""Values of parameters that launch files replace: those of a file by later ones, and the defaults of code."""

from __future__ import annotations

import posixpath
from collections.abc import Iterable, Iterator

from ...package.launch.launch_file import LaunchFile
from ...package.launch.launched_parts import LaunchedNode, NodeParameters
from ...package.params.parameter_file import NodeBlock, ParameterFile
from ...source import Span
from .include_overrides import replaced_by_includes, replaced_by_rewriting
from .replaced_defaults import DECLARES, LONGEST


def is_given(before: str, value: str, package: str, launches: Iterable[LaunchFile]) -> bool:
    """Return whether a value behind a text is a parameter's default, for which launch files give another value."""
    found = DECLARES.search(before[-LONGEST:])
    if found is None:
        return False
    nodes = (node for node in nodes_of(launches) if node.package is not None and node.package.literal == package)
    return any(text != value for node in nodes for text in given(node.parameters, found[2]))


def is_overridden(path: str, place: Span, files: Iterable[ParameterFile], launches: Iterable[LaunchFile]) -> bool:
    """Return whether every node that gets a parameter file gets another value for the one at a place after it."""
    files = tuple(files)
    blocks = (block for file in files if file.path == path for block in file.blocks)
    names = [(block, each.name) for block in blocks for each in block.parameters if each.value.span.holds(place)]
    launches = tuple(launches)
    if not names:
        return False
    block, name = names[0]
    later = [behind for node in nodes_of(launches) if (behind := behind_file(node, path)) is not None]
    files = tuple(each for each in files if each.path != path)
    replaced = [any(True for _ in given(each, name)) or is_in_later(each, block, name, files) for each in later]
    replaced += replaced_by_includes(path, block.name.rpartition("/")[2], name, launches)
    replaced += replaced_by_rewriting(path, name, launches)
    return bool(replaced) and all(replaced)


def is_in_later(behind: Iterable[NodeParameters], block: NodeBlock, name: str, files: Iterable[ParameterFile]) -> bool:
    """Return whether a file that a node is handed later gives a parameter in a block of the same name."""
    later = [each.file.shown for each in behind if each.file is not None]
    having = (file for file in files if any(posixpath.basename(file.path) in shown for shown in later))
    same = (each for file in having for each in file.blocks if each.name == block.name)
    return any(each.name == name for one in same for each in one.parameters)


def is_intended_given(path: str, name: str, launches: Iterable[LaunchFile]) -> bool:
    """Return whether every node that gets a parameter file is given a parameter of a name after it."""
    later = [behind for node in nodes_of(launches) if (behind := behind_file(node, path)) is not None]
    return bool(later) and all(any(True for _ in given(each, name)) for each in later)


def nodes_of(launches: Iterable[LaunchFile]) -> Iterator[LaunchedNode]:
    return (node for file in launches if not file.is_ros1 for node in file.nodes)


def behind_file(node: LaunchedNode, path: str) -> tuple[NodeParameters, ...] | None:
    """Return the parameters that a node is given after a file of a name; None where it does not get the file."""
    name = posixpath.basename(path)
    places = [at for at, each in enumerate(node.parameters) if each.file is not None and name in each.file.shown]
    return node.parameters[places[-1] + 1 :] if places else None


def given(parameters: Iterable[NodeParameters], name: str) -> Iterator[str | None]:
    """Yield what a parameter is given by its name; None for what the launch puts together."""
    for each in parameters:
        yield from (value.literal for key, value in each.values if key.literal == name)
