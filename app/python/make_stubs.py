"""Writes the type stubs of the compiled module from the module itself: make_stubs.py FILE.pyi

What is typed and documented is said once, in C++. Signatures are those of the docstrings; a property's docstring begins
with its type and a colon.
"""
import inspect
import re
import sys

sys.path.pop(0)  # this folder has the package's sources, without the module
from tactum import _tactum  # noqa: E402

HEAD = '''"""{doc}"""
import os
from typing import Any, Dict, List, Optional, Union

import numpy
import numpy.typing
import tactum.results
'''


def plain(text):
    """A signature as it is written in Python."""
    text = re.sub(r"tactum\._tactum\.", "", text)
    text = re.sub(r"\bos\.PathLike\b", "Union[str, os.PathLike]", text)
    text = re.sub(r"Union\[Preset, str, Union\[str, os\.PathLike\]\]", "Union[Preset, str, os.PathLike]", text)
    text = re.sub(r": (object|handle)\b", ": Any", text)
    return re.sub(r"\*\*kwargs", "**kwargs: Any", text)


def body(doc, indent):
    lines = (doc or "").strip().splitlines() or [""]
    text = "\n".join((indent if n and line.strip() else "") + line for n, line in enumerate(lines))
    return f'{indent}"""{text}"""\n'


def function(name, what, indent, method):
    signature, _, doc = what.__doc__.strip().partition("\n")
    signature = plain(signature).replace("self: " + "object", "self")
    if method:
        signature = re.sub(r"\((self|arg0): \w+", "(self", signature, count=1)
    if name == "__eq__":
        signature = "__eq__(self, other: object) -> bool"
    return f"{indent}def {signature}:\n" + body(doc, indent + "    ") + f"{indent}    ...\n"


def property_(name, what):
    kind, colon, doc = what.__doc__.partition(": ")
    if not colon or not re.fullmatch(r"[\w.\[\], ]+", kind):
        sys.exit(f"{name}: its docstring does not begin with a type: {what.__doc__}")
    text = f"    @property\n    def {name}(self) -> {kind}:\n" + body(doc, " " * 8) + " " * 8 + "...\n"
    if what.fset is not None:
        taken = "numpy.typing.ArrayLike" if "NDArray" in kind else kind
        if kind.startswith("Optional[") and "NDArray" in kind:
            taken = "Optional[numpy.typing.ArrayLike]"
        text += f"    @{name}.setter\n    def {name}(self, value: {taken}) -> None: ...\n"
    return text


SPECIAL = {"__init__", "__getitem__", "__repr__", "__eq__", "__hash__"}


def class_(name, what):
    text = f"\nclass {name}:\n" + body(what.__doc__, "    ")
    for member, value in sorted(vars(what).items()):
        if isinstance(value, property):
            text += property_(member, value)
        elif callable(value) and (not member.startswith("_") or member in SPECIAL):
            if (value.__doc__ or "").startswith(member + "("):  # a signature: Python's own have none
                text += function(member, value, "    ", method=True)
    return text


def stubs():
    text = HEAD.format(doc=_tactum.__doc__)
    for name, what in sorted(vars(_tactum).items()):
        if name.startswith("_"):
            continue
        if inspect.isclass(what):
            text += class_(name, what)
        elif callable(what):
            text += "\n" + function(name, what, "", method=False)
        else:
            text += f"\n{name}: Dict[str, Parameter]\n"
    return text


if __name__ == "__main__":
    with open(sys.argv[1], "w", encoding="utf-8") as file:
        file.write(stubs())
