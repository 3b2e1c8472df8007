"""PLG006 unlisted-rqt-plugin."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.plugins.rqt import RqtPlugins
from ...edits.manifest import add_export
from ...edits.plain_names import only_plain_names
from ...example import SETUP_PY, Example, manifest
from ...finding import Fix, Hit, Related, Safety, Severity
from ...package.manifest import Manifest
from ...package.plugins.description import PluginDescription
from ...rule import rule

NEEDS = manifest("  <exec_depend>rqt_gui_py</exec_depend>\n")
LISTED = NEEDS.replace("  </export>", '    <rqt_gui plugin="${prefix}/plugin.xml"/>\n  </export>')
XML = """\
«<library path="my_pkg">»
  <class name="my_pkg/Panel" type="my_pkg.panel.Panel" base_class_type="rqt_gui_py::Plugin"/>
</library>
"""


@rule(
    "PLG006",
    "unlisted-rqt-plugin",
    over=RqtPlugins,
    severity=Severity.ERROR,
    levels={
        Severity.INFO: "it is in C++, so that rqt finds it, and package.xml has its siblings, its module is not "
        "installed, or its file is laid aside"
    },
    examples=(
        Example(
            bad={
                "package.xml": NEEDS,
                "plugin.xml": XML,
                "my_pkg/panel.py": "from rqt_gui_py.plugin import Plugin\n\n\nclass Panel(Plugin):\n    pass\n",
                "setup.py": SETUP_PY.replace("['package.xml']", "['package.xml', 'plugin.xml']"),
            },
            good={"package.xml": LISTED, "plugin.xml": XML.replace("«", "").replace("»", "")},
            fix=Safety.SAFE,
        ),
    ),
)
def unlisted_rqt_plugin(plugins: RqtPlugins) -> Iterator[Hit]:
    """
    ## What it does
    Finds rqt plugins that package.xml does not export with `<rqt_gui plugin="…"/>`.
    They are described with `base_class_type="rqt_gui_py::Plugin"`. Plugins in C++, which rqt finds by what CMake
    exports, are reported at info level where package.xml has the others.

    ## Why is this bad?
    rqt reads the package.xml of every installed package to find its plugins in Python: one that is not exported is
    missing from the menu, without a message.

    ## When it is quiet
    Plugins of tests, packages for ROS 1, and classes that another description of package.xml lists, are left alone. A
    description whose module is not installed, or that is laid aside (`plugin_old.xml`), is an info.
    """
    for description, tag in plugins.hidden():
        line = export_of(description, tag)
        message = f"package.xml does not list `{description.file}`: rqt does not offer it; add `{line}` to `<export>`"
        fix = listing(plugins, description, line)
        why = plugins.idle(description)
        level = Severity.INFO if why else None
        yield Hit(description.file, description.document.root.open, message + why, level, fix=fix)
    for description, others in plugins.odd():
        at = next(each for each in description.exported if each.is_indexed)
        files = ", ".join(f"`{each.file}`" for each in others)
        message = f"package.xml lists {files}, not `{description.file}`: rqt finds that only by what CMake exports"
        line = export_of(description)
        fix = listing(plugins, description, line)
        related = (listed_in(plugins.manifest, others[-1]),)
        yield Hit(at.path, at.span, f"{message}; add `{line}` to `<export>`", Severity.INFO, related, fix)


def listing(plugins: RqtPlugins, description: PluginDescription, line: str) -> Fix | None:
    fix = Fix(f"list `{description.file}` in package.xml", (add_export(plugins.manifest, line),))
    return only_plain_names(fix, description.file)


def export_of(description: PluginDescription, tag: str = "rqt_gui") -> str:
    return f'<{tag} plugin="${{prefix}}/{description.file}"/>'


def listed_in(manifest: Manifest, description: PluginDescription) -> Related:
    at = next(each for each in description.exported if not each.is_indexed)
    return Related(manifest.path, at.span, "its sibling")
