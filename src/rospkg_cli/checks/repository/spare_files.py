"""Files whose first lines say that they are no longer used: `# kept as a backup, see driver.py`."""

from __future__ import annotations

from ...files import PackageFiles
from ...lazy_regex import regex
from ...package.file_role import is_set_aside

THIS = r"(?:this|the) (?:\w+ )?(?:script|node|file|module|program|code|version|class)"
START = r"[ \t#\"'*/[(-]{0,20}"
"""Signs before the first word of a line."""
SAYS = regex(
    rf"(?im)(?:\b{THIS} is |\bit is |^{START}(?:is )?)"
    r"(?:no longer|not any ?more|not currently|currently not|not) (?:in use|used|needed|started|maintained)\b(?! to\b)"
    rf"|\b{THIS} (?:is|has been|was) (?:now )?"
    r"(?:deprecated|obsolete|unused|outdated|replaced|superseded|merged|abandoned)\b"
    rf"|^{START}(?:deprecated|obsolete|unused|outdated|legacy|backup)[ \t]*(?:$|[]:.,;!)-])"
    r"|\b(?:superseded|replaced) by [\w/`'\"]+\.(?:py|cpp|sh)\b|\bmerged into [\w/`'\"]+\.(?:py|cpp|sh)\b"
    r"|\b(?:kept|left|only|just) (?:here )?(?:as|for) (?:an? )?(?:spare|back-?up|reference|history|archive)\b"
    r"|\b(?:old|backup|spare) (?:version|copy) of\b"
    r"|仅作备用|仅供备份|备份文件|作为备份|已?废弃|已?弃用|不再使用|未使用"
    r"|사용하지 않|미사용|백업용|使用していない|未使用"
)
"""How people say so at the top of a file."""
HEAD = regex(
    r"(?:#![^\n]*\n|[ \t]*(?:#|//)[^\n]*\n|[ \t]*\n|[rRuU]?\"\"\"(?:[^\"]|\"(?!\"\")){0,2000}\"\"\"[ \t]*\n?"
    r"|'''(?:[^']|'(?!'')){0,2000}'''[ \t]*\n?|/\*(?:[^*]|\*(?!/)){0,2000}\*/[ \t]*\n?)*"
)
"""What comes before the first statement: comments, and a docstring."""


def is_spare(files: PackageFiles, path: str) -> bool:
    """Return whether the path of a file, or its text before the first statement, says that it is no longer used."""
    if is_set_aside(path):
        return True
    head = HEAD.match(files.readable_text(path))
    return head is not None and SAYS.search(head[0]) is not None
