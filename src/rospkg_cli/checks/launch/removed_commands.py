"""Words of `ros2 control` that were those of Foxy and Galactic, and that it refuses since Humble (LCH005)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from ...lazy_regex import regex
from ...package.launch.launch_file import LaunchFile
from ...package.launch.text import LaunchText
from ..fault import Fault, Level
from .loaded_controllers import LoadedController, loaded_controllers, named

STATES = {"start": "active", "configure": "inactive", "stop": "inactive"}
VERBS = {"load_start_controller": "active", "load_configure_controller": "inactive"}
STATE = regex(r"ros2 control load_controller (?:.* )?--set-state[ =](?P<word>start|configure|stop)(?: |$)")
VERB = regex(r"ros2 control (?P<word>load_start_controller|load_configure_controller)(?: |$)")


def removed_commands(file: LaunchFile) -> Iterator[Fault]:
    """Yield the states and verbs that `ros2 control` has no more; an info for what is in its state without them."""
    for command in file.commands if not file.is_ros1 else ():
        text = " ".join(" ".join((word.literal or "?").split()) for word in command.words)
        found = STATE.match(text) or VERB.match(text)
        if found is not None and "DISTRO" not in file.source.text:
            word = found["word"]
            place = next(each for each in command.words if holds(each, word))
            end, advice, level = judged(word, *loaders(file, text.split()[3:]))
            yield Fault(place.span, f"`ros2 control` knows no `{word}` since Humble and stops{end}; {advice}", level)


def loaders(file: LaunchFile, words: Sequence[str]) -> tuple[set[tuple[str, str]], list[LoadedController]]:
    """Return the controllers of a command, and what else in the file loads them."""
    wanted = set(named(words))
    return wanted, [each for each in loaded_controllers(file) if (each.name, each.manager) in wanted]


def judged(word: str, wanted: set[tuple[str, str]], found: Sequence[LoadedController]) -> tuple[str, str, Level | None]:
    """Return what comes of a word, what to do, and the level: what else loads the controller may suffice."""
    state = STATES.get(word) or VERBS[word]
    if not wanted or {(each.name, each.manager) for each in found} != wanted:
        now = state if word in STATES else f"load_controller --set-state {state}"
        return ": the controller is not loaded", f"write `{now}`", None
    if all(state in ("inactive", each.state) and each.state != "unconfigured" for each in found):
        return f", but {found[0].by} here loads the controller all the same", "remove the command", "info"
    least = next(each for each in found if each.state != state)
    change = f"write `set_controller_state {least.name} {state}`"
    if least.state == "unconfigured":  # from which `set_controller_state` makes none active
        change = f"have that one make it {state}, and remove this command"
    return f": {least.by} here loads the controller, and it stays {least.state}", change, None


def holds(text: LaunchText, word: str) -> bool:
    return word in (text.literal or "").replace("=", " ").split()
