#!/usr/bin/env python3
"""Judges documents by JSON schemas, with an implementation in Python.

Reads {"schemas": {TYPE: SCHEMA}, "cases": [{"type": TYPE, "document": DOCUMENT}]} from the file
named on the command line and prints a list with one entry a case: null where the document is valid,
else what is wrong with it.
"""

import json
import sys

import fastjsonschema


def verdict(validate, document):
    try:
        validate(document)
    except fastjsonschema.JsonSchemaException as error:
        return str(error)
    return None


def main(path):
    with open(path, encoding="utf-8") as file:
        request = json.load(file)
    validators = {name: fastjsonschema.compile(schema) for name, schema in request["schemas"].items()}
    verdicts = [verdict(validators[case["type"]], case["document"]) for case in request["cases"]]
    json.dump(verdicts, sys.stdout)


if __name__ == "__main__":
    main(sys.argv[1])
