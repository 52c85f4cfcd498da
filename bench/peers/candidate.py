"""Description of a peer's code for the Rust side: a file that exports `symbol`, and its operation counts."""

import json
from dataclasses import asdict, dataclass
from importlib import metadata

# Function over a row of states. Both sides evaluate one state after another, and store each result in memory. In
# sequence each state depends on the previous result, as in `peers/ours/src/loops.rs`.
LOOP = """
#ifdef __cplusplus
extern "C"
#endif
__attribute__((visibility("default"))) void {symbol}(const double *states, double *out, long count) {{
{setup}  for (long n = 0; n < count; ++n, states += {length}) {{
#ifdef IN_SEQUENCE
    const volatile double *last = out;
    const double x[] = {{{dependent}}};
#else
    const double *x = states;
#endif
{body}
    __asm__ volatile("" : : "r"(out) : "memory");
  }}
}}
"""


@dataclass
class Operations:
    """Counts like the crate's `Operations`; a single sine or cosine counts as a pair."""

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
    """Output folder and list of files."""

    def __init__(self, path):
        self.path, self.candidates, self.notes = path, [], []
        self.versions, self.include = [], []
        path.mkdir(parents=True, exist_ok=True)

    def add(self, model, function, peer, form, source, operations):
        """Adds a candidate with its own file, whose function is `run`."""
        file = "_".join([model, function, peer, form]).lower()
        file = "".join(letter if letter.isalnum() else "_" for letter in file) + ".c"
        self.write(file, source)
        self.candidates.append(Candidate(model, function, peer, form, file, "run", operations))

    def write(self, file, source):
        (self.path / file).write_text(source)

    def note(self, text):
        """Adds a line for the user on a left-out item and the reason."""
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


def loop(length, values, body, setup="", symbol="run"):
    """Each number of a state depends on one of the first `values` numbers of the previous result."""
    dependent = ", ".join(f"states[{i}] + 1e-200 * last[{i % values}]" for i in range(length))
    return LOOP.format(length=length, dependent=dependent, body=body, setup=setup, symbol=symbol)
