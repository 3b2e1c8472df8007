"""Find and read the behavior trees of a package, which BehaviorTree.CPP and nav2 load when they run."""

from __future__ import annotations

from collections.abc import Iterator

from ..files import PackageFiles, ReaderInput
from ..languages.xml.parser import Document, read_xml
from ..light_dataclasses import dataclass
from ..read_problem import ReadProblem
from ..unreadable import Unreadable, UnreadableError
from .file_role import role_of

TREE = "<BehaviorTree"
STOPS = frozenset({ReadProblem.XML_MISMATCH, ReadProblem.XML_OPEN, ReadProblem.XML_CONFLICT})
"""What tinyxml2, which reads the trees, stops at as well."""


@dataclass(frozen=True)
class BehaviorTree:
    document: Document

    @property
    def path(self) -> str:
        return self.document.source.path


def read_behavior_trees(reading: ReaderInput) -> Iterator[BehaviorTree | Unreadable]:
    for path in reading.files.paths:
        if is_tree(reading.files, path) and role_of(path) not in ("test", "aside"):
            try:
                yield BehaviorTree(read_xml(reading.files.source(path), takes_less_than=True))
            except UnreadableError as error:
                if error.unreadable.code in STOPS:
                    yield error.unreadable


def is_tree(files: PackageFiles, path: str) -> bool:
    return path.endswith(".xml") and TREE in files.readable_text(path)
