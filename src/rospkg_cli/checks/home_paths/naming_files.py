"""Rule input: which files that name a home path are read in a run: launch files, YAML, CMake and code."""

from __future__ import annotations

from ...files import PackageFiles
from ...light_dataclasses import dataclass
from ...package.file_role import is_set_aside, role_of
from ...package.install_table import InstallTable
from ...package.package_facts import PackageFacts
from ...package.workspace import Workspace
from ..idle_paths import IdlePaths
from ..left_files import LeftFiles
from ..paths.home_path_texts import CPP, MARKUP, YAML
from ..repository.replaced_launch_files import is_named
from ..unstarted_programs import UnstartedPrograms
from ..yaml_elsewhere import is_named_yaml, is_of_another

FOR_CODE = ("launch", "src", "scripts", "script", "nodes", "node", "bin")


@dataclass(frozen=True)
class NamingFiles:
    files: PackageFiles
    facts: PackageFacts
    workspace: Workspace
    table: InstallTable | None = None
    left: LeftFiles | None = None
    programs: UnstartedPrograms | None = None
    idle: IdlePaths | None = None

    def is_read(self, path: str) -> bool:
        """Return whether a file is a launch file, YAML, CMake or code of what is built and runs."""
        if role_of(path) not in ("run", "launch"):
            return False
        read = (".py", *MARKUP, *YAML, *CPP, "CMakeLists.txt")
        return path.endswith(read) and not path.startswith((".", "build/", "install/", "log/"))

    def is_seldom_read(self, path: str) -> bool:
        """Return whether a file is rarely used: it is for RViz, is a script outside of the folders for code, or nothing
        compiles, installs, starts or names it.
        """
        folder = path.partition("/")[0]
        is_aside = path.endswith(".py") and folder not in (self.facts.name, *FOR_CODE)
        is_left = self.left is not None and (
            self.left.has(path) or self.is_no_launch_file(path) or self.left.is_for_tests_alone(path)
        )
        is_left = is_left or (path.endswith(".py") and self.programs is not None and self.programs.has(path))
        is_aside = is_aside or is_set_aside(path) or (self.idle is not None and self.idle.is_of_idle_program(path))
        return path.endswith(".rviz") or is_aside or is_left or (path.endswith(YAML) and self.is_left_out(path))

    def is_no_launch_file(self, path: str) -> bool:
        """Return whether a launch file is never started: it is not installed, and nothing in the run names it."""
        if role_of(path) != "launch" or self.left is None or not self.left.is_uninstalled(path):
            return False
        return not self.left.is_named(path) and not is_named(path, self.files)

    def is_left_out(self, path: str) -> bool:
        """Return whether nothing installs a file."""
        table = self.table
        return table is not None and table.knows("share") and all(row.source != path for row in table.rows)

    def is_unused_yaml(self, path: str) -> bool:
        """Return whether a file is YAML that nothing can give to a node."""
        return path.endswith(YAML) and not self.is_used(path)

    def is_used(self, path: str) -> bool:
        """Return whether anything may give a YAML file to a node."""
        rows = self.table.below(f"share/{self.facts.name}") if self.table is not None else ()
        places = [place for place, row in rows if row.source == path] or [path]
        is_named = is_named_yaml(path, self.facts, self.workspace)
        return is_named and not is_of_another(places, self.facts, self.workspace)
