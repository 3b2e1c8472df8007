"""Why uses of unknown fields seldom or never run (IDL010)."""

from __future__ import annotations

from collections.abc import Sequence

from ...package.file_role import role_of
from ..why_seldom import AT_TIMES, IN_TEST, WHY, Met
from .field_uses import FieldUses
from .unknown_fields import UnknownField

LEFT = "; nothing starts or imports this module"
UNCALLED, UNREACHED = "; nothing calls this method", "; nothing here leads to this function"
OFF, BY_PATH = "; a switch turns it off that nothing throws", "; it runs only where the file is started by its path"
BY_WORD = "; an annotation alone says so, and who calls the function may hand it something else"
AFTER = "; it runs after another exception alone"
REPLACED, UNUSED = "; the class is defined again below", "; its object is made and never used"
OF_WAYS: tuple[Met, ...] = ("late", "ended", "unspun", "branch", "unshown", "seldom")
NEVER = (LEFT, UNCALLED, UNREACHED, BY_PATH, OFF, AFTER, BY_WORD, REPLACED, UNUSED, *(WHY[each] for each in OF_WAYS))
REASONS = (
    (FieldUses.is_uncalled, UNCALLED),
    (FieldUses.is_unreached, UNREACHED),
    (FieldUses.is_late, WHY["late"]),
    (FieldUses.is_ended, WHY["ended"]),
    (FieldUses.is_by_path, BY_PATH),
    (FieldUses.is_turned_off, OFF),
    (FieldUses.is_in_handler, AFTER),
    (FieldUses.is_by_word, BY_WORD),
    (FieldUses.is_called_with_care, "; who calls it catches that"),
    (FieldUses.is_replaced, REPLACED),
    (FieldUses.is_idle, UNUSED),
    (FieldUses.is_conditional, WHY["branch"]),
    (FieldUses.is_unshown, WHY["unshown"]),
    (FieldUses.is_seldom, WHY["seldom"]),
    (FieldUses.is_unspun, WHY["unspun"]),
    (FieldUses.is_at_times, AT_TIMES),
)
"""Why a use seldom runs."""


def worst_first(uses: FieldUses, places: Sequence[UnknownField]) -> Sequence[tuple[UnknownField, str]]:
    """Return uses, each with why it seldom runs ("" for one that does); the ones that most runs reach come first."""
    found = [(each, why_seldom(uses, each)) for each in places]
    return sorted(found, key=lambda each: (each[1] in NEVER, bool(each[1])))


def why_seldom(uses: FieldUses, use: UnknownField) -> str:
    if uses.is_left(use.path):
        return LEFT
    why = (text for is_so, text in REASONS if is_so(uses, use))
    return next(why, IN_TEST if role_of(use.path) == "test" else "")
