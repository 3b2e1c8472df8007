"""What `list` does to variables: elements that are unknown or conditional stay so."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

from ...lazy_regex import regex
from ...light_dataclasses import replace
from .evaluated_command import EvaluatedCommand
from .interpreter import Interpreter
from .list_text import as_value
from .regex import max_steps, replace_all, search
from .values import UNKNOWN, Value, Word, limited, texts

NUMBER = regex(r"-?\d{1,9}")


def run_list(interpreter: Interpreter, call: EvaluatedCommand) -> None:
    if len(call.words) < 2:
        return
    operation, name = call.texts[0].upper(), call.texts[1]
    if operation in ("FILTER", "TRANSFORM"):
        interpreter.spend(
            sum(max_steps(each.text, word.text) for each in call.words[3:5] for word in interpreter.value(name)) >> 6
        )
    if operation in CHANGES:
        changed = CHANGES[operation](interpreter.value(name), call.words[2:])
        interpreter.set(name, interpreter.unknown() if changed is None else limited(changed))
    elif operation in ("LENGTH", "GET", "FIND", "JOIN", "SUBLIST"):
        interpreter.set(call.texts[-1], read_list(interpreter, operation, interpreter.value(name), call.words[2:-1]))
    elif operation in ("POP_BACK", "POP_FRONT"):
        pop_item(interpreter, operation, name, call.texts[2:])
    else:
        interpreter.set(name, interpreter.unknown())


def remove_items(value: Value, words: Sequence[Word]) -> Value:
    gone = {word.text for word in words}
    return tuple(word for word in value if word.text not in gone)


def remove_duplicates(value: Value, _: Sequence[Word]) -> Value:
    first: dict[str, Word] = {}
    for word in value:
        if word.text not in first or (first[word.text].maybe and not word.maybe):
            first[word.text] = word
    return tuple(word if word.text == UNKNOWN else first[word.text] for word in dict.fromkeys(first.values()))


def filter_items(value: Value, words: Sequence[Word]) -> Value | None:
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


def transform_items(value: Value, words: Sequence[Word]) -> Value | None:
    """Return a list with each element changed; a `;` in a result splits it."""
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


def insert_items(value: Value, words: Sequence[Word]) -> Value | None:
    if not words or not NUMBER.fullmatch(words[0].text) or any(word.maybe or word.text == UNKNOWN for word in value):
        return None
    at = int(words[0].text)
    return value[:at] + as_value(words[1:]) + value[at:]


CHANGES: Mapping[str, Callable[[Value, Sequence[Word]], Value | None]] = {
    "APPEND": lambda value, words: value + as_value(words),
    "PREPEND": lambda value, words: as_value(words) + value,
    "REMOVE_ITEM": remove_items,
    "REMOVE_DUPLICATES": remove_duplicates,
    "FILTER": filter_items,
    "INSERT": insert_items,
    "TRANSFORM": transform_items,
    "SORT": lambda value, _: tuple(sorted(value, key=lambda word: word.text)),
    "REVERSE": lambda value, _: value[::-1],
}


def read_list(interpreter: Interpreter, operation: str, value: Value, words: Sequence[Word]) -> Value:
    """Return the result of a list operation that only reads."""
    numbers = [int(word.text) for word in words if NUMBER.fullmatch(word.text)]
    if any(word.maybe or UNKNOWN in word.text for word in (*value, *words)):
        return interpreter.unknown()
    match operation:
        case "LENGTH":
            return (interpreter.word(str(len(value))),)
        case "JOIN" if words:
            return as_value([interpreter.word(words[0].text.join(texts(value)))])
        case "FIND" if words:
            found = texts(value)
            return (interpreter.word(str(found.index(words[0].text) if words[0].text in found else -1)),)
        case "GET" if len(numbers) == len(words) and all(-len(value) <= n < len(value) for n in numbers):
            return tuple(value[n] for n in numbers)
        case "SUBLIST" if len(numbers) == 2 and numbers[0] >= 0:
            return value[numbers[0] :][: numbers[1] if numbers[1] >= 0 else None]
        case _:
            return interpreter.unknown()


def pop_item(interpreter: Interpreter, operation: str, name: str, outputs: Sequence[str]) -> None:
    value = interpreter.value(name)
    sure = bool(value) and not any(word.maybe or word.text == UNKNOWN for word in value)
    back = operation == "POP_BACK"
    for output in outputs[:1]:
        interpreter.set(output, (value[-1 if back else 0],) if sure else interpreter.unknown())
    interpreter.set(name, (value[:-1] if back else value[1:]) if sure and len(outputs) < 2 else interpreter.unknown())
