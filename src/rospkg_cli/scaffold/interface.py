"""Messages, services and actions as they are asked for: `Status:"float32 battery_level, string task"`."""

from __future__ import annotations

import keyword
import re
import unicodedata
from collections.abc import Iterator

from ..checks.interfaces.grammar_sentences import sentence_of
from ..light_dataclasses import dataclass
from ..package.interfaces.text import parse_interface
from ..ros.core_messages import CORE_MESSAGES
from ..ros.interfaces import INTERFACE_NAME, SEPARATORS
from ..source import Source
from . import ScaffoldError

DEFAULT_FIELDS = {
    "msg": "builtin_interfaces/Time stamp, string text",
    "srv": "--- bool success, string message",
    "action": "float32 target --- bool success, string message --- float32 progress",
}
"""The fields of what was named without any."""

NOUNS = {"msg": "a message", "srv": "a service", "action": "an action"}

SEPARATOR = re.compile(r"(?:^|(?<=[\s,;]))---+(?=[\s,;]|$)")


@dataclass(frozen=True)
class RequestedInterface:
    form: str
    """`msg`, `srv` or `action`."""
    name: str
    text: str
    packages: tuple[str, ...]
    """Whose messages it uses, each once."""

    @property
    def path(self) -> str:
        return f"{self.form}/{self.name}.{self.form}"


def interfaces_of(asked: dict[str, tuple[str, ...]]) -> tuple[RequestedInterface, ...]:
    """Return what was asked for under `msg`, `srv` and `action`; raises ScaffoldError."""
    found: dict[str, RequestedInterface] = {}
    messages = {text.partition(":")[0] for text in asked.get("msg", ())}
    for form, texts in asked.items():
        for text in texts:
            one = interface_of(form, text, messages)
            if one.path in found:
                raise ScaffoldError(f"--{form} {one.name} is given twice; give each name once")
            found[one.path] = one
    return tuple(found.values())


def interface_of(form: str, asked: str, messages: set[str]) -> RequestedInterface:
    name, colon, fields = asked.partition(":")
    if not INTERFACE_NAME.fullmatch(name):
        better = "".join(word[:1].upper() + word[1:] for word in re.findall(r"[A-Za-z0-9]+", name))
        hint = f"; try `{better}`" if INTERFACE_NAME.fullmatch(better) else ""
        raise ScaffoldError(
            f"`{name}` can't be the name of {NOUNS[form]}: letters and digits, an uppercase letter first{hint}"
        )
    if keyword.iskeyword(name):
        raise ScaffoldError(
            f"`{name}` is a keyword of Python: nothing could import {NOUNS[form]} of that name; try `My{name}`"
        )
    text = text_of(form, name, fields if colon else DEFAULT_FIELDS[form])
    refuse_hidden(form, name, text)
    parsed = parse_interface(Source(f"{form}/{name}.{form}", text), form)
    for problem in parsed.problems:
        line = text.splitlines()[parsed.source.position(problem.span.start)[0] - 1]
        raise ScaffoldError(f"--{form} {name}: {sentence_of(problem)} (in `{line}`)")
    types = [member.type for section in parsed.sections for member in section.members]
    for type in types:
        if not type.is_primitive and not type.package and type.base not in messages:
            raise ScaffoldError(f"--{form} {name}: there is no message `{type.base}` here; {whose(type.base)}")
    return RequestedInterface(form, name, text, tuple(dict.fromkeys(type.package for type in types if type.package)))


def refuse_hidden(form: str, name: str, text: str) -> None:
    """Raise ScaffoldError for a character that no text file should hold."""
    for char in text:
        if char != "\n" and unicodedata.category(char) in ("Cc", "Cs"):
            raise ScaffoldError(f"--{form} {name}: a field or a comment holds {char!a}; leave it out")


def whose(message: str) -> str:
    """Return what to write for a message that no package is named of."""
    owners = [f"`{package}/{message}`" for package, names in CORE_MESSAGES.items() if message in names]
    if owners:
        return f"write {' or '.join(owners)}"
    return f"write the name of its package before it, or ask for it: --msg {message}"


def text_of(form: str, name: str, fields: str) -> str:
    """Return the lines of the file; raises ScaffoldError where there is a part too many or too few."""
    parts = SEPARATOR.split(fields.replace("\n", ","))
    if len(parts) != SEPARATORS[form] + 1:
        count = {0: "no `---`", 1: "one `---`, between request and response", 2: "two `---`: goal, result, feedback"}
        raise ScaffoldError(f"--{form} {name}: {NOUNS[form]} has {count[SEPARATORS[form]]}; found {len(parts) - 1}")
    return "---\n".join("".join(f"{line}\n" for line in lines_of(part)) for part in parts)


def lines_of(part: str) -> Iterator[str]:
    """Yield the fields of a part: separated by commas or semicolons outside of brackets and quotes."""
    line, depth, quote = "", 0, ""
    for char in part + ",":
        if not quote and not depth and char in ",;":
            if line.strip():
                yield " ".join(line.split()) if not re.search("[\"'#]", line) else line.strip()
            line = ""
            continue
        line += char
        if quote:
            quote = "" if char == quote else quote
        elif char in "\"'":
            quote = char
        else:
            depth += (char in "[(") - (char in "])")
