"""The level of a missing file that a launch file names: what opens it, and when (LCH003, LCH004)."""

from __future__ import annotations

import posixpath

from ...package.file_role import role_of
from ...package.launch.collect_texts import READERS
from ...package.launch.joined_path import OPEN
from ...package.launch.launch_file import LaunchFile
from ..fault import Level
from ..repository.left_to_people import UNTIL_NAMED, files_of, why_left
from .given_arguments import why_given
from .idle_actions import NEVER_CALLED, NO_ENTRY, OFF, level_at, level_read
from .include_arguments import IncludeContext
from .launch_context import LaunchContext
from .missing_reference import MissingReference
from .partly_known_paths import ANYTHING
from .read_when_off import ReadWhenOff
from .relative_parameter_files import has_other_values, is_for_nodes
from .undeclared_files import undeclared_for
from .unmet_lookups import package_lacked
from .unread_values import UnreadValues
from .who_meets import ENDS_BEFORE
from .written_by_nodes import saved_for, written_for

LEVELS: tuple[Level | None, ...] = (None, "warning", "info")
"""From the worst to the mildest; None is the rule's own."""


def softened(scope: LaunchContext, each: MissingReference) -> tuple[Level | None, str]:
    """Return the level that a missing file has at most, and why; None where nothing softens it."""
    softer, why = level_of_places(scope.file, each) if each.use != "caught" else ("info", "")
    if why == NO_ENTRY and is_in_left_helper(scope, each):
        softer, why = "info", NEVER_CALLED
    if softer != "info" and (unmet := unmet_by_all(scope, each)):
        softer, why = "info", unmet
    lacked = package_lacked(scope.file, each.span, scope.workspace) if softer != "info" else ""
    if lacked and lacked != each.package:
        softer, why = "info", ENDS_BEFORE.format(lacked)
    if softer != "info" and (left := left_to_people(scope, each) or written_here(scope, each)):
        softer, why = "info", left
    if softer != "info" and (none := lacked_by_search(scope, each)):
        softer, why = "info", none
    if softer != "info" and is_template(scope, each):
        softer, why = "info", UNTIL_NAMED
    if softer != "info" and each.state in ("absent", "no slash") and has_others(scope, each):
        softer = "info"
    if not softer and each.state != "elsewhere" and not scope.is_installed:
        softer, why = "warning", "where it is started from the source: it is not installed"
    return softer, why


def level_of_places(file: LaunchFile, each: MissingReference) -> tuple[Level | None, str]:
    """Return the level of the place that is reached most certainly, and why; Python opens a file in any case."""
    calls = file.evaluated.calls if file.evaluated is not None else ()
    is_early = each.use == "open" and any(call.callee in READERS for call in calls)
    ask = level_at if is_early else level_read
    return min((ask(file, span) for span in (each.span, *each.other_spans)), key=lambda found: LEVELS.index(found[0]))


def is_in_left_helper(scope: LaunchContext, each: MissingReference) -> bool:
    """Return whether every place that names a file is in a function that nothing calls, where launch can't start it."""
    from .left_helpers import is_left  # few files in launch folders have no entry point

    return all(is_left(scope, span) for span in (each.span, *each.other_spans))


def unmet_by_all(scope: LaunchContext, each: MissingReference) -> str:
    """Return why nothing opens a file that a launch file names; "" where something may."""
    if UnreadValues(scope).has(each):
        return "but nothing uses the argument" if each.use == "default" else "but nothing uses the value"
    if ReadWhenOff(scope).has(each):
        return OFF
    if scope.is_overwritten(each):
        return "but the launch file gives the argument another value"
    if IncludeContext(scope).is_untaken(each):
        return "but the included file takes no such argument"
    return undeclared_for(scope, each) or why_given(scope, each)


def has_others(scope: LaunchContext, each: MissingReference) -> bool:
    """Return whether it is only a parameter file of nodes that get other values, too."""
    return is_for_nodes(scope, each) and has_other_values(scope, each)


def left_to_people(scope: LaunchContext, each: MissingReference) -> str:
    """Return why the user is to bring the file; "" where nothing says so, and where another name is intended."""
    own = each.package == scope.package.name
    facts = scope.package if own else scope.workspace.named(each.package)
    if facts is None or each.state != "absent" or each.better_path or each.use == "include":
        return ""
    why = why_left(files_of(scope.files, facts, own=own), each.path, is_code=each.stops_launch)
    return why or written_for(scope, each)


def lacked_by_search(scope: LaunchContext, each: MissingReference) -> str:
    """Return that a file is only named where a search finds none, which is logged; "" where it is not so."""
    from .found_none import FOUND_NONE, is_found_none  # few packages miss a file

    file = scope.file.python
    if file is None or each.state != "absent" or each.stops_launch:
        return ""
    return FOUND_NONE if all(is_found_none(file, span) for span in (each.span, *each.other_spans)) else ""


def is_template(scope: LaunchContext, each: MissingReference) -> bool:
    """Return whether people are to write another name: a comment says so, or the name does (`YOUR_ROBOT.urdf`)."""
    from ..python.blank_names import is_blank, is_to_be_replaced  # few packages miss a file

    name = posixpath.basename(each.path).partition(".")[0]
    return is_blank(name) or is_to_be_replaced(scope.file.source.text, each.span.start)


def written_here(scope: LaunchContext, each: MissingReference) -> str:
    """Return that a program writes a missing file: by its own code, or to where an argument for its output leads."""
    saved = saved_for(scope, each) if each.state == "absent" and each.use == "default" else ""
    return saved or written_by_program(scope, each)


def written_by_program(scope: LaunchContext, each: MissingReference) -> str:
    """Return that the code of a program writes a missing file; what tests write is there for other tests alone."""
    from ..paths.written_by_programs import UNTIL_WRITTEN, writer_of  # few packages miss a file

    if each.state != "absent":
        return ""
    is_named = each.better_path is not None  # the folder and the suffix are those of another file, too
    is_test = role_of(scope.file.path) == "test"
    writer = writer_of(
        scope.files, each.package, each.path.replace(OPEN, ANYTHING), is_named=is_named, with_tests=is_test
    )
    return UNTIL_WRITTEN.format(writer) if writer else ""
