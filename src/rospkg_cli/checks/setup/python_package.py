"""Rule input: setup.py together with its package."""

from __future__ import annotations

import ast
import posixpath
from functools import cached_property

from ...files import PackageFiles
from ...languages.python.nodes import nodes_of_kind
from ...light_dataclasses import dataclass
from ...package.manifest import Manifest
from ...package.package_facts import PackageFacts
from ...package.python_modules import PythonModules
from ...package.setup.entry_points import EntryPoint
from ...package.setup.setup_py import SetupPy
from ...package.workspace import Workspace
from ...ros.distros import Targets
from ...ros.imports import STANDARD
from ...suggest import nearest, slips
from ..python.ros1_import import ros1_import
from .module_exports import offers


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
        """Every module below a folder with `__init__.py`, whether it is installed or not: dotted name to file."""
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

    def is_missing(self, module: str) -> bool:
        """Return whether a module of the package's own namespace does not exist."""
        setup = self.setup
        if (
            module.rpartition(".")[2] in setup.generated
            or setup.may_write_files
            or not setup.knows("package_dir")
            or setup.file_of(module)
            or self.is_of_missing_folder(module)
            or self.may_be_generated(module)
            or self.is_expected(module)
        ):
            return False
        return module.partition(".")[0] in self.roots or self.misplaced(module) is not None

    def is_of_missing_folder(self, module: str) -> bool:
        """Return whether `packages` lists the module's package and its folder is not there: the build stops at that."""
        setup, package = self.setup, module.rpartition(".")[0]
        is_listed = not setup.searches and package in setup.package_names
        return is_listed and setup.kind(setup.folder_of(package)) is None

    def is_expected(self, module: str) -> bool:
        """Return whether git ignores the file of a module, or a submodule that is not checked out has it."""
        package, _, name = module.rpartition(".")
        folder = self.setup.folder_of(package) if package else self.setup.package_dir.get("", "")
        return self.files.absent.is_expected(posixpath.join(folder, f"{name}.py"))

    def may_be_generated(self, module: str) -> bool:
        """Return whether something else may provide a module: an extension, a template, the target of a link."""
        package, _, name = module.rpartition(".")
        folder = self.setup.folder_of(package) if package else self.setup.package_dir.get("", "")
        if self.setup.kind(posixpath.normpath(folder or ".").removeprefix(".")) == "unknown":
            return True
        names = self.setup.folder.children.get(folder, {})
        return (
            any(each.startswith(f"{name}.") and each != f"{name}.pyi" for each in names) or names.get(name) == "unknown"
        )

    def misplaced(self, module: str) -> str | None:
        """Return the package's own module that a foreign name must refer to: the same except for the package's name, or
        what it begins with.

        A name that package.xml depends on is taken as it is.
        """
        root, _, rest = module.partition(".")
        if root in STANDARD or self.manifest.depends_on(root):
            return None
        tails = {other.partition(".")[2]: other for other in self.on_disk}
        return tails.get(module) or (tails.get(rest) or tails.get(root) if rest else None)

    def suggestion(self, module: str) -> str | None:
        """Return the most similar module of the package that no entry point starts."""
        if (found := self.misplaced(module)) is not None:
            return found
        last, started = module.rpartition(".")[2], {entry.module for entry in self.setup.entry_points}
        modules = (other for other, path in self.on_disk.items() if not path.endswith("/__init__.py"))
        free = [other for other in modules if other not in started]
        same = [other for other in free if other.rpartition(".")[2] == last]
        return same[0] if len(same) == 1 else nearest(module, free)

    def has_attribute(self, module: str, name: str) -> bool:
        """Return whether a module of the package has a name, or may have it, and it is no slip of one that it has."""
        path, first = self.setup.file_of(module), name.partition(".")[0]
        return path is None or (offers(self.modules, self.setup, path, first) and not self.is_slip(path, first))

    def is_slip(self, path: str, name: str) -> bool:
        """Return whether a name is a slip of one that a file itself defines, whatever it may have of elsewhere."""
        file = self.modules.at(path)
        if file is None or file.has_dynamic_names or name in file.definitions:
            return False
        return bool(slips(name, file.definitions))

    def runs_when_imported(self, module: str) -> bool:
        """Return whether a module of the package starts what it does when it is imported."""
        file = self.modules.at(self.setup.file_of(module) or "")
        return file is not None and file.runs_when_imported

    def is_webots_driver(self, module: str) -> bool:
        """Return whether a module of the package has a class with `init` and `step`, which Webots loads by its name."""
        file = self.modules.at(self.setup.file_of(module) or "")
        classes = nodes_of_kind(file.tree, ast.ClassDef) if file is not None else ()
        methods = ({each.name for each in one.body if isinstance(each, ast.FunctionDef)} for one in classes)
        return any({"init", "step"} <= names for names in methods)

    def ros1_module(self, module: str) -> str:
        """Return the module of ROS 1 at which importing a module of the package ends; "" for none."""
        file = self.modules.at(self.setup.file_of(module) or "")
        found = ros1_import(file.imports) if file is not None else None
        return found.module if found is not None else ""

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
        """Whether it extends a command line tool: then its scripts are commands, not nodes."""
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
