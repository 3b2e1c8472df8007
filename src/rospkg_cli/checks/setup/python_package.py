"""Rule input: setup.py together with its package."""

from __future__ import annotations

import posixpath
from functools import cached_property

from ...files import PackageFiles
from ...light_dataclasses import dataclass
from ...package.manifest import Manifest
from ...package.package_facts import PackageFacts
from ...package.python_modules import PythonModules
from ...package.setup.entry_point import EntryPoint
from ...package.setup.setup_py import SetupPy
from ...package.workspace import Workspace
from ...ros.distros import Targets


@dataclass(frozen=True)
class PythonPackage:
    """A package that colcon builds with its setup.py."""

    manifest: Manifest
    setup: SetupPy
    modules: PythonModules
    files: PackageFiles
    facts: PackageFacts
    workspace: Workspace
    targets: Targets

    @property
    def name(self) -> str:
        return self.manifest.name

    @cached_property
    def on_disk(self) -> dict[str, str]:
        """The file of every module in or below a folder with `__init__.py`, installed or not, by its dotted name."""
        listed = {name.partition(".")[0] for name in self.setup.package_names}
        base = self.setup.package_dir.get("", "")
        found: dict[str, str] = {}
        for path in self.files.below(base):
            inside = path[len(base) + 1 :] if base else path
            parts = inside.removesuffix(".py").split("/")
            if not path.endswith(".py") or len(parts) < 2 or not all(part.isidentifier() for part in parts):
                continue
            if parts[0] in listed or self.files.exists(posixpath.join(base, parts[0], "__init__.py")):
                found[".".join(parts[:-1] if parts[-1] == "__init__" else parts)] = path
        return found

    @cached_property
    def roots(self) -> frozenset[str]:
        """The first parts of the names of its own modules."""
        listed = (*self.setup.package_names, *(item.text for item in self.setup.py_modules))
        own = {name.partition(".")[0] for name in listed}
        return frozenset(own | {module.partition(".")[0] for module in self.on_disk} | {self.name})

    def is_node(self, module: str) -> bool:
        """Return whether a module runs a node itself: it imports rclpy."""
        path = self.setup.file_of(module)
        file = self.modules.at(path) if path else None
        return file is not None and any(
            each.module.partition(".")[0] == "rclpy" and not each.is_for_typing and not each.level
            for each in file.imports
        )

    @cached_property
    def extends_command_line(self) -> bool:
        """Whether it extends a command line tool, such as `ros2`: then its scripts are commands, not nodes."""
        return any(entry.group.startswith(("ros2cli.", "ros2")) for entry in self.setup.entry_points)

    @cached_property
    def executables(self) -> tuple[EntryPoint, ...]:
        return tuple(entry for entry in self.setup.entry_points if entry.is_script)

    @cached_property
    def nodes(self) -> tuple[EntryPoint, ...]:
        """The executables that run a node; one with a dash in its name is a command for the shell."""
        if self.extends_command_line:
            return ()
        found = (entry for entry in self.executables if entry.module and "-" not in entry.name)
        return tuple(entry for entry in found if self.is_node(entry.module))

    @property
    def knows_installed_modules(self) -> bool:
        """Whether it is known which modules are installed."""
        setup = self.setup
        return not setup.may_write_files and all(
            setup.knows(name) for name in ("packages", "py_modules", "package_dir")
        )

    @property
    def knows_data_files(self) -> bool:
        """Whether it is known which data files are installed."""
        return not self.setup.may_write_files and self.setup.knows("data_files")
