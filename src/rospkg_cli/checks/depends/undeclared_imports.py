"""Python imports that package.xml does not declare (DEP101, DEP102)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from functools import cached_property

from ...files import PackageFiles
from ...languages.python.file import Import
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...package.file_role import Role
from ...package.python.python_imports import PackageImports
from ...ros.implied_dependencies import IN_TESTS, LAUNCH, implied_by
from ...source import Span
from ..python.ros1_import import ROS1, ros1_import
from ..python.run_imports import RunImports
from ..python.unrun_tests import is_never_run
from ..reached_modules import ReachedModules
from ..reached_places import ReachedPlaces
from ..repository.foreign_images import foreign_image
from ..unstarted_programs import UnstartedPrograms
from ..why_seldom import AT_TIMES
from .before_imports import (
    BY_PIP_HERE,
    PIP_BEFORE,
    STOOD_IN,
    installed_before,
    is_stood_in,
    ros1_imports,
    told_by_text,
)
from .brought_dependencies import COLCON, ROSDEP, Bringer
from .declared_dependencies import DeclaredDependencies
from .hand_installs import HandInstalls
from .import_provider import import_providers, undeclared_provider
from .other_pythons import HOSTED, OtherPythons
from .pip_installs import PipInstalls, key_of, normalized
from .pip_requirements import distributions_of

RUNNERS = frozenset({"python3-pytest", "launch_ros", "launch_testing", "ament_index_python"})
"""What runs the tests, and finds files for them: it is fine if it comes with a declared dependency."""

BUILDERS = frozenset({"setuptools", "distutils", "pkg_resources", "wheel", "catkin_pkg"})
"""What runs setup.py, or colcon needs itself."""

UNSTARTED = "; nothing here starts this script, as it does other programs of the package"
PIP = "; this repository has pip install it"
TOOL = "; this is a tool beside the programs of the package"


@dataclass(frozen=True, slots=True)
class ImportUse:
    path: str
    span: Span
    module: str


@dataclass(frozen=True, slots=True)
class UndeclaredImport:
    """A dependency that is used and not declared: the name to declare, and where it is imported."""

    name: str
    places: tuple[ImportUse, ...]
    also_provides: tuple[str, ...] = ()
    """What is undeclared as well and comes with this one."""
    bringer: Bringer | None = None
    """The declared dependency that it comes with today, or may come with."""


@dataclass(frozen=True)
class ImportDependencies:
    """The imports of a package, and what it declares."""

    declared: DeclaredDependencies
    python: PackageImports
    files: PackageFiles
    reached: ReachedModules | None = None
    cmake: CMake | None = None
    places: ReachedPlaces | None = None
    programs: UnstartedPrograms | None = None
    pythons: OtherPythons | None = None

    def are_never_run(self, places: Iterable[ImportUse]) -> bool:
        """Return whether all places are in tests that `colcon test` does not run."""
        build_type = self.declared.facts.build_type
        return all(is_never_run(path, self.files, self.cmake, build_type) for path in {each.path for each in places})

    def why_pip(self, missing: UndeclaredImport) -> str:
        """Return what is said of what the requirements, a Dockerfile, a script or a page of the repository have pip
        install, or of what comes so with another library; "" for others.
        """
        index, module = self.declared.workspace.index, missing.places[0].module
        if not self.is_library(missing):
            return ""
        if self.pip.has(module, missing.name, index):
            return PIP
        bringer = self.pip.bringer(module, missing.name, index)
        return bringer and f"; this repository has pip install `{bringer}`, which requires it in most versions"

    def why_brought(self, missing: UndeclaredImport) -> str:
        """Return what is said of a library that people have by their own choice, or with another, or that is called
        optional; "" for others.
        """
        from .brought_by_people import why_brought  # few packages lack something
        from .optional_parts import OptionalParts

        why = why_brought(self.declared, self.python.files, missing.places[0].module, missing.name)
        if why or self.declared.workspace.named(missing.name):
            return why
        key, bare = missing.name, missing.name.removeprefix("python3-")
        names = (key, bare, f"py{bare}", *distributions_of(key))
        return OptionalParts(self.files).why(names, dict.fromkeys(each.path for each in missing.places))

    @cached_property
    def pip(self) -> PipInstalls:
        return PipInstalls(self.files)

    def is_by_hand(self, missing: UndeclaredImport) -> bool:
        """Return whether a page of the repository tells people to install a library by hand."""
        names = (missing.name, missing.places[0].module.partition(".")[0])
        return self.is_library(missing) and HandInstalls(self.files).has(names)

    def is_library(self, missing: UndeclaredImport) -> bool:
        """Return whether more than ROS has what is missing: it has a key of rosdep, or another name on PyPI."""
        return self.declared.workspace.index.is_key(missing.name) or bool(distributions_of(missing.name))

    def serving(self, missing: UndeclaredImport) -> tuple[str, ...]:
        """Return the names that provide what is missing: the one to declare, and others that would do."""
        return (missing.name, *self.declared.workspace.providers_of(missing.places[0].module))

    def is_left(self, places: Iterable[ImportUse]) -> bool:
        """Return whether all places are in modules that nothing starts or imports, beside programs."""
        reached = self.reached
        return reached is not None and all(reached.is_left(path) for path in {each.path for each in places})

    def why_unstarted(self, places: Iterable[ImportUse]) -> str:
        """Return what is said of files for other interpreters, of scripts that nothing starts beside programs that are,
        and of tools; "" for others.
        """
        programs, paths = self.programs, {each.path for each in places}
        if self.pythons is not None and paths <= self.pythons.hosted:
            return HOSTED
        if programs is None:
            return ""
        return UNSTARTED if all(map(programs.has_script, paths)) else TOOL if all(map(programs.is_tool, paths)) else ""

    def why_unmet(self, missing: UndeclaredImport) -> str:
        """Return that, or why rosdep serves nobody with a library: another Python runs all that imports it, or an image
        that the repository builds on may have it.
        """
        why, is_library = self.why_unstarted(missing.places), self.declared.workspace.index.is_key(missing.name)
        why = why or self.why_brought(missing)
        if why or self.pythons is None or not is_library:
            return why
        if why := self.pythons.why_unseen({each.path for each in missing.places}):
            return why
        image = foreign_image(self.files)
        return image.may_bring if image is not None and not self.declared.release.is_made else ""

    def why_seldom(self, uses: Iterable[ImportUse]) -> str:
        """Return what is said where all places seldom or never run, beside what is said of modules; "" for others."""
        found = {self.why_seldom_there(each) for each in uses}
        return "" if "" in found else min(found, default="")

    def why_seldom_there(self, use: ImportUse) -> str:
        """Return what is said of a place that seldom runs: who imports under a condition needs it there alone."""
        if self.places is None:
            return ""
        why = self.places.why_seldom(use.path, use.span)
        why = why or (AT_TIMES if self.places.is_conditional(use.path, use.span) else "")
        return why or self.why_before(use, self.places.run)

    def why_before(self, use: ImportUse, run: RunImports) -> str:
        """Return what is said of an import before which the file has pip install it, or ends at a module of ROS 1."""
        file, workspace = run.modules.at(use.path), self.declared.workspace
        if file is None:
            return ""
        imports = (each for own in self.python.files if own.path == use.path for each in own.imports)
        first = self.older_import(imports)
        if first is not None and first.span.start < use.span.start:
            return f"; it stands behind `import {first.module.partition('.')[0]}`, which ROS 1 alone has"
        wanted, keys = normalized(use.module.partition(".")[0]), workspace.providers_of(use.module)
        told = {normalized(each) for each in installed_before(file, use.span.start)}
        if is_stood_in(file, use.module.partition(".")[0], use.span.start):
            return STOOD_IN
        said = {normalized(each) for each in told_by_text(file)}
        for names, why in ((told, PIP_BEFORE), (said, BY_PIP_HERE)):
            if wanted in names or any(key_of(each, workspace.index) in keys for each in names):
                return why
        return ""

    def older_import(self, imports: Iterable[Import]) -> Import | None:
        """Return the first import at which a file ends, as ROS 1 alone has its module, and nothing here brings one."""
        for each in ros1_imports(imports):
            top = each.module.partition(".")[0]
            is_brought = top in self.declared.names or self.declared.workspace.providers_of(top)
            if not is_brought and normalized(top) not in self.pip.names:
                return each
        return None

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

    def ros1_leftovers(self) -> Iterator[ImportUse]:
        """Yield the first import in each installed file that only ROS 1 can serve: nothing behind it runs."""
        is_for_both = not ROS1.isdisjoint(each.name for each in self.declared.manifest.dependencies)
        for file in self.python.files if self.declared.is_checked and not is_for_both else ():
            first = (ros1_import(file.imports) or self.older_import(file.imports)) if file.role == "run" else None
            if first is not None:
                yield ImportUse(file.path, first.span, first.module)

    def missing(self) -> list[UndeclaredImport]:
        """Return what installed modules and scripts import undeclared, in the order of the files."""
        return self.with_bringers(self.undeclared("run"), runs=True)

    def with_bringers(self, missing: Mapping[str, list[ImportUse]], *, runs: bool) -> list[UndeclaredImport]:
        """Return what is missing, each with what brings it: a declared dependency, or another that is missing."""
        bringers = self.declared.bringers(missing, runs=runs)
        return [UndeclaredImport(name, self.in_use_first(p), (), bringers.get(name)) for name, p in missing.items()]

    def in_use_first(self, places: list[ImportUse]) -> tuple[ImportUse, ...]:
        """Return places with those first that somebody comes to."""
        return tuple(sorted(places, key=self.is_seldom) if len(places) > 1 else places)

    def is_seldom(self, use: ImportUse) -> bool:
        return self.is_left([use]) or bool(self.why_seldom([use]) or self.why_unstarted([use]))

    def missing_in_tests(self) -> list[UndeclaredImport]:
        """Return what only tests import undeclared, but for what comes with other undeclared names."""
        installed = self.undeclared("run")
        found = {name: p for name, p in self.undeclared("test").items() if name not in installed}
        result = []
        for name, places in found.items():
            found_with = self.bringer_in_tests(name)
            is_tool = found_with is not None and found_with.name in (COLCON, ROSDEP)
            if (found_with is None or is_tool) and name in implied_by(found.keys() - {name}, IN_TESTS):
                continue
            if found_with:
                is_fine = name in RUNNERS and found_with.is_certain and not is_tool
                result += [] if is_fine else [UndeclaredImport(name, tuple(places), (), found_with)]
            else:
                brings = sorted(implied_by([name], IN_TESTS) & found.keys())
                result.append(UndeclaredImport(name, tuple(places), tuple(brings)))
        return result

    @cached_property
    def has_pytest(self) -> bool:
        """Whether `colcon test` may run pytest: for a package of setup.py, where that asks for it (colcon-core 0.6 on).

        It runs unittest elsewhere, which finds no test that is a plain function.
        """
        asked = (self.files.readable_text(path) for path in ("setup.py", "setup.cfg") if self.files.exists(path))
        return self.declared.facts.build_type != "ament_python" or any("pytest" in text for text in asked)

    def bringer_in_tests(self, name: str) -> Bringer | None:
        implying = (Bringer(each) for each in sorted(self.declared.names) if name in implied_by([each], IN_TESTS))
        return next(implying, None) or self.declared.bringer([name], runs=False)

    def missing_in_setup(self) -> list[UndeclaredImport]:
        """Return what setup.py itself imports undeclared, but for the tools that run it."""
        found: dict[str, list[ImportUse]] = {}
        python = self.declared.facts.build_type == "ament_python"
        for file in self.python.files if python else ():
            for each in file.imports if file.path == "setup.py" else ():
                name = (
                    undeclared_provider(self.declared, each) if each.module.partition(".")[0] not in BUILDERS else None
                )
                if name:
                    found.setdefault(name, []).append(ImportUse(file.path, each.span, each.module))
        return self.with_bringers(found, runs=False)

    def uses(self, role: Role) -> Iterator[tuple[ImportUse, tuple[str, ...]]]:
        """Yield the imports of files of a role that are not optional, with their providers."""
        for file in self.python.files:
            for each in file.imports if file.role == role else ():
                names = () if each.is_optional or each.is_for_typing else import_providers(self.declared, each)
                if names:
                    yield ImportUse(file.path, each.span, each.module), names

    def undeclared(self, role: Role) -> dict[str, list[ImportUse]]:
        found: dict[str, list[ImportUse]] = {}
        for file in self.python.files if self.declared.is_checked else ():
            for each in file.imports if file.role == role and ros1_import(file.imports) is None else ():
                name = undeclared_provider(self.declared, each)
                if name:
                    found.setdefault(name, []).append(ImportUse(file.path, each.span, each.module))
        return found
