"""Launch configurations that are used and not set (LCH008, LCH016), and arguments that nothing uses (LCH017)."""

from __future__ import annotations

from collections.abc import Iterator

from ...package.launch.launched_parts import DeclaredArgument
from ...suggest import nearest
from .launch_configurations import OWN, LaunchConfigurations
from .misspelt_configurations import slips, unset_in_classes
from .unset_configuration import UnsetConfiguration
from .visited_configurations import certainly_unset, only_inherited


def unset(configurations: LaunchConfigurations) -> Iterator[UnsetConfiguration]:
    """Yield each name once, where it is first used, and under no condition that is off by default if it can be."""
    seen: set[str] = set()
    for each in (
        *certainly_unset(configurations),
        *slips(configurations),
        *unset_in_classes(configurations),
        *only_inherited(configurations),
    ):
        if each.name not in seen:
            seen.add(each.name)
            yield each


def unused(configurations: LaunchConfigurations) -> Iterator[DeclaredArgument]:
    """Yield the arguments that nothing in the file uses; none where it includes files, which see them."""
    events = configurations.file.events or ()
    is_passed_on = any(event.kind in ("include", "open") for event in events)
    if not configurations.is_startable or is_passed_on or "launch_configurations" in configurations.file.source.text:
        return
    used = {event.name for event in events if event.kind == "use"}
    used |= {nearest(each.name, each.declared) or "" for each in unset(configurations)} - {""}
    used |= {
        s.arguments[0].literal or ""
        for s in configurations.file.configurations()
        if s.arguments and configurations.is_read(s.span)
    }
    if "" in used:
        return
    used |= OWN
    for argument in configurations.file.arguments:
        name = argument.name.literal
        if name and name not in used and not configurations.has_other_mention(name, argument.span):
            yield argument
