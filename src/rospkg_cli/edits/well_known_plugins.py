"""From misspelt or former names of well-known plugins to what a rule says and offers."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from ..checks.enumeration import in_ticks
from ..checks.plugins.well_known_plugins import WrongPlugin
from ..finding import Edit, Fix, Hit, Related, Safety, Severity
from ..lazy_regex import regex
from .plain_names import only_plain_names

SEPARATOR = regex(r"/|::")


def same_renames(found: Iterable[WrongPlugin]) -> Iterable[list[WrongPlugin]]:
    """Return misspelt plugins one by one; those that one package of a former name had, or of one name, together."""
    by_cause: dict[object, list[WrongPlugin]] = {}
    for each in found:
        one = each.use if each.wrong.better else each.use.name
        cause = SEPARATOR.split(each.use.name)[0] if each.wrong.is_removed else one
        by_cause.setdefault((each.user.folder, cause), []).append(each)
    return by_cause.values()


def well_known(every: Sequence[WrongPlugin]) -> Hit:
    unknown, others = every[0], every[1:]
    use, wrong = unknown.use, unknown.wrong
    path, now = unknown.user.at(use.path), "it is called" if wrong.is_removed else "write"
    more = " in any supported distribution" if wrong.is_removed else ""
    hint = f"; {now} `{wrong.better}`" + (" now" if wrong.is_removed else "") if wrong.better else ""
    if not wrong.is_removed and not wrong.better:
        of = SEPARATOR.split(use.name)[0]
        message = f"`{of}` has no plugin `{use.name}` in any distribution: loading it fails, unless another package"
        places = tuple(Related(each.user.at(each.use.path), each.use.span, "here too") for each in others)
        return Hit(path, use.span, f"{message} describes one of this name", Severity.INFO, places)
    names = {each.use.name for each in others} - {use.name}
    alike = f" (so with {in_ticks(sorted(names))})" if names else ""
    message = f"no plugin is called `{use.name}`{more}: loading it fails{hint}{alike}"
    places = tuple(Related(each.user.at(each.use.path), each.use.span, "here too") for each in others)
    better = {each.wrong.better for each in every}
    edits = tuple(Edit(each.user.at(each.use.path), each.use.span, each.wrong.better or "") for each in every)
    fix = None if "" in better or None in better else Fix(f"write `{wrong.better}`", edits, Safety.UNSAFE)
    if unknown.is_guess:
        message = f"`{use.name}` is no well-known plugin: loading it fails, unless another package describes it{hint}"
        return Hit(path, use.span, f"{message} if that is intended", Severity.INFO, places)
    level = Severity.INFO if wrong.is_removed or not any(each.use.is_listed for each in every) else None
    return Hit(path, use.span, message, level, places, only_plain_names(fix, *map(str, better)) if fix else None)
