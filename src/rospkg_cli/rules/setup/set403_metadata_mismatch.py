"""SET403 metadata-mismatch."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.manifest.placeholders import is_placeholder
from ...checks.setup.metadata import Metadata
from ...edits.same_infos import same_infos_once
from ...edits.setup_py import replace_text
from ...example import SETUP_PY, Example
from ...finding import Fix, Hit, Related, Safety, Severity
from ...ros.licenses import spdx_id
from ...rule import rule


def example(right: str, wrong: str, fix: Safety = Safety.UNSAFE) -> Example:
    good = SETUP_PY.replace(f"'{wrong}'", f"'{right}'")
    return Example(bad={"setup.py": SETUP_PY.replace(f"'{right}'", f"'«{wrong}»'")}, good={"setup.py": good}, fix=fix)


@rule(
    "SET403",
    "metadata-mismatch",
    over=Metadata,
    severity=Severity.INFO,
    examples=(
        example("Drives my robot", "TODO: Package description", Safety.SAFE),
        example("Apache-2.0", "TODO: License declaration", Safety.SAFE),
        example("Ada", "Charles"),
        example("ada@example.org", "charles@example.org"),
    ),
)
def metadata_mismatch(metadata: Metadata) -> Iterator[Hit]:
    """
    ## What it does
    Finds metadata in setup.py that differ from package.xml, and descriptions left by a template.
    The license, maintainer and e-mail address are compared: licenses by their SPDX id, names without regard to case;
    where one of them names several maintainers, one that both name will do. Of another person the name is given, which
    says enough of the address.

    ## Why is this bad?
    The metadata contradict each other; a license above all should not depend on the file that is read. package.xml is
    the one that ROS, bloom and the package index read.

    ## When it is quiet
    Where a value is read from package.xml or can't be evaluated, where one of several maintainers or licenses fits, and
    where package.xml has what a template left (XML104). What it left in setup.py is one finding.

    ## Fix safety
    It is safe where setup.py has what a template left; which of two other values holds is for their owner to say. There
    is none where setup.py names a license that has an SPDX id.
    """
    yield from same_infos_once(differences(metadata), "write what package.xml says")


def differences(metadata: Metadata) -> Iterator[Hit]:
    for name, said, wanted, element in metadata.differing:
        edits = replace_text(said, wanted) if wanted else ()
        is_left = is_placeholder(said.text.strip())
        sure = is_left and (name != "license" or spdx_id(wanted) is not None)
        fix = Fix(f"write `{wanted}`", edits, Safety.SAFE if sure else Safety.UNSAFE) if edits else None
        shown = wanted or metadata.manifest.source.slice(metadata.manifest.span(element))
        other = " ".join(shown.split())
        advice = f"write `{wanted}`" if wanted else "make them one"
        message = f"`{name}` in setup.py is `{said.text}`, package.xml says `{other}`: ROS shows the latter; {advice}"
        related = (Related(metadata.manifest.path, metadata.manifest.span(element), "in package.xml"),)
        level = Severity.INFO if is_left else None
        yield Hit(said.path, said.shown, message, level, related, fix)
