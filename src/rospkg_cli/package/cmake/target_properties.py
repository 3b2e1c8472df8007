"""Properties that CMake sets on targets: the name of their file, and the name under which they are exported."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from ...languages.cmake.evaluated_command import EvaluatedCommand
from ...languages.cmake.targets import Target

SETTERS = ("set_target_properties", "set_property")


def properties(calls: Iterable[EvaluatedCommand], name: str) -> Iterator[tuple[str, str]]:
    """Yield target and value for each place where `calls` set a property of that name; the last one counts."""
    for call in calls:
        texts = call.texts
        start = "PROPERTIES" if call.name == "set_target_properties" else "PROPERTY"
        at = texts.index(start) if start in texts else len(texts)
        pairs = texts[at + 1 :] if start == "PROPERTIES" else texts[at + 1 : at + 3]
        targets = [text for text in texts[:at] if text not in ("TARGET", "APPEND", "APPEND_STRING")]
        for key, value in zip(pairs[::2], pairs[1::2], strict=False):
            yield from ((target, value) for target in targets if key == name)


def output_names(calls: Iterable[EvaluatedCommand], targets: dict[str, Target]) -> dict[str, str]:
    """Return the targets whose file has another name: target → name; the one for its kind of artifact goes first."""
    calls = tuple(calls)
    found = dict(properties(calls, "OUTPUT_NAME"))
    for kind in ("RUNTIME", "ARCHIVE", "LIBRARY"):
        for target, new in properties(calls, f"{kind}_OUTPUT_NAME"):
            if (known := targets.get(target)) is not None and known.artifact == kind:
                found[target] = new
    return found
