"""IDL009 duplicate-interface."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.interfaces.rosidl_targets import RosidlTargets
from ...edits.cmake_commands import remove_argument
from ...example import INTERFACES_CMAKE, Example
from ...finding import Fix, Hit, Related, Safety, Severity
from ...rule import rule


@rule(
    "IDL009",
    "duplicate-interface",
    over=RosidlTargets,
    severity=Severity.INFO,
    examples=(
        Example(
            on="interfaces",
            bad={
                "CMakeLists.txt": INTERFACES_CMAKE.replace(
                    '"srv/SetMode.srv"', '"srv/SetMode.srv"\n  «"msg/Status.msg"»'
                )
            },
            good={"CMakeLists.txt": INTERFACES_CMAKE},
            fix=Safety.SAFE,
        ),
    ),
)
def duplicate_interface(generated: RosidlTargets) -> Iterator[Hit]:
    """
    ## What it does
    Finds files that one `rosidl_generate_interfaces` lists twice.

    ## Why is this bad?
    The second one does nothing, and sooner or later only one of them is renamed.

    ## When it is quiet
    Where one of the two is listed under a condition that can't be evaluated, or by another call.
    """
    for again, first in generated.repeated():
        fix = None
        if again.word.span != first.word.span:
            edit = remove_argument(generated.cmake.file(again.word.path), again.word.span)
            fix = Fix("remove the second one", (edit,)) if edit else None
        message = f"`{again.path}` is listed twice: the second one does nothing; remove it"
        related = (Related(first.word.path, first.word.span, "the first one"),)
        yield Hit(again.word.path, again.word.span, message, related=related, fix=fix)
