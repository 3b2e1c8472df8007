"""SET402 version-mismatch."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.setup.python_package import PythonPackage
from ...checks.setup.versioned_package import VersionedPackage
from ...edits.manifest_tags import set_text
from ...edits.setup_py import replace_text
from ...example import SETUP_PY, Example, manifest
from ...finding import Fix, Hit, Related, Safety, Severity
from ...lazy_regex import regex
from ...ros.manifest import VERSION
from ...rule import rule
from ...source import Span

GOOD = manifest()
BAD = SETUP_PY.replace("'1.0.0'", "'«0.0.1»'")
ASKS = regex(r"\bimportlib[._]metadata\b|\bimportlib import metadata\b|\bget_distribution\(")
"""How Python code asks for the version of what is installed."""


@rule(
    "SET402",
    "version-mismatch",
    over=VersionedPackage,
    severity=Severity.INFO,
    levels={Severity.WARNING: "the repository is visibly released, or the code asks for the version that is installed"},
    examples=(
        Example(bad={"setup.py": BAD}, good={"setup.py": SETUP_PY}, fix=Safety.SAFE),
        Example(
            bad={"setup.py": BAD, "package.xml": GOOD.replace("1.0.0", "0.0.0")},
            good={"setup.py": BAD.replace("«0.0.1»", "0.0.1"), "package.xml": GOOD.replace("1.0.0", "0.0.1")},
            fix=Safety.SAFE,
        ),
    ),
)
def version_mismatch(versioned: VersionedPackage) -> Iterator[Hit]:
    """
    ## What it does
    Finds a version in setup.py that differs from the one in package.xml.
    The fix makes both the one in package.xml; where that is still the template's `0.0.0`, the one in setup.py.

    ## Why is this bad?
    bloom releases the version in package.xml, pip and `importlib.metadata` report the one in setup.py: users ask about
    a version that was never released. `catkin_prepare_release` sets both to the next one, without a word. For a package
    that is never released, and that does not read its own version, it is an info. A package counts as released where
    bloom or a job for it says so, or where all packages of the repository have a CHANGELOG.rst; if only some have one,
    these were copied, and are released elsewhere.

    ## When it is quiet
    Where the version is read from a file or can't be evaluated, and where package.xml has a version that colcon
    refuses (XML103).
    """
    package = versioned.package
    said, known = package.setup.setup_text("version"), package.manifest
    element = known.first("version")
    if said is None or element is None or said.text == known.version or not VERSION.fullmatch(known.version):
        return  # a version that colcon refuses is XML103's
    is_unset = known.version == "0.0.0" and VERSION.fullmatch(said.text) is not None
    edits = (set_text(known, element, said.text),) if is_unset else replace_text(said, known.version)
    todo = f"write `{said.text}` in package.xml" if is_unset else f"write `{known.version}`"
    span: Span = known.span(element)
    message = (
        f"setup.py has version `{said.text}`: pip and `importlib.metadata` report it for what ROS releases as "
        f"`{known.version}`; {todo}"
    )
    fix = Fix(todo, edits) if edits else None
    related = (Related(known.path, span, "the version in package.xml"),)
    level = Severity.WARNING if versioned.is_released or is_asked_for(package) else None
    yield Hit(said.path, said.shown, message, level, related, fix)


def is_asked_for(package: PythonPackage) -> bool:
    """Return whether one of the modules asks for the version."""
    texts = (package.files.readable_text(path) for path in package.files.paths if path.endswith(".py"))
    return any(ASKS.search(text) for text in texts)
