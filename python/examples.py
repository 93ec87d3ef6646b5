"""Passes the examples of the installed package and of the README: `python -I examples.py`, in any folder."""

import doctest
import sys
from pathlib import Path

import contact_vv

readme = Path(__file__).resolve().parents[1] / "README.md"
flags = doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE
own = doctest.testmod(contact_vv, optionflags=flags)
front = doctest.testfile(str(readme), module_relative=False, optionflags=flags, encoding="utf-8")
print(f"{own.attempted} examples of {contact_vv.__file__}, {front.attempted} of the README, by {contact_vv.program()}")
sys.exit(own.failed + front.failed > 0 or 0 in (own.attempted, front.attempted))
