"""What `set`, `list`, `math` and the like do to variables."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace

from .evaluated_command import EvaluatedCommand, flags_and_values
from .interpreter import Interpreter
from .regex import replace_all, search, steps
from .values import UNKNOWN, Value, Word, as_value, bounded, joined, texts

NUMBER = re.compile(r"-?\d{1,9}")
PRODUCT = re.compile(r"\s*(-?\d{1,9})\s*([-+*/%])\s*(-?\d{1,9})\s*")


def run_set(machine: Interpreter, call: EvaluatedCommand) -> None:
    if not call.words or call.texts[0].startswith("ENV{"):
        return
    name, words = call.texts[0], list(call.words[1:])
    keywords = [word.text for word in words if not word.quoted]
    if "CACHE" in keywords:
        at = keywords.index("CACHE")
        is_switch = keywords[at + 1 : at + 2] == ["BOOL"]
        if machine.known(name) is None:
            machine.set(name, machine.hole() if is_switch else as_value(words[:at]))
    elif keywords[-1:] == ["PARENT_SCOPE"]:
        if machine.scope.around is not None:
            machine.spend(len(words))
            machine.scope.around.set(name, as_value(words[:-1]))
    else:
        machine.set(name, as_value(words))


def run_unset(machine: Interpreter, call: EvaluatedCommand) -> None:
    for name in call.texts[:1]:
        machine.set(name, ())


def run_option(machine: Interpreter, call: EvaluatedCommand) -> None:
    """An option is whatever the user wants."""
    if call.words and call.texts[0] != "BUILD_TESTING" and machine.known(call.texts[0]) is None:
        machine.set(call.texts[0], machine.hole())


def run_list(machine: Interpreter, call: EvaluatedCommand) -> None:
    if len(call.words) < 2:
        return
    operation, name = call.texts[0].upper(), call.texts[1]
    if operation in ("FILTER", "TRANSFORM"):
        machine.spend(sum(steps(each.text, word.text) for each in call.words[3:5] for word in machine.value(name)) >> 6)
    if operation in CHANGES:
        changed = CHANGES[operation](machine.value(name), call.words[2:])
        machine.set(name, machine.hole() if changed is None else bounded(changed))
    elif operation in ("LENGTH", "GET", "FIND", "JOIN", "SUBLIST"):
        machine.set(call.texts[-1], derived(machine, operation, machine.value(name), call.words[2:-1]))
    elif operation in ("POP_BACK", "POP_FRONT"):
        pop(machine, operation, name, call.texts[2:])
    else:
        machine.set(name, machine.hole())


def without(value: Value, words: Sequence[Word]) -> Value:
    gone = {word.text for word in words}
    return tuple(word for word in value if word.text not in gone)


def without_repeats(value: Value, _: Sequence[Word]) -> Value:
    first: dict[str, Word] = {}
    for word in value:
        if word.text not in first or (first[word.text].maybe and not word.maybe):
            first[word.text] = word
    return tuple(word if word.text == UNKNOWN else first[word.text] for word in dict.fromkeys(first.values()))


def filtered(value: Value, words: Sequence[Word]) -> Value | None:
    if len(words) != 3 or words[1].text != "REGEX" or UNKNOWN in words[2].text:
        return None
    wanted = words[0].text == "INCLUDE"
    kept: list[Word] = []
    for word in value:
        fits = None if UNKNOWN in word.text else search(words[2].text, word.text)
        if fits is None:
            kept.append(replace(word, text=UNKNOWN))
        elif fits == wanted:
            kept.append(word)
    return tuple(kept)


def transformed(value: Value, words: Sequence[Word]) -> Value | None:
    """Return a list with each element changed; a `;` that comes in parts it."""
    change = transformation(texts(tuple(words)))
    if change is None:
        return None
    changed = [(word, UNKNOWN if word.text == UNKNOWN else change(word.text)) for word in value]
    return as_value(replace(word, text=UNKNOWN if text is None else text) for word, text in changed)


def transformation(words: Sequence[str]) -> Callable[[str], str | None] | None:
    match words:
        case ["APPEND", text]:
            return lambda each: each + text
        case ["PREPEND", text]:
            return lambda each: text + each
        case ["REPLACE", pattern, by]:
            return lambda each: None if UNKNOWN in pattern + by + each else replace_all(pattern, by, each)
        case ["TOUPPER"]:
            return str.upper
        case ["TOLOWER"]:
            return str.lower
        case _:
            return None


def inserted(value: Value, words: Sequence[Word]) -> Value | None:
    if not words or not NUMBER.fullmatch(words[0].text) or any(word.maybe or word.text == UNKNOWN for word in value):
        return None
    at = int(words[0].text)
    return value[:at] + as_value(words[1:]) + value[at:]


CHANGES: Mapping[str, Callable[[Value, Sequence[Word]], Value | None]] = {
    "APPEND": lambda value, words: value + as_value(words),
    "PREPEND": lambda value, words: as_value(words) + value,
    "REMOVE_ITEM": without,
    "REMOVE_DUPLICATES": without_repeats,
    "FILTER": filtered,
    "INSERT": inserted,
    "TRANSFORM": transformed,
    "SORT": lambda value, _: tuple(sorted(value, key=lambda word: word.text)),
    "REVERSE": lambda value, _: value[::-1],
}


def derived(machine: Interpreter, operation: str, value: Value, words: Sequence[Word]) -> Value:
    """Return what a list operation that only reads gives."""
    numbers = [int(word.text) for word in words if NUMBER.fullmatch(word.text)]
    if any(word.maybe or UNKNOWN in word.text for word in (*value, *words)):
        return machine.hole()
    match operation:
        case "LENGTH":
            return (machine.word(str(len(value))),)
        case "JOIN" if words:
            return as_value([machine.word(words[0].text.join(texts(value)))])
        case "FIND" if words:
            found = texts(value)
            return (machine.word(str(found.index(words[0].text) if words[0].text in found else -1)),)
        case "GET" if len(numbers) == len(words) and all(-len(value) <= n < len(value) for n in numbers):
            return tuple(value[n] for n in numbers)
        case "SUBLIST" if len(numbers) == 2 and numbers[0] >= 0:
            return value[numbers[0] :][: numbers[1] if numbers[1] >= 0 else None]
        case _:
            return machine.hole()


def pop(machine: Interpreter, operation: str, name: str, outputs: Sequence[str]) -> None:
    value = machine.value(name)
    sure = bool(value) and not any(word.maybe or word.text == UNKNOWN for word in value)
    back = operation == "POP_BACK"
    for output in outputs[:1]:
        machine.set(output, (value[-1 if back else 0],) if sure else machine.hole())
    machine.set(name, (value[:-1] if back else value[1:]) if sure and len(outputs) < 2 else machine.hole())


def run_math(machine: Interpreter, call: EvaluatedCommand) -> None:
    """`math(EXPR name "1 + 2")`, for two numbers."""
    if len(call.words) < 3:
        return
    match = PRODUCT.fullmatch(call.texts[2])
    machine.set_text(call.texts[1], compute(int(match[1]), match[2], int(match[3])) if match else None)


def compute(a: int, sign: str, b: int) -> str | None:
    if sign in "/%":
        return None if b == 0 else str(int(a / b) if sign == "/" else a % b)
    return str({"+": a + b, "-": a - b, "*": a * b}[sign])


def run_separate_arguments(machine: Interpreter, call: EvaluatedCommand) -> None:
    if len(call.words) == 1:
        text = joined(machine.value(call.texts[0]))
        machine.set_text(call.texts[0], None if UNKNOWN in text else ";".join(text.split()))
    else:
        for name in call.texts[:1]:
            machine.set(name, machine.hole())


def run_parse_arguments(machine: Interpreter, call: EvaluatedCommand) -> None:
    """`cmake_parse_arguments(prefix "flags" "single" "many" …)` and its form with PARSE_ARGV."""
    words = list(call.words)
    if words and words[0].text == "PARSE_ARGV":
        if len(words) < 6 or not (words[1].text.isdecimal() and len(words[1].text) < 6):
            return
        passed = list(machine.value("ARGV"))[int(words[1].text) :]
        words = [*words[2:6], *passed]
    if len(words) < 4:
        return
    prefix = words[0].text
    flags, single, many = ([t for t in word.text.split(";") if t] for word in words[1:4])
    unknown = any(word.text == UNKNOWN for word in words[4:])
    given, values, rest = flags_and_values(words[4:], flags, single, many)
    for name in flags:
        sure = "TRUE" if name in given else "FALSE"
        machine.set_text(f"{prefix}_{name}", None if unknown and name not in given else sure)
    for name in (*single, *many):
        absent = machine.hole() if unknown else ()
        machine.set(f"{prefix}_{name}", as_value(values[name]) if name in values else absent)
    machine.set(f"{prefix}_UNPARSED_ARGUMENTS", as_value(rest))
