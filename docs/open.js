// A button above each declaration of the book, which opens it on the page `pendulum.html` beside the book.
(() => {
  /** Texts within `mechanism! { .. }`, without their indentation. */
  const declarations = (text) => {
    const found = [];
    for (let at = text.indexOf("mechanism! {"); at >= 0; at = text.indexOf("mechanism! {", at + 1)) {
      const begin = at + "mechanism! {".length;
      let [end, depth] = [begin, 1];
      for (; end < text.length && depth > 0; end++) depth += { "{": 1, "}": -1 }[text[end]] ?? 0;
      const lines = text.slice(begin, end - 1).split("\n").filter((line, n, all) => line.trim() || (n > 0 && n < all.length - 1));
      const margin = Math.min(...lines.filter((line) => line.trim()).map((line) => line.search(/\S/)));
      found.push(lines.map((line) => line.slice(margin)).join("\n") + "\n");
    }
    return found;
  };
  const root = typeof path_to_root === "string" ? path_to_root : "";
  for (const code of document.querySelectorAll("pre > code.language-rust")) {
    for (const text of declarations(code.textContent)) {
      const link = document.createElement("a");
      link.className = "open-declaration";
      link.href = `${root}pendulum.html#text=${encodeURIComponent(text)}`;
      const name = /pub(?:\([^)]*\))? +(\w+)/.exec(text)?.[1];
      link.textContent = name ? `Open ${name} in motion` : "Open in motion";
      code.parentElement.before(link);
    }
  }
})();
