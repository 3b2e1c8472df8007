"""What renaming a package changes in a workspace: names of folders, texts, and what is left as it is."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from ..change import ChangeError
from ..change.draft import Draft
from ..change.moved_tree import MovedTree
from ..files import PackageFiles
from ..finding import Edit
from ..light_dataclasses import dataclass
from ..package.package import Package
from ..scaffold.answers_record import RECORD
from ..source import Source, Span
from ..tree import Tree
from .folder_paths import MovedFolders, folder_paths, moved_folders
from .in_cmake import class_names
from .patterns import words
from .references import PROSE, FileInWorkspace, header_guards, inside, places
from .renamed_package import BUILD_FILES, RenamedPackage, other_headers

UNREAD = (
    ".stl",
    ".dae",
    ".obj",
    ".png",
    ".jpg",
    ".jpeg",
    ".gif",
    ".pgm",
    ".pdf",
    ".zip",
    ".gz",
    ".mcap",
    ".db3",
    ".onnx",
)
"""Files that hold no names of packages, and are large."""


@dataclass(frozen=True)
class Left:
    """A place that still says the old name, after the change."""

    path: str
    line: int
    text: str


@dataclass(frozen=True)
class RenamePlan:
    package: RenamedPackage
    draft: Draft
    renamed: dict[str, str]
    """The paths that get a new last part, as they are now, relative to the root."""
    mentions: frozenset[str] = frozenset()
    """The files that hold the old name, as they are now."""
    left: tuple[Left, ...] = ()
    has_new_before: bool = False
    """Whether files of the workspace hold the new name already."""

    def moved(self, path: str) -> str:
        """Return what becomes of a path."""
        return MovedTree(self.draft.base, self.renamed).moved(path)


def plan_rename(tree: Tree, folder: str, old: str, new: str) -> RenamePlan:
    """Return what to change so that the package in a folder has another name; raises ChangeError where it can't be."""
    files = PackageFiles(tree.sub(folder), folder, tree)
    first = RenamedPackage(old, new, Package(files))
    every = tree.files()
    moves = {f"{folder}/{path}".lstrip("/"): name for path, name in first.moves.items()}
    if folder.rpartition("/")[2] == old:
        moves[folder] = new
    refuse_taken(every, moves)
    renamed = RenamedPackage(old, new, first.package, other_headers(every, old, moves.keys() - {folder}))
    moved = MovedTree(tree, moves)
    draft, left, mentions = Draft(moved), list[Left](), set[str]()
    folders = moved_folders(old, moves, every)
    has_model = any(path.endswith(f"/{old}/model.config") for path in every)
    for path, text in texts_with(tree, old):
        mentions.add(path)
        file = FileInWorkspace(path, text, inside(path, files))
        edits = edits_of(moved.moved(path), file, renamed, has_model, folders)
        draft.apply("", edits)
        left += stays(moved.moved(path), text, old, {edit.span for edit in edits})
    return RenamePlan(renamed, draft, moves, frozenset(mentions), tuple(left), any(word_in(tree, new)))


def refuse_taken(paths: Iterable[str], moves: dict[str, str]) -> None:
    """Raise ChangeError where something is at a new path already."""
    known = [*paths]
    for path, name in moves.items():
        above = path.rpartition("/")[0]
        target = f"{above}/{name}".lstrip("/")
        if any(each == target or each.startswith(f"{target}/") for each in known):
            raise ChangeError(f"`{target}` is there already, so `{path}` can't get that name; move it away first")


def texts_with(tree: Tree, name: str) -> Iterator[tuple[str, str]]:
    """Yield the files that hold a name, with their texts; links lead to files that have their own path.

    What `new --update` reads holds the name of its day, and is understood under that.
    """
    data = name.encode()
    for path, kind in tree.files().items():
        if kind != "file" or path.lower().endswith(UNREAD) or path.rpartition("/")[2] == RECORD:
            continue
        try:
            entry = tree.entry(path)
            if data in entry.data or data.upper() in entry.data:
                yield path, entry.text.text
        except (OSError, UnicodeError):
            continue


def word_in(tree: Tree, name: str) -> Iterator[bool]:
    """Yield for each file that holds a name whether it is there as a word."""
    return (any(words(text, name)) for _, text in texts_with(tree, name))


def edits_of(
    path: str, file: FileInWorkspace, renamed: RenamedPackage, has_model: bool, moves: MovedFolders
) -> list[Edit]:
    spans = set(places(file, renamed, has_model))
    if not file.path.endswith(PROSE) or file.path.endswith("CMakeLists.txt"):
        spans |= set(folder_paths(file.text, file.path, moves))
    edits = [Edit(path, span, renamed.new) for span in sorted(spans)]
    if file.inner is not None and file.inner.endswith(BUILD_FILES):
        source = Source(file.inner, file.text)
        edits += [Edit(path, span, renamed.old) for span in class_names(source)]
    upper = [Edit(path, span, renamed.new.upper()) for span in sorted(set(header_guards(file, renamed)))]
    return edits + upper


def stays(path: str, text: str, name: str, changed: set[Span]) -> Iterator[Left]:
    """Yield each line in which a search for the old name as a word still finds it."""
    source, seen = Source(path, text), set[int]()
    for span in words(text, name):
        line = source.position(span.start)[0]
        if span not in changed and line not in seen:
            seen.add(line)
            yield Left(path, line, source.slice(source.line_span(line)).strip())
