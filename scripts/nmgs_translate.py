# SPDX-License-Identifier: LGPL-2.1-or-later
"""Finds the texts of the window and brings the .ts files up to them, for scripts/translate.

Contexts are those by which FreeCAD asks: "NMGS" for tr("..."), a command's name for its menu text
and tooltip, the class of a .ui file, "App::Property" for what a property is about.
"""

import ast
import pathlib
import sys
import xml.etree.ElementTree as tree
from xml.sax.saxutils import escape

ROOT = pathlib.Path(__file__).resolve().parent.parent
PACKAGE = ROOT / "freecad" / "NMGSWorkbench"
FOLDER = PACKAGE / "resources" / "translations"
LANGUAGES = ("de", "tr")


def python_texts(path):
    """(context, text) of a Python file; commands come by their class, as (":Class", text)."""
    module = ast.parse(path.read_text(encoding="utf-8"))
    for node in ast.walk(module):
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
            if node.func.id == "tr" and node.args and _text(node.args[0]):
                yield "NMGS", _text(node.args[0])
            # What long work is called, on the dialog.
            if node.func.id == "run" and len(node.args) == 2 and _text(node.args[1]):
                yield "NMGS", _text(node.args[1])
            if node.func.id == "Example":
                for argument in node.args[1:]:
                    yield "NMGS", _text(argument)
        if isinstance(node, ast.Tuple) and len(node.elts) >= 4:
            if (_text(node.elts[0]) or "").startswith("App::Property"):
                yield "App::Property", _text(node.elts[3])
        if isinstance(node, ast.ClassDef) and path.parent.name == "objects":
            for line in node.body:
                if isinstance(line, ast.Assign) and line.targets[0].id == "text":
                    yield "NMGS", _text(line.value)
        if isinstance(node, ast.ClassDef) and path.parent.name == "commands":
            for line in node.body:
                if isinstance(line, ast.Assign) and line.targets[0].id in ("menu_text", "tooltip"):
                    if _text(line.value):
                        yield f":{node.name}", _text(line.value)


def _text(node):
    return node.value if isinstance(node, ast.Constant) and isinstance(node.value, str) else None


def command_names():
    """Class -> name of the command, of commands/__init__.py."""
    module = ast.parse((PACKAGE / "commands" / "__init__.py").read_text(encoding="utf-8"))
    for node in module.body:
        if isinstance(node, ast.Assign) and node.targets[0].id == "COMMANDS":
            return {v.id: k.value for k, v in zip(node.value.keys, node.value.values)}
    raise SystemExit("commands/__init__.py has no COMMANDS")


def ui_texts(path):
    root = tree.parse(path).getroot()
    for string in root.iter("string"):
        if string.get("notr") != "true" and string.text and string.text.strip():
            yield root.findtext("class"), string.text


def texts():
    """{context: [text, ...]} in a fixed order."""
    names = command_names()
    found = {}
    for path in sorted(PACKAGE.rglob("*.py")):
        for context, text in python_texts(path):
            if context.startswith(":"):
                context = names[context[1:]]
            if text:
                found.setdefault(context, {})[text] = None
    for path in sorted((PACKAGE / "resources").glob("*.ui")):
        for context, text in ui_texts(path):
            found.setdefault(context, {})[text] = None
    return {context: list(found[context]) for context in sorted(found)}


def read(path):
    """{(context, text): translation} of a .ts file; those that are unfinished are left out."""
    if not path.is_file():
        return {}
    known = {}
    for context in tree.parse(path).getroot().iter("context"):
        for message in context.iter("message"):
            translation = message.find("translation")
            if translation is not None and translation.text:
                known[context.findtext("name"), message.findtext("source")] = translation.text
    return known


def render(language, wanted, known):
    lines = [
        '<?xml version="1.0" encoding="utf-8"?>',
        "<!-- SPDX-License-Identifier: LGPL-2.1-or-later -->",
        "<!DOCTYPE TS>",
        f'<TS version="2.1" language="{language}" sourcelanguage="en">',
    ]
    # A text has one translation wherever it stands, unless a context says otherwise.
    anywhere = {}
    for (_, text), translation in known.items():
        anywhere.setdefault(text, translation)
    missing = []
    for context, of_context in wanted.items():
        lines += ["<context>", f"    <name>{escape(context)}</name>"]
        for text in of_context:
            translation = known.get((context, text)) or anywhere.get(text)
            mark = "" if translation else ' type="unfinished"'
            if not translation:
                missing.append((context, text))
            lines += [
                "    <message>",
                f"        <source>{escape(text)}</source>",
                f"        <translation{mark}>{escape(translation or '')}</translation>",
                "    </message>",
            ]
        lines.append("</context>")
    return "\n".join([*lines, "</TS>", ""]), missing


def main():
    check = "--check" in sys.argv
    wanted = texts()
    code = 0
    FOLDER.mkdir(exist_ok=True)
    for language in LANGUAGES:
        path = FOLDER / f"NMGS_{language}.ts"
        content, missing = render(language, wanted, read(path))
        for context, text in missing:
            print(f"{path.name}: no translation of {context}: {text!r}")
        if check:
            same = path.is_file() and path.read_text(encoding="utf-8") == content
            if not same:
                print(f"{path.name} is not up to the source: run scripts/translate")
            code = code or int(bool(missing) or not same)
        else:
            path.write_text(content, encoding="utf-8")
    count = sum(len(of_context) for of_context in wanted.values())
    print(f"{count} texts in {len(wanted)} contexts")
    return code


if __name__ == "__main__":
    sys.exit(main())
