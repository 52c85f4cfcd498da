// Typesetting of formulas: a part of the page that it needs after the mechanism moves.
import typeset from "katex/contrib/auto-render";
import katexStyle from "styles";
import { element } from "./element.js";

document.head.append(element("style", { textContent: katexStyle }));
window.typeset = typeset;
