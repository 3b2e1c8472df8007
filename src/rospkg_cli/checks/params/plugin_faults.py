"""PRM008: lists of plugins whose names have no group with a type, or stand there twice."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from ...package.params.parameter_file import NodeBlock, ParameterFile
from ..fault import Fault
from ..older_distribution import is_called_older
from .plugin_lists import doubled_plugins, lost_plugins, unfound_plugins


def plugin_faults(files: Sequence[ParameterFile]) -> Iterator[tuple[str, Fault]]:
    """Yield path and fault; files for older distributions had other names there."""
    for file in files:
        for block in file.blocks if not is_called_older(file.path) else ():
            yield from ((file.path, fault) for fault in faults_of(block, files))


def faults_of(block: NodeBlock, files: Iterable[ParameterFile]) -> Iterator[Fault]:
    meant = dict(unfound_plugins(block))
    for item, group in meant.items():
        message = f"`{item.text}` has no `{item.text}.plugin` here: the plugin can't be loaded"
        yield Fault(item.span, f"{message}; did you mean `{group}`, which no list names?")
    for item, name, group in doubled_plugins(block):
        message = f"`{name}` names `{item.text}` twice, and `{group}` never: that plugin is not loaded"
        yield Fault(item.span, f"{message}; did you mean `{group}`?")
    for item, name in lost_plugins(block):
        if item not in meant and not any(f"{item.text}:" in each.source.text for each in files):
            message = f"`{item.text}` of `{name}` has no `{item.text}.plugin`: the server stops when it starts"
            yield Fault(item.span, f"{message}; give it one, or take it out of the list")
