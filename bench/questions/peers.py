"""Answers of other software to the ten questions.

Argument: a folder, into which `results.json` is written: for each question a list of names, figures and texts. Peers that
are not installed are left out.
"""

import importlib
import json
import sys
from pathlib import Path

QUESTIONS = [
    "creep", "linkage", "rebounds", "gradient", "energy", "exponents", "bits", "sampling", "generation", "printed",
]  # fmt: skip


def main():
    results = {}
    for question in QUESTIONS:
        try:
            answers = importlib.import_module(question).answers()
        except ImportError as error:
            print(f"{question} is left out: {error}", file=sys.stderr)
            continue
        results[question] = [
            {"name": name, "figure": float(figure), "text": text} for name, figure, text in answers
        ]
    (Path(sys.argv[1]) / "results.json").write_text(json.dumps(results, indent=2))


main()
