"""Read the lines of one section of an interface file: its members, and the comments that belong to each."""

from __future__ import annotations

from collections.abc import Sequence

from .comments import InterfaceComment, comment_problems
from .interface_file import Member
from .member_parser import InterfaceLine, MemberReader


class SectionReader(MemberReader):
    """Reads all lines of a section when it is created; the results are in `members` and `problems`."""

    def __init__(self, lines: Sequence[InterfaceLine]) -> None:
        super().__init__()
        self.members: list[Member] = []
        self.waiting: list[InterfaceComment] = []
        self.of_last: list[InterfaceComment] = []
        count = next((i for i, line in enumerate(lines) if not line.text.startswith("#")), len(lines))
        self.check_comments([comment_in(line, 0) for line in lines[:count]], of_field=False)
        for line in lines[count:]:
            if line.text:
                self.read(line)
        self.check_last_comments()

    def check_comments(self, comments: list[InterfaceComment], *, of_field: bool) -> None:
        self.problems += comment_problems(comments, of_field=of_field)

    def check_last_comments(self) -> None:
        if self.members:
            self.check_comments(self.of_last, of_field=not self.members[-1].is_constant)

    def read(self, line: InterfaceLine) -> None:
        text, sign, rest = line.text.partition("#")
        if sign:
            comment = comment_in(line, len(text))
            if text and not text.strip():
                if self.members:
                    self.of_last.append(comment)
                return
            self.waiting.append(comment)
        behind = InterfaceComment(rest, line.at + len(text) + 1)
        text = text.rstrip()
        if not text:
            return
        member = self.member(InterfaceLine(text, line.at), behind)
        if member:
            self.check_last_comments()
            self.members.append(member)
            self.of_last, self.waiting = self.waiting, []


def comment_in(line: InterfaceLine, at: int) -> InterfaceComment:
    text = line.text[at:].lstrip("#")
    return InterfaceComment(text, line.at + len(line.text) - len(text))
