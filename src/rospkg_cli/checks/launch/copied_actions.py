"""Unused actions that several launch files of a package have alike, being copies of one (LCH018)."""

from __future__ import annotations

from collections.abc import Iterator

from ...light_dataclasses import replace
from ...source import Span
from .launch_configurations import LaunchConfigurations
from .unused_actions import UnusedAction, unused_actions

Place = tuple[str, Span]


def reported_once(configurations: LaunchConfigurations) -> Iterator[tuple[UnusedAction, list[Place]]]:
    """Yield the unused actions that no earlier file has alike, each with its places in later files."""
    mine = list(unused_actions(configurations))
    files = [each for each in configurations.around if mine and each.path != configurations.file.path]
    others = [(file, each) for file in files for each in unused_actions(replace(configurations, file=file))]
    for action in mine:
        key = key_of(action)
        places = sorted((file.path, each.span) for file, each in others if key_of(each) == key)
        if not any(path < configurations.file.path for path, _ in places):
            yield action, places


def key_of(action: UnusedAction) -> tuple[str, str, str, bool, bool]:
    """Return what copies have in common: the action as it is written, and what is reported of it."""
    return action.what, action.written, action.harm, action.is_awaited, action.is_gone
