"""SET402 version-mismatch."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.setup.python_package import PythonPackage
from ...edits.setup_py import replace_text
from ...example import SETUP_PY, Example
from ...finding import Fix, Hit, Related, Safety, Severity
from ...ros.manifest import VERSION
from ...rule import rule
from ...source import Span

BAD = SETUP_PY.replace("'1.0.0'", "'«0.0.1»'")


@rule(
    "SET402",
    "version-mismatch",
    over=PythonPackage,
    severity=Severity.WARNING,
    examples=(Example(bad={"setup.py": BAD}, good={"setup.py": SETUP_PY}, fix=Safety.SAFE),),
)
def version_mismatch(package: PythonPackage) -> Iterator[Hit]:
    """
    ## What it does
    Finds a version in setup.py that differs from the one in package.xml.

    ## Why is this bad?
    bloom releases the version in package.xml, pip and `importlib.metadata` report the one in setup.py: users ask about
    a version that was never released. `catkin_prepare_release` sets both to the next one, without a word.

    ## When it is quiet
    Where the version is read from a file or can't be evaluated, and where package.xml has a version that colcon
    refuses (XML103).
    """
    said, manifest = package.setup.setup_text("version"), package.manifest
    element = manifest.first("version")
    if said is None or element is None or said.text == manifest.version or not VERSION.fullmatch(manifest.version):
        return  # a version that colcon refuses is XML103's
    edits = replace_text(said, manifest.version)
    fix = Fix(f"write `{manifest.version}`", edits) if edits else None
    span: Span = manifest.span(element)
    message = (
        f"setup.py has version `{said.text}`: pip and `importlib.metadata` report it for what ROS releases as "
        f"`{manifest.version}`; write `{manifest.version}`"
    )
    related = (Related(manifest.path, span, "the version in package.xml"),)
    yield Hit(said.path, said.shown, message, related=related, fix=fix)
