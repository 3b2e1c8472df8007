"""Evaluate `string` and `get_filename_component`."""

from __future__ import annotations

import posixpath
from collections.abc import Sequence

from .evaluated_command import EvaluatedCommand, path_in_package
from .interpreter import Interpreter
from .list_text import list_to_text
from .regex import find_all, max_steps, replace_all
from .values import MAX_TEXT, SOURCE, UNKNOWN


def run_string(interpreter: Interpreter, call: EvaluatedCommand) -> None:
    operation, rest = "".join(call.texts[:1]).upper(), list(call.texts[1:])
    if operation == "REGEX" and rest:
        operation, rest = f"REGEX {rest[0].upper()}", rest[1:]
    if operation in ("APPEND", "PREPEND") and rest:
        held, added = list_to_text(interpreter.value(rest[0])), "".join(rest[1:])
        interpreter.set_text(rest[0], held + added if operation == "APPEND" else added + held)
        return
    output = output_position(operation, rest)
    if output is None:
        return
    name = rest.pop(output)
    unknown = any(UNKNOWN in text for text in rest)
    if not unknown and operation.startswith("REGEX"):
        interpreter.spend(max_steps(rest[0], "".join(rest[1:])) >> 6)
    found = None if unknown else string_result(operation, rest)
    interpreter.set_text(name, None if found is None or len(found) > MAX_TEXT else found)


def output_position(operation: str, rest: Sequence[str]) -> int | None:
    """Return which argument names the variable that is set."""
    at = {
        "REPLACE": 2, "REGEX REPLACE": 2, "REGEX MATCH": 1, "REGEX MATCHALL": 1, "TOLOWER": 1, "TOUPPER": 1,
        "STRIP": 1, "LENGTH": 1, "SUBSTRING": 3, "FIND": 2, "CONCAT": 0, "JOIN": 1, "GENEX_STRIP": 1, "REPEAT": 2,
        "MAKE_C_IDENTIFIER": 1, "CONFIGURE": 1, "TIMESTAMP": 0, "RANDOM": -1, "ASCII": -1, "HEX": 1, "UUID": 0,
        "MD5": 0, "SHA1": 0, "SHA256": 0, "COMPARE": 3, "JSON": 0,
    }.get(operation)  # fmt: skip
    return None if at is None or not rest or at >= len(rest) else at % len(rest)


def string_result(operation: str, rest: Sequence[str]) -> str | None:
    """Return the result of an operation; None where it is not evaluated."""
    match operation, list(rest):
        case "REPLACE", [old, new, *texts] if old:
            return "".join(texts).replace(old, new)
        case "REGEX REPLACE", [pattern, new, *texts]:
            return replace_all(pattern, new, "".join(texts))
        case "REGEX MATCH", [pattern, *texts]:
            found = find_all(pattern, "".join(texts))
            return None if found is None else (found or [""])[0]
        case "REGEX MATCHALL", [pattern, *texts]:
            found = find_all(pattern, "".join(texts))
            return None if found is None else ";".join(found)
        case "TOLOWER", [text]:
            return text.lower()
        case "TOUPPER", [text]:
            return text.upper()
        case "STRIP", [text]:
            return text.strip()
        case "LENGTH", [text]:
            return str(len(text.encode("utf-8", "replace")))
        case "CONCAT", texts:
            return "".join(texts)
        case "JOIN", [glue, *texts]:
            return glue.join(texts)
        case "SUBSTRING", [text, begin, length] if is_count(begin) and is_count(length.removeprefix("-")):
            return text[int(begin) :][: None if length.startswith("-") else int(length)]
        case "FIND", [text, part, *_]:
            return str(text.find(part))
        case "MAKE_C_IDENTIFIER", [text]:
            made = "".join(c if c.isalnum() and c.isascii() else "_" for c in text)
            return f"_{made}" if made[:1].isdigit() else made
        case _:
            return None


def is_count(text: str) -> bool:
    return text.isdecimal() and len(text) < 10


def run_get_filename_component(interpreter: Interpreter, call: EvaluatedCommand) -> None:
    if len(call.texts) < 3:
        return
    name, text, wanted = call.texts[:3]
    interpreter.set_text(name, None if UNKNOWN in text else path_component(text, wanted, interpreter.frame.folder))


def parent(text: str) -> str:
    """Return the folder of a path; above the folder of the package it is written with `..`."""
    if not text.startswith(SOURCE):
        return posixpath.dirname(text)
    path = posixpath.normpath(text[len(SOURCE) :].lstrip("/") or ".")
    is_above = path in (".", "..") or path.endswith("/..")
    return f"{SOURCE}/{posixpath.normpath(f'{path}/..') if is_above else posixpath.dirname(path)}".rstrip("/")


def path_component(text: str, wanted: str, folder: str) -> str | None:
    base = posixpath.basename(text)
    match wanted:
        case "DIRECTORY" | "PATH":
            return parent(text)
        case "ABSOLUTE" | "REALPATH":
            path = path_in_package(text, folder)
            return posixpath.join(SOURCE, path).rstrip("/") if path is not None else None
        case _ if "\1" in base or base == "..":
            return None
        case "NAME":
            return base
        case "NAME_WE":
            return base[0:1] + base[1:].split(".", 1)[0]
        case "NAME_WLE":
            return posixpath.splitext(base)[0]
        case "EXT":
            return base[base.index(".", 1) :] if "." in base[1:] else ""
        case "LAST_EXT":
            return posixpath.splitext(base)[1]
        case _:
            return None
