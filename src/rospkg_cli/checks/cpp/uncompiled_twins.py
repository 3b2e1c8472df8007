"""C++ files that no target compiles, while a compiled file includes the header of the same name (CMK202)."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator, Mapping

from ...languages.cpp.code_text import code_text
from ...languages.cpp.file import CppFile
from ...lazy_regex import regex
from ...light_dataclasses import dataclass, replace
from ...source import Span
from ..depends.compiled_sources import own_compiled
from ..depends.header_inclusions import included_paths, paths_by_name
from .linked_sources import LinkedSources
from .uncompiled_functions import called_functions
from .uncompiled_sources import SOURCES, UncompiledSources

HEADERS = (".hpp", ".h", ".hh", ".hxx")
DEFINED = regex(r"(?<![\w:.>])([A-Z]\w+)::(~?\w+)(?=\s*(?:\(|=(?!=)|\{))")
"""A member that is defined outside of its class: a function or a value."""


@dataclass(frozen=True, slots=True)
class UncompiledTwin:
    path: str
    span: Span
    member: str
    header: str
    user: str
    """The compiled file that uses the member and that is certainly linked; "" where none of the package does."""

    @property
    def sentence(self) -> str:
        fault = f"no target in CMakeLists.txt compiles `{self.path}`, which has `{self.member}`"
        if self.user:
            return (
                f"{fault}; `{self.user}` uses it: the linker or the loader stops with an undefined symbol; add the file"
            )
        return f"{fault} and whose header `{self.header}` is: who uses that gets an undefined symbol; add the file"


def uncompiled_twins(sources: UncompiledSources) -> Iterator[UncompiledTwin]:
    """Yield those with a member that their header declares alone, and that is defined nowhere else."""
    if not sources.are_known:
        return
    files, linked = {each.path: each for each in sources.sources}, LinkedSources(sources)
    compiled = [files[each] for each in sorted(own_compiled(sources.package.cmake, sources.sources) or ())]
    by_name = paths_by_name(files)
    for source in sources.sources:
        path = source.path
        if path.endswith(SOURCES) and sources.is_candidate(path) and source not in compiled:
            header = own_header(source, files, by_name)
            if header is not None and header in compiled and not sources.mentioned.has(path):
                twins = first_member(source, header, compiled) or first_function(source, header, compiled)
                yield from (twin if linked.has(twin.user) else replace(twin, user="") for twin in twins)


def own_header(source: CppFile, files: Mapping[str, CppFile], by_name: Mapping[str, list[str]]) -> CppFile | None:
    """Return the one header of the package that a source includes and that is called like it."""
    stem = stem_of(source.path)
    named = (each.path for each in source.includes if each.path.endswith(HEADERS) and stem_of(each.path) == stem)
    paths = {path for name in named for path in included_paths(name, by_name)}
    return files[paths.pop()] if len(paths) == 1 else None


def first_member(source: CppFile, header: CppFile, compiled: list[CppFile]) -> list[UncompiledTwin]:
    """Return the first member that a compiled source uses, or else the first one."""
    texts = {each.path: code_text(each.source.text) for each in compiled}
    declared, whole = texts[header.path], " ".join(texts.values())
    twins: list[UncompiledTwin] = []
    for found in DEFINED.finditer(code_text(source.source.text)):
        owner, member = found[1], re.escape(found[2])
        is_inline = re.search(rf"\b{member}\b\s*(?:\([^;{{}}]*)?[={{]", declared)
        is_declared = re.search(rf"\b(?:class|struct)\b[^;{{]*\b{owner}\b[^;{{]*\{{", declared)
        if is_inline or not is_declared or f"{owner}::{found[2]}" in re.sub(r"\s+", "", defined_in(whole)):
            continue
        words = re.compile(
            rf"\b{owner}(?:::|\s+\w+\s*[({{;]|>)" if member == owner else rf"\b{owner}\s*::\s*{member}\b"
        )
        users = (each for each, text in texts.items() if each.endswith(SOURCES) and words.search(text))
        span = Span(found.start(), found.end())
        twins.append(UncompiledTwin(source.path, span, found[0], header.path, next(users, "")))
    return sorted(twins, key=lambda each: not each.user)[:1]


def first_function(source: CppFile, header: CppFile, compiled: list[CppFile]) -> list[UncompiledTwin]:
    """Return the first function outside of classes that a compiled source calls."""
    texts = {each.path: code_text(each.source.text) for each in compiled}
    files = {each.path: each for each in compiled}
    found = called_functions(source, header, texts, files, code_text(source.source.text))
    return [UncompiledTwin(source.path, span, name, header.path, user) for span, name, user in found][:1]


def defined_in(text: str) -> str:
    return " ".join(found[0] for found in DEFINED.finditer(text))


def stem_of(path: str) -> str:
    return posixpath.splitext(posixpath.basename(path))[0]
