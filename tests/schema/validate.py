#!/usr/bin/env python3
"""Judges documents by JSON schemas, with the reference implementation for Python.

Reads {"schemas": {TYPE: SCHEMA}, "cases": [{"type": TYPE, "document": DOCUMENT}]} from the file
named on the command line and prints a list with one entry a case: null where the document is valid,
else what is wrong with it.
"""

import json
import sys

from jsonschema import Draft7Validator


def verdict(validator, document):
    error = next(validator.iter_errors(document), None)
    return error and f"{'.'.join(str(key) for key in error.absolute_path)}: {error.message}"


def main(path):
    with open(path, encoding="utf-8") as file:
        request = json.load(file)
    validators = {}
    for name, schema in request["schemas"].items():
        Draft7Validator.check_schema(schema)
        validators[name] = Draft7Validator(schema)
    verdicts = [verdict(validators[case["type"]], case["document"]) for case in request["cases"]]
    json.dump(verdicts, sys.stdout)


if __name__ == "__main__":
    main(sys.argv[1])
