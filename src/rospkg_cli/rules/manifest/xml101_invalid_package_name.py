"""XML101 invalid-package-name."""

from __future__ import annotations

import re
from collections.abc import Iterator

from ...checks.manifest.manifest_inputs import ManifestAndFiles, NamedManifest
from ...example import Example, manifest
from ...finding import Hit, Severity
from ...lazy_regex import regex
from ...package.metapackage import is_metapackage
from ...ros.manifest import PACKAGE_NAME
from ...rule import rule

CMAKE = "cmake_minimum_required(VERSION 3.20)\nproject({0})\nfind_package(ament_cmake REQUIRED)\nament_package()\n"
GOOD = manifest(build_type="ament_cmake")
TOLERATED = regex(r"[a-zA-Z][a-zA-Z0-9_-]*")
BUILT = regex(r"[a-zA-Z0-9][a-zA-Z0-9_-]*")
"""What catkin_pkg, and so colcon, takes for a name (catkin_pkg/package.py)."""


def named(name: str) -> dict[str, str]:
    return {"package.xml": GOOD.replace("my_pkg", f"«{name}»"), "CMakeLists.txt": CMAKE.format(name)}


@rule(
    "XML101",
    "invalid-package-name",
    over=NamedManifest,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "a hyphen, where a Python package has that name, or interface files that no build generates",
        Severity.INFO: "a hyphen or an uppercase letter otherwise, where there are no interfaces; `__` and other "
        "names that colcon builds, where no test compares package.xml with its schema and nothing shows a release",
    },
    examples=(
        Example(
            on="ament_cmake",
            bad={**named("my__pkg"), "tracks.yaml": "tracks: {}\n"},
            good={"package.xml": GOOD, "CMakeLists.txt": CMAKE.format("my_pkg")},
        ),
        Example(
            on="ament_cmake", bad=named("My-Pkg"), good={"package.xml": GOOD, "CMakeLists.txt": CMAKE.format("my_pkg")}
        ),
    ),
)
def invalid_package_name(scope: NamedManifest) -> Iterator[Hit]:
    """
    ## What it does
    Finds package names that the schema, colcon, bloom, Python or rosidl refuse.
    Names are made of lowercase letters, digits and single underscores, begin with a letter, do not end with an
    underscore, and have two characters or more.

    ## Why is this bad?
    Other names are refused by the schema, and by bloom or rosidl: `__` separates the names in generated code, Debian
    has no underscores at the end. What does not begin with a letter or digit, or has other signs, colcon takes for no
    package of ROS. A name with a hyphen or an uppercase letter builds, but rosidl refuses it: no interfaces can be
    generated. Python can't import a package whose name has a hyphen.

    ## When it is quiet
    A hyphen or an uppercase letter stops the build only where interfaces are generated. Where interface files are there
    and no CMake file generates them, it is a warning. Otherwise it is an info, but for a hyphen where a folder of
    Python modules has the name, too; in a metapackage, of which nothing is imported, it is one as well. So is a name of
    one letter, with `__`, with a digit first or `_` last: colcon builds it. It is an error where interfaces are
    generated, where a test compares package.xml with its schema, or for a release.

    ## References
    - [REP-144, Mandatory Rules](https://ros.org/reps/rep-0144.html), [REP-149, name](https://ros.org/reps/rep-0149.html)
    """
    package, manifest = scope.package, scope.package.manifest
    element = manifest.first("name")
    name = manifest.name
    if element is None or (PACKAGE_NAME.fullmatch(name) and len(name) > 1):
        return
    better = re.sub(r"[^a-z0-9]+", "_", name.lower()).lstrip("_0123456789").rstrip("_")
    cmake, project = package.files.readable_text("CMakeLists.txt"), name.lower().replace("-", "_")
    if project != name and "ament_package" in cmake and re.search(rf"\bproject\s*\(\s*{re.escape(project)}\b", cmake):
        return  # the project has the right name: CMK001
    hint = f"; call it `{better}`" if PACKAGE_NAME.fullmatch(better) and len(better) > 1 else ""
    what, level = judged(scope)
    yield Hit(manifest.path, manifest.span(element), what + hint, level)


def judged(scope: NamedManifest) -> tuple[str, Severity | None]:
    name = scope.package.manifest.name
    if not name:
        return "the package has no name: colcon refuses the manifest", None
    level = None if scope.is_met else Severity.INFO
    if len(name) == 1:
        return f"the name `{name}` is one character long, REP-144 requires two or more: it can't be released", level
    if TOLERATED.fullmatch(name) and not re.search(r"__|_$", name):
        return odd(scope.package)
    harm = "the schema and bloom refuse it"
    if not BUILT.fullmatch(name):
        harm, level = "colcon builds the folder as a plain package", None
    return f"`{name}` is no package name (lowercase letters, digits, single `_`): {harm}", level


def odd(package: ManifestAndFiles) -> tuple[str, Severity | None]:
    """Return what is said of a name with a hyphen or an uppercase letter."""
    name = package.manifest.name
    level = None if package.generates_interfaces else Severity.WARNING
    has_modules = "-" in name and any(f"/{path}".endswith(f"/{name}/__init__.py") for path in package.files.paths)
    is_harmless = is_metapackage(package.files, package.manifest) or not (has_modules or package.interface_files)
    level = Severity.INFO if is_harmless else level
    sign, harm = "an uppercase letter", "REP-144 allows only lowercase ones"
    if "-" in name:
        sign, harm = "a hyphen", "REP-144 allows only `_`" if level is Severity.INFO else "Python can't import it"
    if package.interface_files and not is_harmless:
        harm = "rosidl refuses it, and the interfaces can't be generated"
    return f"the name `{name}` has {sign}: {harm}", level
