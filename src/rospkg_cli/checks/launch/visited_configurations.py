"""Launch configurations that nothing has set when launch visits their use (LCH008, LCH016)."""

from __future__ import annotations

from collections.abc import Iterator

from ...package.launch.configuration_events import LaunchEvent
from ...package.launch.launch_file import LaunchFile
from ...suggest import near_names
from .idle_actions import level_at
from .launch_configurations import OWN, LaunchConfigurations
from .unset_configuration import State, UnsetConfiguration


def certainly_unset(configurations: LaunchConfigurations) -> Iterator[UnsetConfiguration]:
    """Yield what is unset in a launch file that is fully evaluated, as are all files that include it."""
    inherited = configurations.inherited
    if inherited is None:
        return
    events = configurations.file.events or ()
    declared = tuple(event.name for event in events if event.kind == "declare")
    uses: dict[str, list[tuple[int, LaunchEvent, bool]]] = {}
    for each in missing(configurations, events, inherited | OWN):
        uses.setdefault(each[1].name, []).append(each)
    for name, several in uses.items():
        index, event, unsure = next((each for each in several if is_met(configurations.file, each[1])), several[0])
        state = state_of(configurations, name, index)
        if state is not None and not (unsure and may_be_set_there(configurations, name, state, declared)):
            passed = event.passed_as == name
            yield UnsetConfiguration(name, event.span, state, declared, passed, event.is_lookup, unsure)


def is_met(file: LaunchFile, use: LaunchEvent) -> bool:
    """Return whether a plain `ros2 launch` may reach a use."""
    return use.is_lookup or level_at(file, use.span)[0] != "info"


def may_be_set_there(configurations: LaunchConfigurations, name: str, state: State, declared: tuple[str, ...]) -> bool:
    """Return whether an included file that is not in the workspace is likely to set a name.

    That is so where this file declares no argument at all, or another launch file of the workspace has the name.
    """
    is_elsewhere = state != "not added" and configurations.workspace.launch.has(name, besides=configurations.file_name)
    return not declared or is_elsewhere


def only_inherited(configurations: LaunchConfigurations) -> Iterator[UnsetConfiguration]:
    """Yield names that only the including files set, where this file declares a similar one that nothing uses.

    An example is `R` for `roll`: the including file passes `roll`, but on the command line there is only `R`.
    """
    inherited = configurations.inherited
    if not inherited or configurations.may_set_any:
        return
    idle = [
        name
        for each in configurations.file.arguments
        if (name := each.name.literal or "") and configurations.mentions[name] == 1
    ]
    events = configurations.file.events or ()
    seen: set[str] = set()
    for index, event, _ in missing(configurations, events, OWN) if idle else ():
        name = event.name
        near = [each for each in idle if is_short_for(each, name) or near_names(name, [each], 1)]
        is_free = name in inherited and name not in seen and state_of(configurations, name, index) == "undeclared"
        if is_free and len(near) == 1:
            seen.add(name)
            yield UnsetConfiguration(name, event.span, "undeclared", (near[0],), is_guess=True, is_inherited=True)


def is_short_for(short: str, name: str) -> bool:
    """Return whether a name begins with another one, whatever their case."""
    return len(short) < len(name) and name.lower().startswith(short.lower())


def state_of(configurations: LaunchConfigurations, name: str, index: int) -> State | None:
    """Return why a name is not set at an event; None where it may be set in some scope.

    An argument without a default has to be given wherever it is declared: then it is set from the start.
    """
    if configurations.is_required(name):
        return None
    if configurations.may_set_any:
        return "late" if configurations.last_set["declare"].get(name, -1) >= index else None
    last = max(configurations.last_set[kind].get(name, -1) for kind in ("declare", "define"))
    if last > index:
        return "late"
    if last >= 0:
        return None
    return "not added" if name in configurations.file.set_configurations else "undeclared"


def missing(
    configurations: LaunchConfigurations, events: tuple[LaunchEvent, ...], known: frozenset[str]
) -> Iterator[tuple[int, LaunchEvent, bool]]:
    """Yield the uses of what is not set by then: index, event, and whether an unknown included file may set it."""
    names, open_, unsure = set(known), False, False
    stack: list[tuple[set[str], bool, bool]] = []
    for index, event in enumerate(events):
        match event.kind:
            case "declare" | "define" | "pass":
                names.add(event.name)
                open_ = open_ or not event.name
            case "open":
                open_ = True
            case "include":
                found = configurations.workspace.launch.defined_by(event.name)
                unsure = unsure or found is None
                names |= found or set()
            case "push":
                stack.append((set(names), open_, unsure))
            case "pop":
                names, open_, unsure = stack.pop()
            case "later":
                names |= {each.name for each in events if each.kind in ("declare", "define")}
            case "use" if event.name and not event.is_optional and not open_ and event.name not in names:
                yield index, event, unsure
