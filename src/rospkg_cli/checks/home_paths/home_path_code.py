"""Rule input: whether Python or C++ code that names a home path is called, and can do without the path."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator

from ...files import PackageFiles
from ...languages.python.file import PythonFile
from ...languages.python.guarded_nodes import is_guarded
from ...light_dataclasses import dataclass
from ...source import Span
from ..cpp.uncalled_members import is_in_uncalled
from ..left_files import LeftFiles
from ..paths.home_path_texts import CPP, is_in_handler, without_comments
from ..reached_definitions import ReachedDefinitions
from ..share_lookup_calls import UNOPENED
from ..unread_paths import UnreadPaths
from .home_mention import HomeMention


@dataclass(frozen=True)
class HomePathCode:
    files: PackageFiles
    definitions: ReachedDefinitions | None = None
    unread: UnreadPaths | None = None
    left: LeftFiles | None = None

    def python(self, path: str) -> PythonFile | None:
        return self.definitions.run.modules.at(path) if self.definitions and path.endswith(".py") else None

    def halves(self, path: str) -> Iterator[str]:
        """Yield the text without comments of the header or source of the same name, where a file is C++.

        One may check for what the other one names.
        """
        stem = posixpath.splitext(posixpath.basename(path))[0]
        for other in self.files.paths if path.endswith(CPP) else ():
            if other != path and other.endswith(CPP) and posixpath.splitext(posixpath.basename(other))[0] == stem:
                yield without_comments(other, self.files.readable_text(other))

    def may_fail(self, mention: HomeMention) -> bool:
        """Return whether Python code tries the path after an error, or handles the error when it can't be opened."""
        file = self.python(mention.path)
        if mention.path.endswith(".py") and is_in_handler(mention.bare, mention.start):
            return True
        return file is not None and is_guarded(file, mention.place, UNOPENED)

    def is_unreached(self, path: str, place: Span) -> bool:
        """Return whether no program of the package calls the function around a place, or no C++ node names it."""
        sources = self.left.sources if self.left is not None and path.endswith(CPP) else ()
        if any(is_in_uncalled(each, place, sources) for each in sources if each.path == path):
            return True
        file = self.python(path)
        return file is not None and self.definitions is not None and not self.definitions.leads_to(file, place)

    def is_unread(self, path: str, place: Span) -> bool:
        """Return whether a place is that of a variable which nothing reads."""
        if self.unread is not None and self.unread.has(path, place):
            return True
        if path.endswith(CPP) and self.left is not None:
            from ..cpp.unread_texts import is_unread_text  # few files have such a path

            every = ((each.path, each.source.text) for each in self.left.sources)
            return is_unread_text(path, without_comments(path, self.files.readable_text(path)), place, every)
        return False

    def is_for_others(self, mention: HomeMention) -> bool:
        """Return whether a path is for another machine, or for one that code asks for by name, or whether it is the
        default of a function that every call replaces.
        """
        from ..paths.chosen_machines import is_for_one_machine, is_on_another_host  # few files have such a path
        from ..python.given_defaults import is_always_given as is_given_by_calls

        file, place = self.python(mention.path), mention.place
        if file is None:
            return is_on_another_host(mention.bare, place.start)
        files = [each for _, each in self.definitions.run.files] if self.definitions is not None else []
        is_away = is_on_another_host(mention.bare, place.start) or is_for_one_machine(file, place)
        return is_away or is_given_by_calls(files, file, place)
