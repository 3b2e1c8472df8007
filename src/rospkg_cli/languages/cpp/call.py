"""The arguments of a call, each with its span."""

from __future__ import annotations

from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...source import Source, Span

PIECE = regex(
    r"""(?P<comment>//[^\n\\]*(?:\\[\s\S][^\n\\]*)*|/\*[\s\S]*?\*/)"""
    r"""|(?P<string>R"(?P<tag>[^()\\\s"]{0,16})\([\s\S]*?\)(?P=tag)"|"[^"\\\n]*(?:\\[\s\S][^"\\\n]*)*")"""
    r"""|(?P<char>(?<![0-9A-Za-z_])'(?:[^'\\\n]|\\.)+')"""
    r"""|(?P<open>[({\[])|(?P<close>[)}\]])|(?P<comma>,)|(?P<other>[<>])"""
)
LITERAL = regex(r'"((?:[^"\\\n]|\\.)*)"(?:\s*"((?:[^"\\\n]|\\.)*)")?')
MAX_LENGTH = 20_000
"""A longer call is not read."""


@dataclass(frozen=True, slots=True)
class CppArgument:
    text: str
    """Without comments; every run of blanks is one."""
    span: Span

    @property
    def literal(self) -> str | None:
        """The content of a plain string literal (or of two joined ones); None for anything else."""
        found = LITERAL.fullmatch(self.text)
        if found is None or "\\" in self.text:
            return None
        return found.group(1) + (found.group(2) or "")

    @property
    def inner(self) -> Span:
        """The span of a string's content, or of the argument."""
        if self.text[:1] == '"':
            return Span(self.span.start + 1, self.span.end - 1)
        return self.span


@dataclass(frozen=True, slots=True)
class CppCall:
    """A name with its arguments: `NAME(a, b)`, `name<T>(a)`, `Name<T> variable(a, b)`."""

    name: str
    template: str
    """The text between `<` and `>`, "" where there is none."""
    arguments: tuple[CppArgument, ...] | None
    """None where no parentheses follow: the declaration of a variable, or a type."""
    variable: str
    """The variable that is declared, "" where there is none."""
    span: Span
    """From the name to the closing parenthesis."""
    is_conditional: bool


def arguments(source: Source, at: int) -> tuple[tuple[CppArgument, ...], int] | None:
    """Return the arguments behind the parenthesis or brace at an offset, and where they end; None if unclosed.

    Commas between `<` and `>` separate arguments too, as they do for the preprocessor.
    """
    text, depth, start = source.text, 0, at + 1
    found: list[CppArgument] = []
    for match in PIECE.finditer(text, at, at + MAX_LENGTH):
        kind = match.lastgroup
        if kind == "open":
            depth += 1
        elif kind == "close":
            depth -= 1
            if depth == 0:
                last = argument_between(source, start, match.start())
                return (*found, last) if found or last.text else (), match.end()
        elif kind == "comma" and depth == 1:
            found.append(argument_between(source, start, match.start()))
            start = match.end()
    return None


def argument_between(source: Source, start: int, end: int) -> CppArgument:
    """Return the argument between two offsets, without the comments and blanks around it."""
    raw = source.text[start:end]
    if "//" not in raw and "/*" not in raw:
        at = end - len(raw.lstrip())
        return CppArgument(" ".join(raw.split()), Span(at, at + len(raw.strip())))
    comments = [m.span() for m in PIECE.finditer(source.text, start, end) if m.lastgroup == "comment"]
    borders = [start, *(offset for comment in comments for offset in comment), end]
    code = [stripped_span(source.text, *borders[i : i + 2]) for i in range(0, len(borders), 2)]
    code = [span for span in code if span.start < span.end] or [Span(end, end)]
    text = " ".join(" ".join(source.slice(span) for span in code).split())
    return CppArgument(text, Span(code[0].start, code[-1].end))


def stripped_span(text: str, start: int, end: int) -> Span:
    """Return a span without the blanks at its ends."""
    raw = text[start:end]
    return Span(start + len(raw) - len(raw.lstrip()), start + len(raw.rstrip()))


def template_end(text: str, at: int) -> int | None:
    """Return the offset behind the `>` that closes the `<` at an offset; None where there is none within MAX_LENGTH."""
    depth = 0
    for match in PIECE.finditer(text, at, at + MAX_LENGTH):
        kind = match.lastgroup
        if kind == "other":
            depth += 1 if match.group() == "<" else -1
            if depth == 0:
                return match.end()
        elif kind in ("open", "close") and match.group() in "{}":
            return None
    return None
