"""XML103 invalid-version."""

from __future__ import annotations

import re
from collections.abc import Iterator

from ...checks.manifest.schema_tests import SchemaTests
from ...example import SETUP_PY, Example, manifest
from ...finding import Edit, Fix, Hit, Safety, Severity
from ...languages.xml.elements import Element
from ...package.manifest import Manifest
from ...ros.manifest import VERSION
from ...rule import rule

GOOD = manifest()
CMAKE = manifest(build_type="ament_cmake")


@rule(
    "XML103",
    "invalid-version",
    over=SchemaTests,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "a leading zero, where tests compare package.xml with its schema",
        Severity.INFO: "a leading zero, where no test does",
    },
    examples=(
        Example(
            bad={
                "package.xml": GOOD.replace("1.0.0", "«1.0»"),
                "setup.py": SETUP_PY.replace("1.0.0", "1.0"),
            },
            good={"package.xml": GOOD},
            fix=Safety.SAFE,
        ),
        Example(
            on="ament_cmake",
            bad={"package.xml": CMAKE.replace("<version>", '<version compatibility="«1.2.0»">')},
            good={"package.xml": CMAKE.replace("<version>", '<version compatibility="0.9.0">')},
        ),
    ),
)
def invalid_version(tests: SchemaTests) -> Iterator[Hit]:
    """
    ## What it does
    Finds versions that are not MAJOR.MINOR.PATCH.
    They are three numbers without leading zeros. A `compatibility` must be such a version, and not a later one than the
    package's own.

    ## Why is this bad?
    colcon refuses a manifest with `1.0` or `1.2.3-rc1`, and builds the folder as a plain package. bloom and
    catkin_prepare_release read nothing else either.

    ## When it is quiet
    A version that colcon reads is left alone, however it compares with tags or changelogs: XML109 and the rules for
    setup.py do that.

    ## Fix safety
    A version of fewer numbers gets zeros; setup.py is changed by SET402.

    ## References
    - [REP-149, version](https://ros.org/reps/rep-0149.html)
    """
    manifest = tests.manifest
    element = manifest.first("version")
    if element is None:
        return
    version = element.text
    if re.fullmatch(r"\d+\.\d+\.\d+", version, re.ASCII) and not VERSION.fullmatch(version):
        message = f"the version `{version}` has a leading zero: {tests.harm}; write it without"
        level = Severity.WARNING if tests.is_tested else Severity.INFO
        yield Hit(manifest.path, manifest.span(element), message, level)
    elif not VERSION.fullmatch(version):
        message = (
            f"the version `{version}` is not three numbers such as `1.0.0`: colcon builds the folder as a plain package"
        )
        yield Hit(manifest.path, manifest.span(element), message, fix=completed(manifest, element))
    compatible = element.attributes.get("compatibility")
    if compatible is None or manifest.schema_format < 3:
        return
    if not VERSION.fullmatch(compatible.value):
        message = f"`compatibility` is `{compatible.value}`, and must be a version such as `1.0.0`: colcon refuses it"
        yield Hit(manifest.path, compatible.value_span, message)
    elif VERSION.fullmatch(version) and numbers(compatible.value) > numbers(version):
        message = (
            f"`compatibility` names `{compatible.value}`, which is later than the version `{version}`; it names the "
            f"oldest version that this one can stand in for"
        )
        yield Hit(manifest.path, compatible.value_span, message)


def completed(manifest: Manifest, element: Element) -> Fix | None:
    """Return what writes a version of one or two numbers with zeros behind them, `1.0` as `1.0.0`."""
    version, span = element.text, manifest.span(element)
    whole = ".".join([*version.split("."), "0", "0"][:3])
    if version.count(".") > 1 or not VERSION.fullmatch(whole) or manifest.source.slice(span) != version:
        return None
    return Fix(f"write `{whole}`", (Edit(manifest.path, span, whole),))


def numbers(version: str) -> tuple[int, ...]:
    return tuple(map(int, version.split(".")))
