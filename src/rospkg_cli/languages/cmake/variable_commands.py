"""What `set`, `unset`, `option`, `math`, `separate_arguments` and `cmake_parse_arguments` do to variables."""

from __future__ import annotations

import re

from ...lazy_regex import regex
from .evaluated_command import EvaluatedCommand, flags_and_values
from .file import ROOT
from .interpreter import Interpreter
from .list_text import as_value, list_to_text
from .values import PREFIX, UNKNOWN

SUPERBUILD = regex(r"SUPER_?BUILD", re.IGNORECASE)
"""What an option is called by which a package first builds what it needs, and then itself once more."""
PRODUCT = regex(r"\s*(-?\d{1,9})\s*([-+*/%])\s*(-?\d{1,9})\s*")


def run_set(interpreter: Interpreter, call: EvaluatedCommand) -> None:
    if not call.words or call.texts[0].startswith("ENV{"):
        return
    name, words = call.texts[0], list(call.words[1:])
    keywords = ["" if word.quoted else word.text for word in words]
    if "CACHE" in keywords:
        at = keywords.index("CACHE")
        is_forced = keywords[-1] == "FORCE" or keywords[at + 1 : at + 2] == ["INTERNAL"]
        is_switch = keywords[at + 1 : at + 2] == ["BOOL"] and not is_forced  # its user may choose another value
        if is_forced or interpreter.value_if_set(name) is None:
            interpreter.set(name, interpreter.unknown() if is_switch else as_value(words[:at]))
    elif keywords[-1:] == ["PARENT_SCOPE"]:
        if interpreter.scope.around is not None:
            interpreter.spend(len(words))
            interpreter.scope.around.set(name, as_value(words[:-1]))
    else:
        interpreter.set(name, as_value(words))


def run_unset(interpreter: Interpreter, call: EvaluatedCommand) -> None:
    """The install prefix is in the cache too, whose value is seen again once the variable is gone."""
    for name in call.texts[:1]:
        if name == "CMAKE_INSTALL_PREFIX":
            interpreter.set_text(name, PREFIX)
        else:
            interpreter.set(name, ())


def run_option(interpreter: Interpreter, call: EvaluatedCommand) -> None:
    """The value of an option is unknown: the user chooses it. That of a superbuild is off where it matters."""
    if call.words and call.texts[0] != "BUILD_TESTING" and interpreter.value_if_set(call.texts[0]) is None:
        name = call.texts[0]
        interpreter.set_text(name, "OFF" if SUPERBUILD.search(name) and turns_off(interpreter, name) else None)


def turns_off(interpreter: Interpreter, name: str) -> bool:
    """Return whether a file of CMake builds the package itself once more, with an option turned off."""
    files = interpreter.files
    paths = (path for path in files.paths if path.endswith((".cmake", ROOT)))
    given = re.compile(
        rf"\bSOURCE_DIR\s+\"?\$\{{(?:PROJECT|CMAKE|CMAKE_CURRENT)_SOURCE_DIR\}}[^()]*-D{re.escape(name)}(?::BOOL)?=(?:OFF|0)\b"
    )
    return any(given.search(files.readable_text(path)) for path in paths)


def run_math(interpreter: Interpreter, call: EvaluatedCommand) -> None:
    """`math(EXPR name "1 + 2")`, for two numbers."""
    if len(call.words) < 3:
        return
    match = PRODUCT.fullmatch(call.texts[2])
    interpreter.set_text(call.texts[1], compute(int(match[1]), match[2], int(match[3])) if match else None)


def compute(a: int, sign: str, b: int) -> str | None:
    if sign in "/%":
        return None if b == 0 else str(int(a / b) if sign == "/" else a % b)
    return str({"+": a + b, "-": a - b, "*": a * b}[sign])


def run_separate_arguments(interpreter: Interpreter, call: EvaluatedCommand) -> None:
    if len(call.words) == 1:
        text = list_to_text(interpreter.value(call.texts[0]))
        interpreter.set_text(call.texts[0], None if UNKNOWN in text else ";".join(text.split()))
    else:
        for name in call.texts[:1]:
            interpreter.set(name, interpreter.unknown())


def run_parse_arguments(interpreter: Interpreter, call: EvaluatedCommand) -> None:
    """`cmake_parse_arguments(prefix "flags" "single" "many" …)` and its form with PARSE_ARGV."""
    words = list(call.words)
    if words and words[0].text == "PARSE_ARGV":
        if len(words) < 6 or not (words[1].text.isdecimal() and len(words[1].text) < 6):
            return
        passed = list(interpreter.value("ARGV"))[int(words[1].text) :]
        words = [*words[2:6], *passed]
    elif len(words) > 4:  # this form alone takes lists apart, in quotes too
        words = [*words[:4], *(each for word in words[4:] for each in as_value([word]) if each.text)]
    if len(words) < 4:
        return
    prefix = words[0].text
    flags, single, many = ([t for t in word.text.split(";") if t] for word in words[1:4])
    unknown = any(word.text == UNKNOWN for word in words[4:])
    given, values, rest = flags_and_values(words[4:], flags, single, many)
    for name in flags:
        sure = "TRUE" if name in given else "FALSE"
        interpreter.set_text(f"{prefix}_{name}", None if unknown and name not in given else sure)
    for name in (*single, *many):
        absent = interpreter.unknown() if unknown else ()
        interpreter.set(f"{prefix}_{name}", as_value(values[name]) if name in values else absent)
    interpreter.set(f"{prefix}_UNPARSED_ARGUMENTS", as_value(rest))
