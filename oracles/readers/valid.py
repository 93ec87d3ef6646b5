"""Whether documents, one JSON document a line, are those of a schema; the first that is not ends it with its mistake."""
import json
import sys

import given

try:
    import fastjsonschema
except ModuleNotFoundError as absent:
    given.missing(absent.name)

validate = fastjsonschema.compile(json.load(open(given.file(__doc__), encoding="utf-8")))
number = 0
for number, line in enumerate(sys.stdin, start=1):
    validate(json.loads(line))
print(number)
