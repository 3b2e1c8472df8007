"""Rule input: paths in one person's home folder that launch files, YAML, CMake and code name."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

from ...files import PackageFiles
from ...languages.python.unreached_places import is_unreached
from ...light_dataclasses import dataclass
from ...package.install_table import InstallTable
from ...package.package_facts import PackageFacts
from ...package.workspace import Workspace
from ..paths.bare_paths import names_nothing
from ..paths.file_dialogs import begins_dialog
from ..paths.home_path_texts import ASKS, IS_SOUGHT, is_guarded_macro, without_comments
from ..paths.written_paths import WrittenPaths
from ..repository.settings_to_change import has_comment_to_change, has_page_to_change
from .home_mention import HomeMention, home_mentions
from .home_owners import HomeOwners
from .home_path import HomePath
from .home_path_code import HomePathCode
from .home_path_values import HomePathValues
from .naming_files import NamingFiles
from .target_package import target_package


@dataclass(frozen=True)
class HomePaths:
    files: PackageFiles
    facts: PackageFacts
    workspace: Workspace
    owners: HomeOwners
    naming: NamingFiles
    code: HomePathCode
    values: HomePathValues
    table: InstallTable | None = None

    @cached_property
    def found(self) -> tuple[HomePath, ...]:
        """Each path once per file; those into this workspace first."""
        found = [each for path in self.files.paths if self.naming.is_read(path) for each in self.of(path)]
        return tuple(sorted(found, key=lambda each: each.of_package is None))

    def of(self, path: str) -> Iterator[HomePath]:
        """Yield the home paths that a file names, where its code may run."""
        if not any(self.files.holds(path, each) for each in (b"/home/", b"/Users/")):
            return
        bare, file = without_comments(path, self.files.readable_text(path)), self.code.python(path)
        halves = list(self.code.halves(path))
        is_asked, written = any(ASKS.search(each) for each in (bare, *halves)), WrittenPaths(path, bare, *halves)
        for mention in home_mentions(path, bare, file):
            if file is None or not is_unreached(file, mention.place):
                yield self.home_path(mention, written, is_asked=is_asked)

    def home_path(self, mention: HomeMention, written: WrittenPaths, *, is_asked: bool) -> HomePath:
        """Return what is known of a path; `is_asked` says that code of the file checks whether something exists."""
        from ..paths.last_resorts import is_last_resort  # few files have such a path

        path, place, values, code = mention.path, mention.place, self.values, self.code
        package, below = target_package(mention.named, self.files, self.facts, self.workspace)
        idle, is_value = self.naming.idle, values.is_value(mention)
        return HomePath(
            path,
            place,
            mention.named,
            package,
            below,
            is_image=mention.is_image,
            may_be_there=is_asked or code.may_fail(mention) or self.owners.are_many(mention.user),
            is_seldom_read=self.is_seldom_read(mention, package, below),
            is_unreached=code.is_unreached(path, place),
            is_unread=code.is_unread(path, place) or values.is_unread(path, place),
            is_written=written.has(place) or (is_value and values.is_of_written(path, place)),
            is_unclaimed=values.is_unclaimed(mention),
            is_last_resort=is_last_resort(path, mention.bare, place, code.python(path)),
            is_off=idle is not None and idle.has(path, place),
        )

    def is_seldom_read(self, mention: HomeMention, package: str | None, below: str) -> bool:
        """Return whether a path is rarely used: nothing reads its file, another value replaces it, people are asked to
        change it, or it is one of several places.
        """
        path, place, bare = mention.path, mention.place, mention.bare
        if self.naming.is_seldom_read(path) or IS_SOUGHT.search(bare, 0, mention.start) is not None:
            return True
        if not mention.is_image and self.naming.is_unused_yaml(path):
            return True
        if self.values.is_unused(path, place) or is_guarded_macro(bare, mention.start):
            return True
        if self.values.is_replaced(mention) or self.values.is_given_otherwise(mention) or self.is_setting(mention):
            return True
        if self.owners.is_home_replaced(mention.user) or begins_dialog(bare, place.start):
            return True
        if not mention.is_image and self.names_nothing(path, package, below):
            return True
        is_in_unread_block = self.values.is_value(mention) and self.values.is_in_unread_block(path, place)
        return is_in_unread_block or self.code.is_for_others(mention)

    def is_setting(self, mention: HomeMention) -> bool:
        """Return whether a comment or a page asks people to write a path of their own at a place."""
        path, left, text = mention.path, self.naming.left, self.files.readable_text(mention.path)
        is_script = left is not None and left.is_uninstalled(path)
        has_comment = has_comment_to_change(text, mention.bare, mention.place.start, is_script=is_script)
        return has_comment or has_page_to_change(self.files, path)

    def names_nothing(self, path: str, package: str | None, below: str) -> bool:
        """Return whether a path without a suffix is that of no file or folder."""
        facts = self.workspace.named(package) if package is not None else None
        return names_nothing(path, below, self.files, self.facts, facts)
