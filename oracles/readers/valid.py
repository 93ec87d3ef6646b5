"""Whether documents, one JSON document a line, are those of a schema; the first that is not ends it with its mistake."""
import json
import sys

import fastjsonschema

validate = fastjsonschema.compile(json.load(open(sys.argv[1], encoding="utf-8")))
for number, line in enumerate(sys.stdin):
    validate(json.loads(line))
print(number + 1)
