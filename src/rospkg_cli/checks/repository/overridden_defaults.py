"""Defaults of environment variables, options and parameters that pages and scripts always override."""

from __future__ import annotations

import posixpath
import re

from ...files import PackageFiles
from ...lazy_regex import regex
from ...package.file_role import role_of
from .pages_and_scripts import pages_and_scripts

NEAR = 300
QUOTE = r"(?:\b[rRfFuUbBL]{1,2})?[\"']"
VARIABLE = regex(
    r"\b(?:environ\s*\.\s*get|getenv|EnvironmentVariable|EnvVar)\s*\(\s*(?:name\s*=\s*)?[\"'](\w+)[\"']"
    rf"(?:\s*,\s*(?:default(?:_value)?\s*=\s*)?|\s*\)[^;\n]*){QUOTE}$"
)
OPTION = regex(rf"\badd_argument\(\s*(?:[\"']-\w[\"']\s*,\s*)?[\"'](--[\w-]+)[\"'][^()]*\bdefault\s*=\s*{QUOTE}$")
PARAMETER = regex(rf"\bdeclare_parameter\s*(?:<[^;()]*>)?\(\s*[\"']([\w.]+)[\"']\s*,\s*{QUOTE}$")
SETS = (
    r"(?m)(?<![\w.-]){0}=\S|^[ \t-]*{0}:[ \t]+\S|\b(?:ENV|set[ \t]+-gx)[ \t]+{0}[ \t]"
    r"|\bSetEnvironmentVariable\s*\(\s*(?:name\s*=\s*)?[\"']{0}[\"']|<(?:set_)?env\b[^<>]*\bname\s*=\s*[\"']{0}[\"']"
)
RUNS = r"(?:\bpython3?[ \t]|\bros2[ \t]+run[ \t]|\./)[^\n]*(?<![\w-]){0}(?:\.py)?(?![\w.-])[^\n]*"


def is_given_otherwise(path: str, text: str, at: int, files: PackageFiles) -> bool:
    """Return whether a place in the text of a file is the default of one that is set to another value elsewhere."""
    before = text[max(0, at - NEAR) : at]
    variable = VARIABLE.search(before)
    if variable is not None:
        sets = re.compile(SETS.replace("{0}", variable[1]))
        return any(sets.search(each) for each in (*pages_and_scripts(files), *launch_texts(files)))
    option, parameter = OPTION.search(before), PARAMETER.search(before)
    if option is None and (parameter is None or launch_texts(files)):
        return False
    runs = re.compile(RUNS.replace("{0}", re.escape(posixpath.basename(path).removesuffix(".py"))))
    lines = [each[0] for page in pages_and_scripts(files) for each in runs.finditer(page.replace("\\\n", " "))]
    ends = rf"{option[1]}(?![\w-])" if option is not None else ""
    ends = rf"[ \t]-p[ \t]*{re.escape(parameter[1])}:=" if option is None and parameter is not None else ends
    return bool(lines) and all(re.search(ends, line) for line in lines)


def launch_texts(files: PackageFiles) -> list[str]:
    return [files.readable_text(each) for each in files.paths if role_of(each) == "launch"]
