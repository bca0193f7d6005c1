"""Checks every recipe of the gallery against the program's own JSON schema, with a validator that is not ours.

Usage: landform schema | python3 check_recipes.py FOLDER
"""

import datetime
import json
import pathlib
import sys
import tomllib

import jsonschema


def plain(value):
    """Dates of TOML as text; JSON has none."""
    if isinstance(value, (datetime.date, datetime.time)):
        return value.isoformat()
    if isinstance(value, dict):
        return {k: plain(v) for k, v in value.items()}
    if isinstance(value, list):
        return [plain(v) for v in value]
    return value


def main():
    schema = json.load(sys.stdin)
    jsonschema.Draft202012Validator.check_schema(schema)
    validator = jsonschema.Draft202012Validator(schema)
    files = sorted(pathlib.Path(sys.argv[1]).glob("*.toml"))
    wrong = 0
    for file in files:
        recipe = plain(tomllib.loads(file.read_text()))
        for error in validator.iter_errors(recipe):
            wrong += 1
            print(f"{file.name}: {'.'.join(map(str, error.absolute_path))}: {error.message}")
    print(f"{len(files)} recipes, {wrong} errors")
    sys.exit(1 if wrong or not files else 0)


main()
