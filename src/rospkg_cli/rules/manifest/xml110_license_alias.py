"""XML110 license-alias."""

from __future__ import annotations

from collections.abc import Iterator

from ...edits.manifest_tags import set_text
from ...example import Example, manifest
from ...finding import Fix, Hit, Safety, Severity
from ...package.manifest import Manifest
from ...ros.licenses import spdx_id
from ...rule import Profile, rule

GOOD = manifest(build_type="ament_cmake")


@rule(
    "XML110",
    "license-alias",
    over=Manifest,
    severity=Severity.INFO,
    profile=Profile.PEDANTIC,
    examples=(
        Example(
            on="ament_cmake",
            bad={"package.xml": GOOD.replace("Apache-2.0", "«Apache License 2.0»")},
            good={"package.xml": GOOD},
            fix=Safety.SAFE,
        ),
        Example(
            on="ament_cmake",
            bad={"package.xml": GOOD.replace("Apache-2.0", "«GPLv3»")},
            good={"package.xml": GOOD.replace("Apache-2.0", "GPL-3.0-only")},
            fix=Safety.UNSAFE,
        ),
    ),
)
def license_alias(manifest: Manifest) -> Iterator[Hit]:
    """
    ## What it does
    Finds licenses that are not named by their SPDX id, where the id is known.

    ## Why is this bad?
    People know what `Apache License 2.0` means. Tools that collect the licenses of a product read `Apache-2.0`.

    ## When it is quiet
    It runs with `--pedantic` alone. Names that SPDX does not know, and expressions, are left alone.

    ## Fix safety
    `GPLv3` may mean "version 3 only" or "or later": that fix is unsafe, and writes `-only`, which grants less.

    ## References
    - [SPDX license list](https://spdx.org/licenses/)
    """
    for element in manifest.all("license"):
        known = spdx_id(element.text)
        if known is None or known == element.text:
            continue
        unsure = known.endswith("-only") and "only" not in element.text.lower()
        safety = Safety.UNSAFE if unsure else Safety.SAFE
        fix = Fix(f"Write `{known}`", (set_text(manifest, element, known),), safety)
        message = f"`{element.text}` is called `{known}` by SPDX, which tools read; write that"
        yield Hit(manifest.path, manifest.span(element), message, fix=fix)
