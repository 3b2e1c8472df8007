"""Cut Python into tokens by the newest grammar: f-strings and t-strings may nest any expression (PEP 701 and 750).

Each of those becomes `""`, once every expression in it was parsed by itself.
"""

from __future__ import annotations

import ast
import re
import warnings

from ...lazy_regex import regex

MAX_NESTING = 20
"""How deep strings are followed into each other."""

TOKEN = regex(
    r"""(?P<comment>\#[^\r\n]*)
    |(?P<prefix>(?:[bB][rR]?|[rR][bBfFtT]?|[uU]|[fFtT][rR]?)?)(?P<quote>\"{3}|'{3}|["'])
    |(?P<word>\w+)|(?P<newline>\r\n|\r|\n)|(?P<blank>[ \t\f]+|\\(?:\r\n|\r|\n))|(?P<sign>.)""",
    re.VERBOSE | re.DOTALL,
)
REST = {
    '"': regex(r'[^\\"\r\n]*(?:\\(?:\r\n|.)[^\\"\r\n]*)*"', re.DOTALL),
    "'": regex(r"[^\\'\r\n]*(?:\\(?:\r\n|.)[^\\'\r\n]*)*'", re.DOTALL),
    '"""': regex(r'[^\\"]*(?:(?:\\.|"(?!""))[^\\"]*)*"""', re.DOTALL),
    "'''": regex(r"[^\\']*(?:(?:\\.|'(?!''))[^\\']*)*'''", re.DOTALL),
}
"""What follows a plain string's opening quote, by the quote."""

SPECIAL = regex(r"""[{}\\"'\r\n]""")
CONVERSION = regex(r"![rsa][ \t]*")
AFTER_EQUALS = regex(r"=\s*(?=[!:}])")


class NotNewerError(Exception):
    """The text is right in no grammar that is known here."""


def can_be_parsed(text: str) -> bool:
    """Return whether the Python that runs us takes a text."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            ast.parse(text)
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return False
    return True


def tokens_of(text: str, at: int = 0, level: int = 0) -> tuple[list[str], int]:
    """Return the tokens from an offset on, comments left out, and where they end; raises NotNewerError.

    At level 0 that is the end of the text; in the braces of a string (`level` of them around) it is what ends the
    expression: `}`, `!`, `:`, or the `=` before one of these.
    """
    found: list[str] = []
    depth = 0
    while match := TOKEN.match(text, at):
        token = match.group()
        if match["quote"]:
            at, token = string_end(text, match, level), '""' if is_formatted(match["prefix"]) else ""
            found.append(token or text[match.start() : at])
            continue
        if level and not depth and ends_expression(text, at):
            return found, at
        depth += (token in "([{") - (token in ")]}") if match["sign"] else 0
        at = match.end()
        if not match["comment"]:
            found.append(token)
    if level:
        raise NotNewerError
    return found, at


def ends_expression(text: str, at: int) -> bool:
    char = text[at]
    if char == "!":
        return not text.startswith("!=", at)
    return char in "}:" or (char == "=" and text[at - 1] not in "=!<>:" and bool(AFTER_EQUALS.match(text, at)))


def is_formatted(prefix: str) -> bool:
    return bool(set(prefix.lower()) & {"f", "t"})


def string_end(text: str, match: re.Match[str], level: int) -> int:
    """Return where a string ends; raises NotNewerError where it doesn't, or where an f-string is broken."""
    quote, raw = match["quote"], "r" in match["prefix"].lower()
    if is_formatted(match["prefix"]):
        return formatted_end(text, match.end(), quote, raw, level)
    rest = REST[quote].match(text, match.end())
    if rest is None:
        raise NotNewerError
    return rest.end()


def formatted_end(text: str, at: int, quote: str, raw: bool, level: int) -> int:
    while special := SPECIAL.search(text, at):
        at, char = special.start(), special.group()
        if text.startswith(quote, at):
            return at + len(quote)
        if char == "{" and not text.startswith("{{", at):
            at = field_end(text, at + 1, quote, level + 1)
        elif (char == "}" and not text.startswith("}}", at)) or (char in "\r\n" and len(quote) == 1):
            raise NotNewerError
        else:
            at = escape_end(text, at, raw) if char == "\\" else at + (2 if char in "{}" else 1)
    raise NotNewerError


def escape_end(text: str, at: int, raw: bool) -> int:
    if not raw and text.startswith("\\N{", at):
        return text.find("}", at) + 1 or len(text)
    return at + (1 if text[at + 1 : at + 2] in ("{", "}") else 2)


def field_end(text: str, at: int, quote: str, level: int) -> int:
    """Return where a replacement field ends, behind its brace; raises NotNewerError for a broken one."""
    if level > MAX_NESTING:
        raise NotNewerError
    tokens, at = tokens_of(text, at, level)
    expression = "".join(tokens)
    if not expression.strip() or not can_be_parsed(f"({expression}\n)"):
        raise NotNewerError
    if equals := AFTER_EQUALS.match(text, at):
        at = equals.end()
    if conversion := CONVERSION.match(text, at):
        at = conversion.end()
    if text.startswith(":", at):
        at = spec_end(text, at + 1, quote, level)
    if not text.startswith("}", at):
        raise NotNewerError
    return at + 1


def spec_end(text: str, at: int, quote: str, level: int) -> int:
    while special := SPECIAL.search(text, at):
        at, char = special.start(), special.group()
        if char == "}":
            return at
        if text.startswith(quote, at) or (char in "\r\n" and len(quote) == 1):
            raise NotNewerError
        at = field_end(text, at + 1, quote, level + 1) if char == "{" else at + 1
    raise NotNewerError
