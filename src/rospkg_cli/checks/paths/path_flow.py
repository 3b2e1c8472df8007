"""Whether all that code does with a path is to make it, or to write there: by names, joined paths and parameters."""

from __future__ import annotations

from ...lazy_regex import regex
from ...source import Span
from .path_calls import NEAR, PathCalls
from .path_ends import COMMAND, FILLED, JOINS, LOOKS, End, end_in
from .path_statements import KEYWORDS, PathPlace

MAX_PLACES, MAX_STEPS = 200, 20
BEHIND = regex(r"\s*(?:\.|->)\s*(\w+)\s*(\()?")
CALLED = regex(r"(\w+)\s*(?:<[\w\s:,*&<>]*>)?\s*$")
BEFORE_GROUPS = {True: KEYWORDS | {"in", "and", "or", "not", "with", "yield", "await"}, False: KEYWORDS}
"""What may stand before an expression in parentheses, in Python and in C++."""
LOOP = regex(r"\bfor\s+(\w+)\s+in\s*$")
COMPARES = regex(r"[=!]=|\bin\b|\bnot\b|<<")


class PathFlow(PathCalls):
    def is_written(self, *places: Span) -> bool:
        """Return whether code makes the path at some places, or writes there, and reads nothing there.

        The name of a parameter stands for its value.
        """
        found: set[str] = set()
        todo, seen = [PathPlace(each) for each in places], set[Span]()
        while todo:
            each = todo.pop()
            if each.span in seen:
                continue
            seen.add(each.span)
            if len(seen) > MAX_PLACES:
                return False
            end = self.end_of_place(each, todo)
            found.add("handed" if end == "unknown" and not each.is_joined else end)
        if found & {"read", "unknown"} or ("handed" in found and "made" not in found):
            return False
        return bool(found & {"made", "written"})

    def end_of_place(self, place: PathPlace, todo: list[PathPlace]) -> End:
        """Return what becomes of a path that stands at a place, and add where it goes on under another name."""
        for _ in range(MAX_STEPS):
            before = self.text[max(0, place.span.start - NEAR) : place.span.start]
            if COMMAND.search(FILLED.sub("", before).rstrip(" \t\n{\"'+,=")):
                return "written"
            step = self.called_on(place) or self.within(place, todo)
            if not isinstance(step, PathPlace):
                return step
            place = step
        return "unknown"

    def called_on(self, place: PathPlace) -> PathPlace | End | None:
        """Return what becomes of a path by its own method or attribute; None where it has none."""
        found = BEHIND.match(self.code, place.span.end)
        string = self.string_around(place.span.start)
        if found is None or (string is not None and string.end > place.span.end):
            return None
        name, opener = found[1], found.end() - 1
        end = self.end_of(opener) if found[2] else found.end()
        become = end_in(name, self.text[opener:end])
        return place.over(place.span.start, end, joins=name in JOINS) if become == "path" else become

    def within(self, place: PathPlace, todo: list[PathPlace]) -> PathPlace | End:
        """Return what becomes of a path by the string, the brackets or the statement around it."""
        start, end = place.span.start, place.span.end
        string = self.string_around(start)
        if string is not None and start > string.start:
            whole = self.code[string.start : start].lstrip("rRfFbBuUL") in ("'", '"') and end >= string.end - 1
            return place.over(string.start, string.end, joins=not whole)
        opener = self.opener(start)
        if self.is_block(opener):
            return self.in_statement(place, todo)
        sign, loop = self.code[opener], LOOP.search(self.code, max(0, opener - 80), opener)
        called = CALLED.search(self.code, max(0, opener - 120), opener)
        if loop is not None and self.is_python:
            self.bind(todo, place, loop[1], self.scope(opener, is_declared=True))
            return "shown"
        if sign == "[":
            return "shown" if called is None and not self.is_python else "unknown"
        argument = self.argument(opener, start)
        before, after = self.code[argument.span.start : start], self.code[end : argument.span.end]
        is_joined = bool(set("+/%") & set(before + after))
        if called is None or called[1] in BEFORE_GROUPS[self.is_python] - {"if"}:
            is_group = sign == "(" and argument.span == Span(opener + 1, self.end_of(opener) - 1)
            return place.over(opener, self.end_of(opener), joins=is_joined) if is_group else "unknown"
        if COMPARES.search(before) or COMPARES.search(after):
            return "shown" if LOOKS.fullmatch(called[1]) or "=" in before + after else "unknown"
        return self.in_call(PathPlace(place.span, place.is_joined or is_joined), called, opener, todo)
