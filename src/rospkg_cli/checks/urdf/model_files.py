"""Files of Gazebo's models that robots and worlds name, where the model is here and lacks them: `model://name/…`."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator

from ...files import PackageFiles
from ...lazy_regex import regex
from ...package.urdf.references import text_spans
from ...package.urdf.robot_file import RobotFile
from ...package.workspace import Workspace
from ...source import Span
from ..paths.closest_path import closest_path
from .missing_resource import MissingResource

MODEL = regex(r"\s*model://(?P<model>[\w-]+)/+(?P<path>[^\s$<>{}\"']*[^\s$<>{}\"'/])\s*")
CONFIGS = ("model.config", "model.sdf")


def missing_of_models(robot: RobotFile, files: PackageFiles, workspace: Workspace) -> Iterator[MissingResource]:
    """Yield the files that no folder of a model has, here or installed by another package of the workspace."""
    for model, path, span in named_files(robot):
        homes = [each for each in homes_of(model, files) if not files.absent.is_expected(posixpath.join(each, path))]
        if not homes or is_installed(f"/{model}/{path}", workspace) or any(has(files, each, path) for each in homes):
            continue
        yield MissingResource(
            span,
            model,
            path,
            "absent",
            is_include=False,
            suggestion=intended_file(robot, homes, path, files),
            is_model=True,
        )


def named_files(robot: RobotFile) -> Iterator[tuple[str, str, Span]]:
    """Yield the model and the path of each file, with the place of the path."""
    for element in robot.document.root.walk():
        spans = list(text_spans(element)) if element.tag == "uri" and element.chunks and not element.children else []
        filename = element.attributes.get("filename")
        for span in (*spans, *([filename.value_span] if filename is not None else ())):
            if match := MODEL.fullmatch(robot.source.slice(span)):
                start, end = match.span("path")
                path = posixpath.normpath(match["path"])
                yield match["model"], path, Span(span.start + start, span.start + end)


def homes_of(model: str, files: PackageFiles) -> list[str]:
    """Return the folders of a name that hold a model."""
    found = {posixpath.dirname(path) for path in files.paths if path.endswith(CONFIGS)}
    return sorted(each for each in found if posixpath.basename(each) == model)


def has(files: PackageFiles, home: str, path: str) -> bool:
    whole = posixpath.join(home, path)
    return files.exists(whole) or whole in files.folders


def is_installed(ending: str, workspace: Workspace) -> bool:
    return any(f"/{path}".endswith(ending) for facts in workspace.packages for path in facts.share_files)


def intended_file(robot: RobotFile, homes: list[str], path: str, files: PackageFiles) -> str | None:
    """Return the file in the model that the robot is part of, or a similar one in the model that it names."""
    own = posixpath.dirname(robot.path)
    if own and has(files, own, path):
        return f"model://{posixpath.basename(own)}/{path}"
    known = [each.removeprefix(f"{home}/") for home in homes for each in files.paths if each.startswith(f"{home}/")]
    return closest_path(path, known)
