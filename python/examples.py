"""Passes the examples of the installed package and of both READMEs: `python -I examples.py`, in any folder."""

import doctest
import sys
from pathlib import Path

import contact_vv

here = Path(__file__).resolve().parent
flags = doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE
own = doctest.testmod(contact_vv, optionflags=flags)
read = [
    doctest.testfile(str(folder / "README.md"), module_relative=False, optionflags=flags, encoding="utf-8")
    for folder in (here.parent, here)
]
counts = [one.attempted for one in (own, *read)]
print(f"{counts} examples of {contact_vv.__file__} and of the READMEs, by {contact_vv.program()}")
sys.exit(any(one.failed for one in (own, *read)) or 0 in counts)
