"""Whether what a launch file includes may get at the parameter files that it gives to nodes."""

from __future__ import annotations

from collections.abc import Sequence

from ...package.launch.configuration_events import ConfigurationSummary, file_name
from ...package.launch.launch_file import LaunchFile
from ...package.launch.launched_parts import Include
from ...package.launch.text import Substitution
from ...package.workspace import Workspace


def may_hand_on(launch: LaunchFile, name: str, workspace: Workspace) -> bool:
    """Return whether an included file may read a parameter file of a name: it is passed on, or a launch configuration
    of the including file, which the included one sees, holds its path.
    """
    return any(may_read(each, launch, name, workspace) for each in launch.includes)


def may_read(include: Include, launch: LaunchFile, name: str, workspace: Workspace) -> bool:
    passed = [value.literal for _, value in include.arguments]
    if not include.is_complete or any(value is None or name in value for value in passed):
        return True
    waiting, seen = [included(include, workspace)], set[str]()
    while waiting:
        found = waiting.pop()
        if not found or any(each.may_define_others or each.uses_undefined for each in found):
            return True
        if any(launch.set_configurations & each.defines for each in found):
            return True
        deeper = {each for one in found for each in one.includes} - seen
        waiting += [workspace.launch.by_name.get(each, []) for each in sorted(deeper)]
        seen |= deeper
    return False


def included(include: Include, workspace: Workspace) -> Sequence[ConfigurationSummary]:
    """Return the files that may be included: those of a name, in its package where that is known."""
    name, first = file_name(include.file), include.file.parts[:1]
    match first:
        case (Substitution(name="find-pkg-share", arguments=(package, *_)),):
            facts = workspace.named(package.literal or "")
            return [each for each in facts.launch_summaries if each.name == name] if facts else []
    return workspace.launch.by_name.get(name, []) if name else []
