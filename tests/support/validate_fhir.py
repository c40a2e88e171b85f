# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks resources of FHIR R4 against the JSON schema of HL7, and what the schema cannot say:
every reference points into its bundle, every local code stands in the code system.

validate_fhir.py SCHEMA CODESYSTEM BUNDLE…    prints what is wrong; exit status 1 if anything is."""

import json
import sys

import jsonschema

schema = json.load(open(sys.argv[1]))
definitions = schema["definitions"]
problems = []


def validator(name):
    return jsonschema.Draft6Validator({"$ref": "#/definitions/" + name, "definitions": definitions})


def check(name, resource, where):
    for error in validator(name).iter_errors(resource):
        problems.append(f"{where}: {'/'.join(map(str, error.absolute_path))}: {error.message[:200]}")


def each(value, found):
    if isinstance(value, dict):
        found(value)
        for child in value.values():
            each(child, found)
    elif isinstance(value, list):
        for child in value:
            each(child, found)


codes = json.load(open(sys.argv[2]))
check("CodeSystem", codes, sys.argv[2])
known = {concept["code"] for concept in codes["concept"]}

for path in sys.argv[3:]:
    bundle = json.load(open(path))
    # The schema asks of every entry to be one of 148 resources: slow, and no help with errors. The
    # bundle is checked without them, and then each as what it says it is.
    entries = bundle.get("entry", [])
    check("Bundle", dict(bundle, entry=[{**entry, "resource": {"resourceType": "Patient"}}
                                        for entry in entries]), path)
    names = {entry["fullUrl"] for entry in entries}
    if len(names) != len(entries):
        problems.append(f"{path}: two entries have the same name")
    for number, entry in enumerate(entries):
        resource = entry["resource"]
        where = f"{path}: entry {number}"
        if resource["resourceType"] not in definitions:
            problems.append(f"{where}: there is no {resource['resourceType']}")
            continue
        check(resource["resourceType"], resource, where)

        def found(value):
            if "reference" in value and value["reference"] not in names:
                problems.append(f"{where}: {value['reference']} is not in the bundle")
            if value.get("system") == codes["url"] and value["code"] not in known:
                problems.append(f"{where}: {value['code']} is not in the code system")

        each(resource, found)

print("\n".join(problems))
sys.exit(1 if problems else 0)
