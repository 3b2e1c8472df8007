"""Rule input: requirements in install_requires that package.xml does not declare (SET311)."""

from __future__ import annotations

from collections.abc import Iterator

from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.setup.setup_text import SetupText
from ...ros.aliases import key_for_pip
from ..depends.declared_dependencies import DeclaredDependencies
from ..depends.undeclared_imports import ImportDependencies
from .python_package import PythonPackage

NAME = regex(r"[A-Za-z0-9][A-Za-z0-9_.-]*")
TOOLS = frozenset({"setuptools", "pip", "wheel"})


@dataclass(frozen=True)
class UndeclaredRequirements:
    package: PythonPackage
    declared: DeclaredDependencies
    imports: ImportDependencies

    def found(self) -> Iterator[tuple[SetupText, str, str]]:
        """Yield the requirements that no dependency installs: the text, the name, the rosdep key.

        Requirements that a module imports are left to DEP101.
        """
        if not self.declared.is_checked:
            return
        reported = {missing.name for missing in self.imports.missing()}
        for said in self.package.setup.texts("install_requires"):
            match = NAME.match(said.text)
            name = match.group() if match else ""
            key = key_for_pip(name) if name and name.lower() not in TOOLS else None
            if key is None or ";" in said.text or key in reported or self.declared.has([key]):
                continue
            if not self.declared.bringer([key], runs=True):
                yield said, name, key
