"""Files in share directories that C++ names by literal parts: `get_package_share_directory("my_pkg") + "/a/b.csv"`."""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.cpp.code_text import code_text
from ...languages.cpp.file import CppFile
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...source import Span
from .share_names import CAUGHT, LOOKUP, NAME

BEHIND = regex(r'\s*[+/]\s*(?:std::string\()?"([\w./ -]+)"\s*\)?\s*(?![\w\s+/"]*[+/])')
"""What is put behind a base; not where more is put behind that."""
FOLDER = regex(r'\s*[+/]\s*(?:std::string\()?"(/?[\w.-]+(?:/[\w.-]+)*)(?:/"\s*\)?\s*\+|/?"\s*/)')
"""The folder behind a base, where more is put behind it: `+ "/maps/" + name`, `/ "maps" / name`."""
VARIABLE = regex(r"(\w+)\s*(?:=|\{|\()\s*(?:\w+::)*\Z")
"""What is before a call whose result a variable is set to."""


@dataclass(frozen=True, slots=True)
class NamedShareFile:
    package: str
    file: str
    """Without blanks behind it, which a command line has there."""
    span: Span
    """Of the text behind the share directory, between the quotes."""


def share_file_paths(file: CppFile) -> Iterator[NamedShareFile]:
    """Yield the files that are put behind a share directory, or a variable that holds one and is set once."""
    text = file.source.text
    if "get_package_share" not in text or CAUGHT in text:
        return  # before the comments are found, which takes longer
    code = code_text(text)
    for call in LOOKUP.finditer(code):
        name = NAME.match(text, call.end()) if "prefix" not in call.group() else None
        if name is None:
            continue
        if behind := BEHIND.match(text, name.end()) or FOLDER.match(text, name.end()):
            yield NamedShareFile(name[1], behind[1].rstrip(), Span(*behind.span(1)))
        elif (variable := VARIABLE.search(code, 0, call.start())) is not None:
            yield from behind_variable(text, code, name[1], variable[1])


def behind_variable(text: str, code: str, package: str, variable: str) -> Iterator[NamedShareFile]:
    named = regex(rf"\b{variable}\b")
    assigned = regex(rf"\b{variable}\s*(?:=(?!=)|\+=|\{{)")
    if len([*assigned.finditer(code)]) == 1:
        for use in named.finditer(code):
            if behind := BEHIND.match(text, use.end()) or FOLDER.match(text, use.end()):
                yield NamedShareFile(package, behind[1].rstrip(), Span(*behind.span(1)))
