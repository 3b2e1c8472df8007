"""Rule input: the headers that a package exports, and who may use them."""

from __future__ import annotations

from ...languages.cmake.evaluated_command import path_in_package
from ...languages.cmake.values import Word
from ...light_dataclasses import dataclass
from ...package.cmake.foreign_commands import foreign_commands
from ...package.cmake.installed_headers import TARGETS, PublicHeaders
from ...package.workspace import Workspace
from .consumers import Consumers

DESCRIPTIONS = "pluginlib_export_plugin_description_file"
AUTOMATIC = ("ament_auto_package", "autoware_ament_auto_package")
LIBRARIES = ("ament_export_libraries", *TARGETS)


@dataclass(frozen=True)
class ExportedHeaders:
    headers: PublicHeaders
    workspace: Workspace
    consumers: Consumers

    @property
    def may_be_used(self) -> bool:
        """Whether the headers are for others: with a library, with nothing else at all, or for a known package."""
        package = self.headers.package
        built = [target for target in package.cmake.targets if target.is_built]
        has_library = any(target.is_library for target in built) or not built
        if has_library and (package.cmake.named(*LIBRARIES) or not built):
            return True
        return self.is_built_against

    def in_doubled_folder(self) -> tuple[Word, str] | None:
        """Return the `include` that is installed as a whole into a folder of that name, and where its headers land.

        None where any header lands elsewhere, or where the longer path is named for those who use them.
        """
        cmake = self.headers.package.cmake
        for rule in cmake.installs if self.headers.table.knows("header") else ():
            words = (word for word in rule.items if path_in_package(word.text, rule.call.folder) == "include")
            word = next((word for word in words if not word.text.endswith("/")), None)
            destination = rule.destination or ""
            if rule.kind != "DIRECTORY" or word is None or not f"{destination}/".startswith("include/"):
                continue
            place = f"{destination}/include"
            rows = [row for row in self.headers.table.rows if row.source in self.headers.offered]
            is_named = any(place in text for call in cmake.calls for text in call.texts)
            if rows and not is_named and all(row.destination.startswith(f"{place}/") for row in rows):
                return word, place
        return None

    @property
    def are_of_plugins(self) -> bool:
        """Whether the package is loaded as plugins or components, and no package of the workspace builds against it."""
        cmake = self.headers.package.cmake
        components = {each.target.text for each in cmake.components}
        libraries = [target.name for target in cmake.targets if target.is_library and target.is_built]
        is_loaded = bool(cmake.named(DESCRIPTIONS)) or (bool(libraries) and components.issuperset(libraries))
        return is_loaded and not self.is_built_against

    @property
    def is_built_against(self) -> bool:
        """Whether a package of the workspace that has targets of its own depends on this one to build."""
        return bool(self.consumers.builders)

    @property
    def are_needed(self) -> bool:
        """Whether a package that is built against this one includes a header of it and has no copy of its own."""
        return bool(self.consumers.including)

    def wanted(self) -> tuple[str, str] | None:
        """Return the first header of include/ that is not installed and that another package includes, and that one.

        None where others may have a header of that path, or where the build may install it after all.
        """
        package, table = self.headers.package, self.headers.table
        is_known = package.cmake.is_complete and not package.cmake.reads_unknown_files and table.knows("header")
        is_known = is_known and package.cmake.ends_a_package and not package.cmake.named(*AUTOMATIC)
        if not is_known or next(foreign_commands(package.cmake), None) or not self.is_built_against:
            return None
        ends = tuple(f"/{row.destination}" for row in table.rows)
        for path in self.headers.offered:
            header = path.partition("/")[2]
            users = () if any(end.endswith(f"/{header}") for end in ends) else self.users_of(header)
            if users:
                return path, users[0]
        return None

    def users_of(self, header: str) -> tuple[str, ...]:
        """Return the packages that include a header which no other one has, and that are built with this one."""
        name = self.headers.package.facts.name
        if any(facts.name != name for facts in self.workspace.having("header_files", header)):
            return ()
        users = (facts for facts in self.workspace.having("included_headers", header) if facts.name != name)
        return tuple(facts.name for facts in users if name in {need.name for need in facts.dependencies})

    def is_included(self, path: str) -> bool:
        """Return whether another package of the workspace includes a header of include/."""
        return self.is_built_against and bool(self.users_of(path.partition("/")[2]))
