"""The Python packages and modules that setup() installs, and the files that they come from."""

from __future__ import annotations

import posixpath
from collections.abc import Mapping
from functools import cached_property

from ...languages.python.evaluate.sandbox_filesystem import Kind, OutsideError
from ...languages.python.evaluate.values import Mapping as MappingValue
from ...languages.python.evaluate.values import Sequence, Text
from ...light_dataclasses import dataclass
from .find_packages import dotted, package_folder
from .setup_arguments import SetupArguments
from .setup_text import SetupText


@dataclass(frozen=True)
class SetupModules(SetupArguments):
    @cached_property
    def packages(self) -> tuple[SetupText, ...]:
        return self.texts("packages")

    @cached_property
    def package_names(self) -> frozenset[str]:
        """The dotted names of the packages that are installed."""
        return frozenset(dotted(said.text) for said in self.packages)

    @cached_property
    def py_modules(self) -> tuple[SetupText, ...]:
        return self.texts("py_modules")

    @cached_property
    def scripts(self) -> tuple[SetupText, ...]:
        return self.texts("scripts")

    @cached_property
    def package_dir(self) -> Mapping[str, str]:
        """The folder of each package by its name; that of "" is the folder of all others."""
        value = self.value("package_dir")
        if value is None:
            return self.from_cfg.package_dir
        pairs = value.items.items() if isinstance(value, MappingValue) else ()
        return {str(key): item.text.rstrip("/") for key, (_, item) in pairs if isinstance(item, Text)}

    @cached_property
    def package_data(self) -> Mapping[str, tuple[str, ...]]:
        """Patterns of files that are installed with modules, by the name of the package; those of "" are for all."""
        value = self.value("package_data")
        if value is None:
            return self.from_cfg.package_data
        found: dict[str, tuple[str, ...]] = {}
        for key, (_, patterns) in value.items.items() if isinstance(value, MappingValue) else ():
            items = patterns.items if isinstance(patterns, Sequence) else []
            found[str(key)] = tuple(item.text for item in items if isinstance(item, Text))
        return found

    def folder_of(self, package: str) -> str:
        """Return the folder of a package, relative to setup.py."""
        found = package_folder(package, self.package_dir)
        return "" if found == "." else found

    @cached_property
    def modules(self) -> Mapping[str, str]:
        """The modules that are installed: dotted name to file.

        With a module of `py_modules`, setuptools also installs the `__init__.py` of its folder.
        """
        found: dict[str, str] = {}
        for package in self.packages:
            name_of, folder = dotted(package.text), self.folder_of(package.text)
            for name in self.folder.children.get(folder, {}):
                path = f"{folder}/{name}" if folder else name
                if name.endswith(".py") and path != "setup.py" and self.folder.kind(path) == "file":
                    stem = name[: -len(".py")]
                    found[name_of if stem == "__init__" else f"{name_of}.{stem}"] = path
        for module in self.py_modules:
            if (file := self.file_of(module.text)) is not None:
                found[module.text] = file
                init = posixpath.join(posixpath.dirname(file), "__init__.py")
                if (above := module.text.rpartition(".")[0]) and self.kind(init) == "file":
                    found.setdefault(above, init)
        return found

    def kind(self, path: str) -> Kind | None:
        """Return the kind of entry at a path; "unknown" where a link leads out of the package."""
        try:
            return self.folder.kind(path)
        except OutsideError:
            return "unknown"

    def file_of(self, module: str) -> str | None:
        """Return the file of a module in the package, whether it is installed or not."""
        package, _, name = module.rpartition(".")
        folder = self.folder_of(package) if package else self.package_dir.get("", "")
        for path in (posixpath.join(folder, f"{name}.py"), posixpath.join(self.folder_of(module), "__init__.py")):
            if self.kind(posixpath.normpath(path)) == "file":
                return posixpath.normpath(path)
        return None
