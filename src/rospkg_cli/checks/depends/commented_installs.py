"""Which libraries and packages a comment of package.xml has people install by pip, by a script or by hand."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator

from ...lazy_regex import regex
from ...package.manifest import Manifest
from ...ros.aliases import key_for_pip
from .hand_installs import plain
from .pip_installs import normalized
from .pip_requirements import distributions_of, required_by

BY_PIP = regex(r"(?i)(?<![\w-])(?:pip3?|conda|mamba|virtualenv|venv|poetry)(?![\w-])")
"""The name of an installer; `python3-pip` is a dependency."""
BY_HAND = regex(
    r"(?i)\b(?:manual(?:ly|mente)|manuell|manuellement|by hand|from sources?|dockerfile)\b|\.(?:sh|bash)\b"
    r"|\b(?:by|via|with|through|using|from)\b[^\n]{0,40}?\bscripts?\b|\bscripts? installs?\b"
    r"|手[动動]|脚本|スクリプト|수동"
)
"""Other ways to install something, in a sentence that has a word for it."""
INSTALLS = regex(
    r"(?i)install|instal[aoe]|安[装裝]|インストール|설치|\b(?:built?|build|compiled?)\b[^\n]{0,30}\b(?:manually|hand|sources?)\b"
)
ROSDEP = regex(r"(?i)\brosdep (?:will )?installs?\b|\b(?:by|via|with|through) rosdep\b")
"""Says that rosdep installs the declared keys."""
SENTENCE = regex(r"\n[ \t]*\n|[.!?]\s+(?=[A-Z])")
ONE_NAME = regex(r"\s*(?:-\s*)?[\w.-]+,?\s*")
"""A comment that goes on with a list in the comment before it."""
WORD = regex(r"[A-Za-z](?:[\w.+-]*\w)?")
LEFT = "; a comment of package.xml has people install it otherwise"


def is_installed_by_comment(manifest: Manifest, names: Collection[str]) -> bool:
    """Return whether a comment has people install something otherwise, by one of its names, or what requires it."""
    return are_named_in((sentence for text in texts(manifest) for sentence in sentences(text)), names)


def is_said_in(text: str, names: Collection[str]) -> bool:
    """Return whether comments, one on each line, have people install something otherwise, by one of its names."""
    return are_named_in((sentence for line in text.split("\n") for sentence in sentences(line)), names)


def are_named_in(said: Iterable[str], names: Collection[str]) -> bool:
    """Return whether one of some sentences has one of some names, or that of a library which requires it."""
    wanted = {plain(each) for each in names} | {one for each in names for one in distributions_of(each)}
    for sentence in said:
        words = set(WORD.findall(sentence))
        written = {normalized(word) for word in words}
        if not wanted.isdisjoint({*map(plain, words), *map(plain, required_by(written))}):
            return True
        if any(key_for_pip(each) in names for each in (*words, *required_by(written))):
            return True
    return False


def sentences(text: str) -> Iterator[str]:
    """Yield the sentences of a comment about ways to install that are not rosdep."""
    for sentence in SENTENCE.split(text):
        is_other = BY_PIP.search(sentence) or (BY_HAND.search(sentence) and INSTALLS.search(sentence))
        if is_other and not ROSDEP.search(sentence):
            yield sentence


def texts(manifest: Manifest) -> Iterator[str]:
    """Yield the comments, each joined with the comments after it that hold one name of its list."""
    whole, end, said = manifest.source.text, 0, ""
    for comment in manifest.document.comments:
        is_next = not whole[end : comment.span.start].strip()
        if said and is_next and ONE_NAME.fullmatch(comment.text):
            said += f"\n{comment.text}"
        else:
            yield said
            said = comment.text
        end = comment.span.end
    yield said
