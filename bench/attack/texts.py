"""Damage to the bytes and to the words of one file; a small file stays small, a large one stays below 400 kB."""

from __future__ import annotations

import random
import re
from collections.abc import Callable, Sequence

from .kinds import NESTS, PLAIN_NESTS
from .words import BYTES, HOSTILE

Chance = random.Random
Mutation = Callable[[bytes, str, Sequence[bytes], Chance], bytes]
"""From a file, its kind, and other files of that kind to what becomes of it."""

LIMIT = 400_000
TOKEN = re.compile(rb"\w+|\s+|[^\w\s]")
SIZES = (50, 300, 1_000, 5_000, 20_000)


def some_bytes(data: bytes, kind: str, others: Sequence[bytes], chance: Chance) -> bytes:
    """Change, drop, add or double single bytes."""
    found = bytearray(data)
    for _ in range(chance.choice((1, 1, 2, 4, 16))):
        at = chance.randrange(len(found) + 1)
        how = chance.randrange(4)
        if how == 0 and at < len(found):
            found[at] = chance.randrange(256)
        elif how == 1:
            del found[at : at + chance.choice((1, 2, 8))]
        elif how == 2:
            found[at:at] = chance.choice(BYTES)
        else:
            found[at:at] = found[at : at + chance.choice((1, 4, 32))]
    return bytes(found)


def drop_tokens(data: bytes, kind: str, others: Sequence[bytes], chance: Chance) -> bytes:
    tokens = TOKEN.findall(data)
    at = chance.randrange(len(tokens) + 1)
    del tokens[at : at + chance.choice((1, 1, 2, 5, 20))]
    return b"".join(tokens)


