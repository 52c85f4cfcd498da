// The editor of the declaration: highlighting, and errors at their place with what to do.
import { defaultKeymap, history, historyKeymap } from "@codemirror/commands";
import { bracketMatching, HighlightStyle, StreamLanguage, syntaxHighlighting } from "@codemirror/language";
import { lintGutter, lintKeymap, setDiagnostics } from "@codemirror/lint";
import { EditorState } from "@codemirror/state";
import { drawSelection, EditorView, highlightActiveLine, keymap, lineNumbers } from "@codemirror/view";
import { tags } from "@lezer/highlight";

/** Words that begin an item or an entry, and other words of the language. */
const WORDS = new Set(
  ("pub params inputs gravity let input state shape body on ground joint point spring damper force torque between and " +
    "to at close wall output event generate robot units mass com inertia solids coordinate orientation position friction " +
    "motion stop dry_friction static_friction restitution potential dissipation absolute depends near rpy sphere rod disk " +
    "plate cuboid cylinder revolute prismatic helical screw ball free fixed urdf limits repair without none").split(" "),
);

/** Tokens of a declaration, which are those of Rust. */
const language = StreamLanguage.define({
  name: "mechanism",
  startState: () => ({ comments: 0 }),
  token(stream, state) {
    if (state.comments > 0 || stream.match("/*")) {
      if (state.comments === 0) state.comments = 1;
      while (!stream.eol() && state.comments > 0) {
        if (stream.match("*/")) state.comments--;
        else if (stream.match("/*")) state.comments++;
        else stream.next();
      }
      return "comment";
    }
    if (stream.eatSpace()) return null;
    if (stream.match("//")) {
      stream.skipToEnd();
      return "comment";
    }
    if (stream.match(/^"(?:[^"\\]|\\.)*"?/)) return "string";
    if (stream.match(/^\d[\d_]*(\.\d+)?([eE][+-]?\d+)?/)) return "number";
    const word = stream.match(/^[A-Za-z_][A-Za-z0-9_]*/);
    if (word) {
      if (WORDS.has(word[0])) return "keyword";
      return /^[A-Z][a-z]/.test(word[0]) ? "typeName" : "variableName";
    }
    stream.next();
    return null;
  },
  languageData: { commentTokens: { line: "//" } },
});

const colours = HighlightStyle.define([
  { tag: tags.comment, color: "var(--comment)" },
  { tag: tags.keyword, color: "var(--keyword)" },
  { tag: tags.number, color: "var(--number)" },
  { tag: tags.string, color: "var(--string)" },
  { tag: tags.typeName, color: "var(--type)", fontWeight: "bold" },
]);

/** A name that the help of an error proposes instead of the one at fault. */
export function proposal(help) {
  return /did you mean `([^`]+)`/.exec(help)?.[1];
}

export class Editor {
  constructor(parent, { onChange }) {
    this.view = new EditorView({
      parent,
      state: EditorState.create({
        extensions: [
          lineNumbers(),
          history(),
          drawSelection(),
          highlightActiveLine(),
          bracketMatching(),
          language,
          syntaxHighlighting(colours),
          lintGutter(),
          EditorView.lineWrapping,
          EditorView.contentAttributes.of({ "aria-label": "Declaration of a mechanism" }),
          keymap.of([...defaultKeymap, ...historyKeymap, ...lintKeymap]),
          EditorView.updateListener.of((update) => update.docChanged && onChange()),
        ],
      }),
    });
  }

  get text() {
    return this.view.state.doc.toString();
  }

  set text(text) {
    this.view.dispatch({ changes: { from: 0, to: this.view.state.doc.length, insert: text } });
  }

  /** Place of an error in the text; its columns count characters, not units of UTF-16. */
  span({ line, column, width }) {
    const { doc } = this.view.state;
    const own = doc.line(Math.min(Math.max(line, 1), doc.lines));
    const characters = [...own.text];
    const units = (count) => characters.slice(0, count).join("").length;
    const from = Math.min(own.from + units(column - 1), own.to);
    return [from, Math.min(Math.max(own.from + units(column - 1 + width), from), own.to)];
  }

  /** Marks errors, with the help of each as a fix where it names one. */
  mark(problems) {
    const diagnostics = problems.map((problem) => {
      const [from, to] = this.span(problem);
      const name = proposal(problem.help);
      const actions = name ? [{ name: `Write ${name}`, apply: () => this.fix(problem, name) }] : [];
      const message = `${problem.message} [${problem.code}]\n${problem.help}`;
      return { from, to, severity: "error", message, actions };
    });
    diagnostics.sort((a, b) => a.from - b.from);
    this.view.dispatch(setDiagnostics(this.view.state, diagnostics));
  }

  fix(problem, name) {
    const [from, to] = this.span(problem);
    this.view.dispatch({ changes: { from, to, insert: name } });
    this.view.focus();
  }

  /** Puts the cursor at an error. */
  go(problem) {
    const [from, to] = this.span(problem);
    this.view.dispatch({ selection: { anchor: from, head: to }, scrollIntoView: true });
    this.view.focus();
  }
}
