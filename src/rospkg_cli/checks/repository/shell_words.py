"""Words of shell scripts, with what their variables may hold as far as a script writes it out: `src/$robot/a.urdf`."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cached_property
from itertools import chain, product, zip_longest

from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.launch.joined_path import OPEN

WORD = regex(r"""(?:"(?:[^"\\]|\\.)*"|'[^']*'|\$\([^)\n]*\)|`[^`\n]*`|\$\{\{[^}\n]*\}\}|\$\{[^}\n]*\}|\\.|[^\s"'`])+""")
ASSIGNED = regex(
    r"""(?m)(?:^|[;&|]|\b(?:export|local|readonly|declare|ENV|ARG)\b)[ \t]*([A-Za-z_]\w*)(?:=|[ \t]*[:?]?=[ \t]+)"""
    r"""(\([^)]*\)|"[^"\n]*"|'[^'\n]*'|\$\([^)\n]*\)|[^\s;&|]*)"""
)
"""A variable of a shell, a Makefile or a Dockerfile, and what it is given."""
LOOPED = regex(r"\bfor[ \t]+(\w+)[ \t]+in[ \t]+([^;\n]*)")
USED = regex(
    r"\$\{\{[^}]*\}\}|\$\{(?P<braced>\w+)(?P<more>[^}]*)\}|\$\((?P<made>\w+)\)|\$\([^)]*\)|`[^`]*`"
    r"|\$(?P<plain>[A-Za-z_]\w*)|\$[\d@*#?]"
)
"""A variable, or what only a run can tell: the output of a command, an argument."""
CHOICE = regex(r"\{([\w.-]+(?:,[\w.-]+)+)\}")
WHOLE = (":-", "-", ":=", "=", "[@]", "[*]")
"""What may stand behind the name of a variable in braces, and leaves its value as it is."""
MAX_VALUES = 24
MAX_DEPTH = 4


@dataclass(frozen=True)
class ShellWords:
    script: str

    def of(self, word: str) -> tuple[str, ...]:
        """Return what a word may stand for, the same value for each use of a variable; OPEN for what is unknown."""
        found = [unquoted(word)]
        for _ in range(MAX_DEPTH):
            found = list(dict.fromkeys(other for each in found for other in self.replaced(each)))[:MAX_VALUES]
        return tuple(dict.fromkeys(USED.sub(OPEN, each).replace("*", OPEN) for each in found))

    def replaced(self, word: str) -> Iterator[str]:
        """Yield a word once for each way to put the values of its variables in, and for each choice of braces."""
        if choice := CHOICE.search(word):
            yield from (word[: choice.start()] + each + word[choice.end() :] for each in choice[1].split(","))
            return
        used = list(USED.finditer(word))
        names = list(dict.fromkeys(name for each in used if (name := name_of(each))))
        for values in product(*(self.values.get(name) or default_of(used, name) for name in names)):
            held = dict(zip(names, values, strict=True))
            parts = (held.get(name_of(each), OPEN) for each in used)
            yield "".join(chain.from_iterable(zip_longest(between(word, used), parts, fillvalue="")))

    @cached_property
    def values(self) -> dict[str, tuple[str, ...]]:
        """Variable → the words that it is given anywhere in the script."""
        found: dict[str, list[str]] = {}
        for name, value in ASSIGNED.findall(self.script):
            words = value[1:-1].split() if value.startswith("(") else [value]
            found.setdefault(name, []).extend(unquoted(word) for word in words)
        for name, listed in LOOPED.findall(self.script):
            found.setdefault(name, []).extend(unquoted(word) for word in listed.split())
        return {name: tuple(dict.fromkeys(words))[:MAX_VALUES] for name, words in found.items()}


def name_of(used: re.Match[str]) -> str:
    """Return the variable that is used as it is, perhaps with a default; "" for what is cut, or is none."""
    is_whole = not used["more"] or used["more"].startswith(WHOLE)
    return used["plain"] or used["made"] or (used["braced"] if used["braced"] and is_whole else "")


def default_of(used: list[re.Match[str]], name: str) -> tuple[str, ...]:
    """Return what stands for a variable that nothing sets: `b` of `${a:-b}`."""
    found = [each["more"].lstrip(":-=") for each in used if name_of(each) == name and each["more"]]
    return tuple(each for each in found if each and "[" not in each) or (OPEN,)


def between(word: str, used: list[re.Match[str]]) -> list[str]:
    """Return what stands before, between and behind some parts of a word."""
    starts, ends = [each.start() for each in used], [each.end() for each in used]
    return [word[start:end] for start, end in zip([0, *ends], [*starts, len(word)], strict=True)]


def unquoted(word: str) -> str:
    return word.replace('"', "").replace("'", "")
