"""How people get a Python library that package.xml does not declare: by pip, by hand, with another, with an image."""

from __future__ import annotations

from ...files import PackageFiles
from ...light_dataclasses import dataclass
from ...package.python.python_imports import PackageImports
from ..repository.foreign_images import foreign_image
from .declared_dependencies import DeclaredDependencies
from .hand_installs import HandInstalls
from .import_use import UndeclaredImport
from .other_pythons import OtherPythons
from .pip_installs import PipInstalls
from .pip_requirements import distributions_of

PIP = "; this repository has pip install it"


@dataclass(frozen=True)
class ImportSources:
    """Each `why…` returns the end of a message that says so, and "" where nothing does."""

    declared: DeclaredDependencies
    python: PackageImports
    files: PackageFiles
    pip: PipInstalls
    pythons: OtherPythons | None

    def why_pip(self, missing: UndeclaredImport) -> str:
        """Return that requirements, a Dockerfile, a script or a page of the repository have pip install a library, or
        another one that requires it.
        """
        index, module = self.declared.workspace.index, missing.places[0].module
        if not self.is_library(missing):
            return ""
        if self.pip.has(module, missing.name, index):
            return PIP
        bringer = self.pip.bringer(module, missing.name, index)
        return bringer and f"; this repository has pip install `{bringer}`, which requires it in most versions"

    def why_brought(self, missing: UndeclaredImport) -> str:
        """Return that people choose a library for their machine, get it with another, or see it called optional."""
        from .brought_by_people import why_brought  # few packages lack something
        from .optional_parts import OptionalParts

        why = why_brought(self.declared, self.python.files, missing.places[0].module, missing.name)
        if why or self.declared.workspace.named(missing.name):
            return why
        key, bare = missing.name, missing.name.removeprefix("python3-")
        names = (key, bare, f"py{bare}", *distributions_of(key))
        return OptionalParts(self.files).why(names, dict.fromkeys(each.path for each in missing.places))

    def is_by_hand(self, missing: UndeclaredImport) -> bool:
        """Return whether a page of the repository says to install a library by hand."""
        names = (missing.name, missing.places[0].module.partition(".")[0])
        return self.is_library(missing) and HandInstalls(self.files).has(names)

    def is_library(self, missing: UndeclaredImport) -> bool:
        """Return whether more than ROS has what is missing: it has a key of rosdep, or another name on PyPI."""
        return self.declared.workspace.index.is_key(missing.name) or bool(distributions_of(missing.name))

    def why_unmet(self, missing: UndeclaredImport) -> str:
        """Return `why_brought`, or that another Python than that of ROS runs all places, which finds nothing of rosdep,
        or that a base image of a container here may have the library.
        """
        why = self.why_brought(missing)
        if why or self.pythons is None or not self.declared.workspace.index.is_key(missing.name):
            return why
        if why := self.pythons.why_unseen({each.path for each in missing.places}):
            return why
        image = foreign_image(self.files)
        return image.may_bring if image is not None and not self.declared.release.is_made else ""
