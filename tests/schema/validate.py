#!/usr/bin/env python3
"""Judges documents by JSON schemas, with an implementation in Python.

Reads {"schemas": {TYPE: SCHEMA}, "cases": [{"type": TYPE, "document": DOCUMENT}]} from the file
named on the command line and prints a list with one entry a case: null where the document is valid,
else what is wrong with it.
"""

import json
import sys
import types

import fastjsonschema


def verdict(validate, document):
    try:
        validate(document)
    except fastjsonschema.JsonSchemaException as error:
        return str(error)
    return None


def forget_lines(validate):
    """Of functions of thousands of lines, Python takes long to find that of each exception."""
    for value in list(validate.__globals__.values()):
        if isinstance(value, types.FunctionType):
            value.__code__ = value.__code__.replace(co_linetable=b"")


def main(path):
    with open(path, encoding="utf-8") as file:
        request = json.load(file)
    names = {case["type"] for case in request["cases"]}
    validators = {name: fastjsonschema.compile(request["schemas"][name]) for name in names}
    for validate in validators.values():
        forget_lines(validate)
    verdicts = [verdict(validators[case["type"]], case["document"]) for case in request["cases"]]
    json.dump(verdicts, sys.stdout)


if __name__ == "__main__":
    main(sys.argv[1])
