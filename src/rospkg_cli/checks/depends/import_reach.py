"""Whether anything runs an import: which modules are left over, optional, or of programs that nothing starts."""

from __future__ import annotations

from collections.abc import Iterable

from ...light_dataclasses import dataclass
from ...package.python.python_imports import PackageImports
from ...ros.implied_dependencies import LAUNCH
from ..python.run_imports import RunImports
from ..reached_modules import ReachedModules
from ..reached_places import ReachedPlaces
from ..unstarted_programs import UnstartedPrograms
from ..why_seldom import AT_TIMES
from .before_imports import (
    BY_PIP_HERE,
    PIP_BEFORE,
    STOOD_IN,
    installed_before,
    is_stood_in,
    named_in_text,
)
from .declared_dependencies import DeclaredDependencies
from .import_use import ImportUse, UndeclaredImport
from .other_pythons import HOSTED, OtherPythons
from .pip_installs import key_of, normalized
from .ros1_import_ends import Ros1ImportEnds

UNSTARTED = "; nothing here starts this script, as it does other programs of the package"
TOOL = "; this is a tool next to the programs of the package"


@dataclass(frozen=True)
class ImportReach:
    declared: DeclaredDependencies
    python: PackageImports
    ends: Ros1ImportEnds
    reached: ReachedModules | None
    places: ReachedPlaces | None
    programs: UnstartedPrograms | None
    pythons: OtherPythons | None

    def is_left(self, places: Iterable[ImportUse]) -> bool:
        """Return whether all places are in modules that nothing starts or imports, while programs are started."""
        reached = self.reached
        return reached is not None and all(reached.is_left(path) for path in {each.path for each in places})

    def are_optional(self, places: Iterable[ImportUse]) -> bool:
        """Return whether all places are in modules that others import only where that may fail."""
        reached = self.reached
        return reached is not None and all(
            reached.is_optional(path) or reached.is_left(path) for path in {each.path for each in places}
        )

    def is_for_launch(self, missing: UndeclaredImport) -> bool:
        """Return whether it is a part of launch, in modules that only launch files import."""
        paths = {each.path for each in missing.places}
        return missing.name in LAUNCH and self.reached is not None and all(map(self.reached.is_for_launch, paths))

    def why_unstarted(self, places: Iterable[ImportUse]) -> str:
        """Return why nothing of the package starts any place, as the end of a message; "" where something may.

        Another interpreter runs these files, or they are scripts that nothing starts, as it does other programs, or
        tools.
        """
        programs, paths = self.programs, {each.path for each in places}
        if self.pythons is not None and paths <= self.pythons.hosted:
            return HOSTED
        if programs is None:
            return ""
        return UNSTARTED if all(map(programs.has_script, paths)) else TOOL if all(map(programs.is_tool, paths)) else ""

    def why_seldom(self, uses: Iterable[ImportUse]) -> str:
        """Return why each place seldom or never runs, as the end of a message; "" where one may."""
        found = {self.why_seldom_there(each) for each in uses}
        return "" if "" in found else min(found, default="")

    def why_seldom_there(self, use: ImportUse) -> str:
        """Return why a place seldom runs, such as a condition around the import; "" where it may run at any time."""
        if self.places is None:
            return ""
        why = self.places.why_seldom(use.path, use.span)
        why = why or (AT_TIMES if self.places.is_conditional(use.path, use.span) else "")
        return why or self.why_before(use, self.places.run)

    def why_before(self, use: ImportUse, run: RunImports) -> str:
        """Return that a file has pip install the module before it imports it, or ends before that at one of ROS 1."""
        file, workspace = run.modules.at(use.path), self.declared.workspace
        if file is None:
            return ""
        imports = (each for own in self.python.files if own.path == use.path for each in own.imports)
        first = self.ends.first(imports)
        if first is not None and first.span.start < use.span.start:
            return f"; it stands behind `import {first.module.partition('.')[0]}`, which ROS 1 alone has"
        wanted, keys = normalized(use.module.partition(".")[0]), workspace.providers_of(use.module)
        installed = {normalized(each) for each in installed_before(file, use.span.start)}
        if is_stood_in(file, use.module.partition(".")[0], use.span.start):
            return STOOD_IN
        said = {normalized(each) for each in named_in_text(file)}
        for names, why in ((installed, PIP_BEFORE), (said, BY_PIP_HERE)):
            if wanted in names or any(key_of(each, workspace.index) in keys for each in names):
                return why
        return ""

    def in_use_first(self, places: list[ImportUse]) -> tuple[ImportUse, ...]:
        """Return places with those first that run at any time."""
        return tuple(sorted(places, key=self.is_seldom) if len(places) > 1 else places)

    def is_seldom(self, use: ImportUse) -> bool:
        return self.is_left([use]) or bool(self.why_seldom([use]) or self.why_unstarted([use]))
