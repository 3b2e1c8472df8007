"""The controllers that a launch file certainly has loaded, and the state that they end in (LCH005)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from ...light_dataclasses import dataclass
from ...package.launch.launch_file import LaunchFile
from ...source import Span
from .idle_actions import level_at

MANAGER = "controller_manager"
SPAWN = ("ros2", "run", MANAGER)
LOAD = ("ros2", "control", "load_controller")
VALUED = frozenset((
    "-c", "--controller-manager", "-p", "--param-file", "-n", "--namespace", "-t", "--controller-type",
    "--controller-manager-timeout", "--switch-timeout", "--service-call-timeout", "--controller-ros-args",
    "--set-state", "--state", "--spin-time",
))  # fmt: skip
"""Options of the spawner and of `ros2 control` that take the next word."""


@dataclass(frozen=True, slots=True)
class LoadedController:
    name: str
    manager: str
    state: str
    """`active`, `inactive`, or `unconfigured`."""
    by: str
    """What loads it, as a sentence names it."""


def loaded_controllers(file: LaunchFile) -> Iterator[LoadedController]:
    """Yield what spawners and commands load that are started under no condition."""
    for node in file.nodes:
        program = [text.literal if text else None for text in (node.package, node.executable)]
        if program[0] == MANAGER and is_spawner(program[1]) and is_started(file, node.span):
            yield from spawned([each.literal or "?" for each in node.arguments])
    for command in file.commands:
        words = " ".join(word.literal or "?" for word in command.words).split()
        start, rest = tuple(words[:3]), words[3:]
        if start == SPAWN and rest and is_spawner(rest[0]) and is_started(file, command.span):
            yield from spawned(rest[1:])
        elif start == LOAD and (given := state_of(rest)) and is_started(file, command.span):
            yield from (LoadedController(*each, given, "another command") for each in named(rest))


def is_spawner(program: str | None) -> bool:
    return program in ("spawner", "spawner.py")


def is_started(file: LaunchFile, span: Span) -> bool:
    return level_at(file, span)[0] is None


def spawned(words: Sequence[str]) -> Iterator[LoadedController]:
    is_only_loaded = "--load-only" in words
    is_inactive = any(each in words for each in ("--inactive", "--stopped"))
    state = "unconfigured" if is_only_loaded else "inactive" if is_inactive else "active"
    yield from (LoadedController(*each, state, "a spawner") for each in named(words))


def state_of(words: Sequence[str]) -> str:
    """Return what `load_controller` sets; "" for a word that it refuses."""
    text = " ".join(words).replace("=", " ").split()
    at = text.index("--set-state") + 1 if "--set-state" in text else 0
    given = text[at] if at and at < len(text) else "unconfigured"
    return given if given in ("active", "inactive") or not at else ""


def named(words: Sequence[str]) -> Iterator[tuple[str, str]]:
    """Yield the name of each controller that words give, with its controller manager."""
    manager, names, before = MANAGER, list[str](), ""
    for word in words:
        option, _, value = word.partition("=")
        if before in ("-c", "--controller-manager"):
            manager = word
        elif option == "--controller-manager" and value:
            manager = value
        elif not word.startswith("-") and before not in VALUED and "?" not in word:
            names.append(word)
        before = word
    yield from ((name, manager.lstrip("/")) for name in names)
