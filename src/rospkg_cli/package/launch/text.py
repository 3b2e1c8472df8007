"""Texts of launch files, whatever the frontend: literal pieces and substitutions."""

from __future__ import annotations

from collections.abc import Iterator

from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...source import Span

UNKNOWN = "?"
"""The name of an unknown substitution."""
MARKUP = (".xml", ".launch", ".urdf", ".xacro", ".sdf", ".world")
IN_XML = regex(r"<!--(?:(?!-->)[\s\S]){0,5000}-->")
OTHERS = regex(r"#[^\n]*")


@dataclass(frozen=True, slots=True)
class Literal:
    text: str
    span: Span


@dataclass(frozen=True, slots=True)
class Substitution:
    """`$(name argument …)`; those of Python go by the names that XML gives them."""

    name: str
    arguments: tuple[LaunchText, ...]
    span: Span

    @property
    def shown(self) -> str:
        words = [self.name, *(argument.shown for argument in self.arguments)]
        return "…" if self.name == UNKNOWN else f"$({' '.join(words)})"


@dataclass(frozen=True, slots=True)
class LaunchText:
    """Pieces that make one text when the launch file runs."""

    span: Span
    """Of the text as it is written: between the quotes where there are any."""
    parts: tuple[Literal | Substitution, ...] = ()

    @property
    def literal(self) -> str | None:
        """The whole text; None where it holds a substitution."""
        texts = [part.text for part in self.parts if isinstance(part, Literal)]
        return "".join(texts) if len(texts) == len(self.parts) else None

    @property
    def unknown(self) -> bool:
        """Whether nothing at all is known of it."""
        return len(self.parts) == 1 and isinstance(self.parts[0], Substitution) and self.parts[0].name == UNKNOWN

    @property
    def shown(self) -> str:
        """The text as XML writes it; `…` for what is unknown."""
        return "".join(part.text if isinstance(part, Literal) else part.shown for part in self.parts)

    def substitutions(self, *names: str) -> Iterator[Substitution]:
        """Yield the substitutions of these names (all, if none is given), also those inside of others' arguments."""
        for part in self.parts:
            if isinstance(part, Substitution):
                if not names or part.name in names:
                    yield part
                for argument in part.arguments:
                    yield from argument.substitutions(*names)

    def in_share(self) -> tuple[LaunchText, str] | None:
        """Return the package and the literal path of `$(find-pkg-share package)/path`; None for anything else."""
        match self.parts:
            case (Substitution(name="find-pkg-share", arguments=(package,)), *rest):
                if all(isinstance(part, Literal) for part in rest):
                    path = "".join(part.text for part in rest if isinstance(part, Literal))
                    return package, path.lstrip("/")
        return None


def plain_text(text: str, span: Span) -> LaunchText:
    return LaunchText(span, (Literal(text, span),) if text else ())


def unknown_text(span: Span) -> LaunchText:
    return LaunchText(span, (Substitution(UNKNOWN, (), span),))


def uncommented(path: str, text: str) -> str:
    """Return a text without comments; in Python, YAML and others a `#` in a string counts as the beginning of one."""
    return (IN_XML if path.endswith(MARKUP) else OTHERS).sub("", text)
