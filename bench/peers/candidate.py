"""What the Rust side gets to know of a peer's code: a file that exports `symbol`, and its counted operations."""

import json
from dataclasses import asdict, dataclass
from importlib import metadata

# One function for a row of states. Both sides evaluate one state after the other, and hand each result over to memory.
LOOP = """
#ifdef __cplusplus
extern "C"
#endif
__attribute__((visibility("default"))) void {symbol}(const double *x, double *out, long count) {{
{setup}  for (long n = 0; n < count; ++n, x += {states}) {{
{body}
    __asm__ volatile("" : : "r"(out) : "memory");
  }}
}}
"""


@dataclass
class Operations:
    """As in the crate's `Operations`; a sine or a cosine alone counts as a pair."""

    additions: int = 0
    multiplications: int = 0
    divisions: int = 0
    sincos: int = 0
    functions: int = 0


@dataclass
class Candidate:
    """`function` is `rhs`, which gives qdd, `jacobian`: qdd, then its derivatives by q and qd, column by column, or
    `point`: a position, then its derivatives by q."""

    model: str
    function: str
    peer: str
    form: str
    file: str
    symbol: str
    operations: Operations | None


class Folder:
    """Where the files go, and the list of them."""

    def __init__(self, path):
        self.path, self.candidates, self.notes = path, [], []
        self.versions, self.include = [], []
        path.mkdir(parents=True, exist_ok=True)

    def add(self, model, function, peer, form, source, operations):
        """A candidate with a file of its own, whose function is `run`."""
        file = "_".join([model, function, peer, form]).lower()
        file = "".join(letter if letter.isalnum() else "_" for letter in file) + ".c"
        self.write(file, source)
        self.candidates.append(Candidate(model, function, peer, form, file, "run", operations))

    def write(self, file, source):
        (self.path / file).write_text(source)

    def note(self, text):
        """A line for the user: what was left out, and why."""
        self.notes.append(text)

    def version(self, package):
        self.versions.append(f"{package} {metadata.version(package)}")

    def close(self):
        listed = {
            "candidates": [asdict(candidate) for candidate in self.candidates],
            "notes": self.notes,
            "versions": self.versions,
            "include": self.include,
        }
        (self.path / "candidates.json").write_text(json.dumps(listed, indent=1))


def loop(states, body, setup="", symbol="run"):
    return LOOP.format(states=states, body=body, setup=setup, symbol=symbol)
