"""Declarations without a use: what a Python package declares, and nothing in it names."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from pathlib import PurePosixPath

from ...ros.imports import may_serve
from ..files import PackageFiles
from ..manifest import Dependency
from ..unreadable import UnreadableError
from .declared import Declared
from .python import PythonUse
from .serving import served_by

BUILT_IN = frozenset({"depend", "build_depend"})
"""Tags that say "something here is made with it"; in a Python package that is an import."""

IMPORTED_ONLY = re.compile(r".*_(msgs|srvs|interfaces|actions)")
"""Packages that nothing but an import uses; another exec_depend may be there for a node started by name."""

TEXTS = frozenset(
    ".md .rst .py .xml .yaml .yml .launch .urdf .xacro .rviz .sdf .world .cfg .toml .txt .json .ini .sh".split()
)


@dataclass(frozen=True)
class Unused:
    """What package.xml declares, and everything in the package that may use it."""

    declared: Declared
    python: PythonUse
    files: PackageFiles

    def dependencies(self) -> Iterator[Dependency]:
        """Yield the dependencies that are there for an import and that nothing imports or names.

        Only packages built as Python are judged, only where all of their Python could be read, and only where there
        is some: a package without code gathers dependencies on purpose.
        """
        code = [file for file in self.python.files if not file.path.endswith(("setup.py", "__init__.py"))]
        if self.declared.facts.build_type != "ament_python" or not self.python.complete or not code:
            return
        for dependency in self.declared.manifest.dependencies:
            for_import = dependency.tag in BUILT_IN or (
                dependency.tag == "exec_depend" and IMPORTED_ONLY.fullmatch(dependency.name)
            )
            if for_import and not self.is_used(dependency.name):
                yield dependency

    def is_used(self, name: str) -> bool:
        """Return whether anything may use it; `tf2_ros_py` holds the module `tf2_ros`, so its `_py` doesn't count."""
        if name.removesuffix("_py") in {module.partition(".")[0] for module in self.modules}:
            return True
        return name in self.served or name in self.words or any(may_serve(name, module) for module in self.modules)

    @cached_property
    def modules(self) -> frozenset[str]:
        return frozenset(each.module for file in self.python.files for each in file.imports)

    @cached_property
    def served(self) -> frozenset[str]:
        """Every name that may stand behind an import."""
        imports = (each for file in self.python.files for each in file.imports)
        return frozenset(name for each in imports for name in served_by(self.declared, each))

    @cached_property
    def words(self) -> frozenset[str]:
        """Every word of every text but package.xml: launch files, parameters, robot descriptions, what README says."""
        found: set[str] = set()
        for path in self.files.paths:
            if path != "package.xml" and PurePosixPath(path).suffix in TEXTS:
                try:
                    found.update(re.findall(r"[\w-]+", self.files.source(path).text))
                except UnreadableError:
                    continue
        return frozenset(found)
