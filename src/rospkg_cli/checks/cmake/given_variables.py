"""Variables that the user of a package gives to CMake with -D, or in the environment, to say where something lies."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import dropwhile

from ...languages.cmake.evaluated_command import EvaluatedCommand
from ...languages.cmake.file import CMakeFile
from ...lazy_regex import regex

SEARCHES = ("find_library", "find_path", "find_file", "find_program", "find_package")
PLACES = ("HINTS", "PATHS")
"""What the places stand behind that a search looks at."""
NAMES = "NAMES"
REFERENCE = regex(r"\$\{([A-Za-z_]\w*)\}")
FROM_ENVIRONMENT = regex(r"\$ENV\{([A-Za-z_]\w*)\}")
NAMED = 2
"""The variable and the name of what is searched for, behind which places may stand without a keyword."""


def given_variables(calls: Iterable[EvaluatedCommand], files: Iterable[CMakeFile]) -> Iterator[str]:
    """Yield the variables that a search reads for its places, and those that are read from the environment, too."""
    for call in calls:
        for text in places(call) if call.name in SEARCHES else ():
            yield from REFERENCE.findall(text)
    for file in files:
        yield from FROM_ENVIRONMENT.findall(file.source.text)


def places(call: EvaluatedCommand) -> Iterator[str]:
    """Yield the places of a search as they are written."""
    texts = [argument.text for argument in call.command.arguments]
    is_short = call.name != "find_package" and NAMES not in texts and not set(PLACES) & set(texts)
    yield from texts[NAMED:] if is_short else dropwhile(lambda text: text not in PLACES, texts)