def repeat_tokens(data: bytes, kind: str, others: Sequence[bytes], chance: Chance) -> bytes:
    """Double a few words, or say them a thousand times."""
    tokens = TOKEN.findall(data)
    at, length = chance.randrange(len(tokens) + 1), chance.choice((1, 2, 5, 20, 60))
    part = b"".join(tokens[at : at + length])
    times = min(chance.choice((1, 1, 2, 100, 1_000, 3_000)), (LIMIT - min(len(data), LIMIT)) // (len(part) + 1) + 1)
    return b"".join(tokens[:at]) + part * times + b"".join(tokens[at:])


def repeat_lines(data: bytes, kind: str, others: Sequence[bytes], chance: Chance) -> bytes:
    lines = data.splitlines(keepends=True)
    at = chance.randrange(len(lines) + 1)
    part = b"".join(lines[at : at + chance.choice((1, 2, 6, 20))])
    times = min(chance.choice((1, 5, 200, 2_500)), (LIMIT - min(len(data), LIMIT)) // (len(part) + 1) + 1)
    return b"".join(lines[:at]) + part * times + b"".join(lines[at:])


def swap_tokens(data: bytes, kind: str, others: Sequence[bytes], chance: Chance) -> bytes:
    tokens = TOKEN.findall(data)
    words = [at for at, token in enumerate(tokens) if not token.isspace()]
    for _ in range(chance.choice((1, 1, 3)) if words else 0):
        one, two = chance.choice(words), chance.choice(words)
        tokens[one], tokens[two] = tokens[two], tokens[one]
    return b"".join(tokens)


def put_hostile(data: bytes, kind: str, others: Sequence[bytes], chance: Chance) -> bytes:
    """Put something hostile beside a word, or in its place."""
    tokens = TOKEN.findall(data)
    for _ in range(chance.choice((1, 1, 2))):
        words = [at for at, token in enumerate(tokens) if not token.isspace()] or [0]
        at = chance.choice(words)
        tokens[at : at + chance.randrange(2)] = [chance.choice(HOSTILE)]
    return b"".join(tokens)


def splice(data: bytes, kind: str, others: Sequence[bytes], chance: Chance) -> bytes:
    """Put a piece of another file of this kind over a piece of this one."""
    tokens, lent = TOKEN.findall(data), TOKEN.findall(chance.choice(others) if others else data)
    at, start = chance.randrange(len(tokens) + 1), chance.randrange(len(lent) + 1)
    lengths = (0, 1, 4, 16, 64, 256)
    tokens[at : at + chance.choice(lengths)] = lent[start : start + chance.choice(lengths[1:])]
    return b"".join(tokens)


def cut_short(data: bytes, kind: str, others: Sequence[bytes], chance: Chance) -> bytes:
    at = chance.randrange(len(data) + 1)
    return data[:at] if chance.randrange(3) else data[at:]


def nest(data: bytes, kind: str, others: Sequence[bytes], chance: Chance) -> bytes:
    """Put something deep at a word, or in place of the whole."""
    deep = chance.choice((*NESTS.get(kind, PLAIN_NESTS), *PLAIN_NESTS[:1]))(chance.choice(SIZES)).encode()
    if not chance.randrange(6):
        return deep
    tokens = TOKEN.findall(data)
    at = chance.randrange(len(tokens) + 1)
    lines = chance.randrange(2) * b"\n"
    tokens[at : at + chance.randrange(2)] = [lines, deep, lines]
    return b"".join(tokens)


def recode(data: bytes, kind: str, others: Sequence[bytes], chance: Chance) -> bytes:
    """Write the text in an encoding or with line ends that nobody expects."""
    text = data.decode("utf-8", "replace")
    at = chance.randrange(len(text) + 1)
    ways: tuple[Callable[[], bytes], ...] = (
        lambda: (text[:at] + "é" + text[at:]).encode("latin-1", "replace"),
        lambda: text.encode("utf-16"),
        lambda: text.encode("utf-16-le"),
        lambda: text.encode("utf-16-be"),
        lambda: text.encode("utf-32"),
        lambda: b"\xef\xbb\xbf" + data,
        lambda: b"\xef\xbb\xbf\xef\xbb\xbf" + data,
        lambda: data.replace(b"\n", b"\r"),
        lambda: data.replace(b"\n", b"\r\n"),
        lambda: data[: len(data) // 2] + data[len(data) // 2 :].replace(b"\n", b"\r\n"),
        lambda: data.replace(b"\n", b"\n\r", 3),
        lambda: data.replace(b" ", "\u00a0".encode()),
        lambda: data.replace(b"\n", "\u2028".encode()),
        lambda: data.replace(b"\n", b"\n\x0c"),
        lambda: b"# -*- coding: " + chance.choice((b"latin-1", b"utf-16", b"rot13", b"idna", b"x")) + b" -*-\n" + data,
        lambda: re.sub(rb'encoding="[^"]*"', b'encoding="UTF-16"', data),
        lambda: b'<?xml version="1.1" encoding="latin-1"?>' + data,
        lambda: data.replace(b"a", b"\xed\xa0\x80", 1),
        lambda: b"\x00" + data,
        lambda: b"\x00" * 100,
        lambda: b"",
    )
    return chance.choice(ways)()


def retype(data: bytes, kind: str, others: Sequence[bytes], chance: Chance) -> bytes:
    """Give a key of a TOML file a value of another type, deep, long or odd; the file mostly stays TOML."""
    lines = data.decode("utf-8", "replace").splitlines()
    at = chance.choice([n for n, line in enumerate(lines) if "=" in line or line.startswith("[")] or [0])
    deep = chance.choice(SIZES[:4])
    values = (
        "3",
        "[]",
        "{}",
        '""',
        "[[1]]",
        "nan",
        "1979-05-27",
        '["\\u001b[2J"]',
        '["*"]',
        '["["]',
        "{ XML = 1 }",
        '"\\U000e0001"',
    )
    value = chance.choice((*values, "[" * deep + "]" * deep, "{a=" * deep + "1" + "}" * deep, f'["{"*" * deep}a"]'))
    key = lines[at].strip("[] ").partition("=")[0].partition(".")[0].strip() if lines else "new"
    if lines and "=" in lines[at]:
        lines[at] = f"{key} = {value}"
    else:
        lines = [f"{key} = {value}"]  # what should be a table
    return "\n".join([*lines, ""]).encode("utf-8", "replace")


MUTATIONS: tuple[Mutation, ...] = (
    some_bytes,
    some_bytes,
    drop_tokens,
    repeat_tokens,
    repeat_lines,
    swap_tokens,
    put_hostile,
    put_hostile,
    splice,
    splice,
    cut_short,
    nest,
    recode,
)
