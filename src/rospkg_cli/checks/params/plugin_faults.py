"""PRM008: lists of plugins whose names have no group with a type, or stand there twice."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from ...package.launch.launch_file import LaunchFile
from ...package.params.parameter_file import NodeBlock, ParameterFile
from ..fault import Fault
from ..repository.distribution_names import is_called_older
from .plugin_lists import doubled_plugins, is_default, listed_names, lost_plugins, unfound_plugins


def plugin_faults(files: Sequence[ParameterFile], launches: Iterable[LaunchFile]) -> Iterator[tuple[str, Fault]]:
    """Yield path and fault; files for older distributions had other names there, and launch files may give the rest."""
    texts = [*(each.source.text for each in files), *(each.source.text for each in launches)]
    for file in files:
        for block in file.blocks if not is_called_older(file.path) else ():
            yield from ((file.path, fault) for fault in faults_of(block, texts))


def faults_of(block: NodeBlock, texts: Sequence[str]) -> Iterator[Fault]:
    intended = {
        item: group for item, group in unfound_plugins(block) if not any(f"{item.text}.plugin" in t for t in texts)
    }
    for item, group in intended.items():
        is_typed = any(is_default(block, name) for name, other in listed_names(block) if other is item)
        lost = "its default is loaded" if is_typed else "the plugin can't be loaded"
        message = f"`{item.text}` has no `{item.text}.plugin` here: {lost}"
        yield Fault(item.span, f"{message}; did you mean `{group}`, which no list names?")
    for item, name, group in doubled_plugins(block):
        message = f"`{name}` names `{item.text}` twice, and `{group}` never: that plugin is not loaded"
        yield Fault(item.span, f"{message}; did you mean `{group}`?")
    for item, name in lost_plugins(block):
        is_given = any(f"{item.text}{sign}" in text for text in texts for sign in (":", ".plugin"))
        if item not in intended and not is_given:
            message = f"`{item.text}` of `{name}` has no `{item.text}.plugin`: the server stops when it starts"
            yield Fault(item.span, f"{message}; give it one, or take it out of the list")
