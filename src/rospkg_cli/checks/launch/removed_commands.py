"""Words of `ros2 control` that were those of Foxy and Galactic, and that it refuses since Humble (LCH005)."""

from __future__ import annotations

from collections.abc import Iterator

from ...lazy_regex import regex
from ...package.launch.launch_file import LaunchFile
from ...package.launch.text import LaunchText
from ..fault import Fault

STATES = {"start": "active", "configure": "inactive", "stop": "inactive"}
VERBS = {
    "load_start_controller": "load_controller --set-state active",
    "load_configure_controller": "load_controller --set-state inactive",
}
STATE = regex(r"ros2 control load_controller (?:.* )?--set-state[ =](?P<word>start|configure|stop)(?: |$)")
VERB = regex(r"ros2 control (?P<word>load_start_controller|load_configure_controller)(?: |$)")


def removed_commands(file: LaunchFile) -> Iterator[Fault]:
    """Yield the states and verbs that `ros2 control` has no more."""
    for command in file.commands if not file.is_ros1 else ():
        text = " ".join(" ".join((word.literal or "?").split()) for word in command.words)
        found = STATE.match(text) or VERB.match(text)
        if found is not None and "DISTRO" not in file.source.text:
            word = found["word"]
            place = next(each for each in command.words if holds(each, word))
            now = STATES.get(word) or VERBS[word]
            message = f"`ros2 control` knows no `{word}` since Humble and stops: the controller is not loaded"
            yield Fault(place.span, f"{message}; write `{now}`")


def holds(text: LaunchText, word: str) -> bool:
    return word in (text.literal or "").replace("=", " ").split()
