// Tabs below: equations, counts, generated code and plots.
import { element } from "./element.js";
import { plot } from "./plot.js";

const TABS = {
  Equations: "equations",
  Operations: "operations",
  Energy: "energy",
  "Phase portrait": "phase",
  Section: "passages",
  Rust: "rust",
  C: "c",
};
/** Longest equations that are typeset, in characters: others take seconds, and nobody reads them. */
const LONGEST = 40000;
/** Time in ms from a change of the text until equations are derived: the mechanism moves first, and while someone types. */
const LATER = 700;
const DELIMITERS = [
  { left: "\\[", right: "\\]", display: true },
  { left: "$", right: "$", display: false },
];
const BLUE = "#2f6fa8";

export class Panel {
  constructor(tabs, panel, engine) {
    Object.assign(this, { tabs, panel, engine, tab: "Equations" });
    for (const name of Object.keys(TABS)) {
      const tab = element("button", { textContent: name, onclick: () => this.select(name) });
      tab.setAttribute("role", "tab");
      tab.setAttribute("aria-controls", panel.id);
      tab.dataset.name = name;
      tabs.append(tab);
    }
    tabs.onkeydown = (event) => {
      const by = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
      if (!by) return;
      const names = Object.keys(TABS);
      this.select(names[(names.indexOf(this.tab) + by + names.length) % names.length]);
      tabs.querySelector('[aria-selected="true"]').focus();
    };
  }

  /** The section that the motion is to be cut by, if it is shown. */
  get section() {
    return this.tab === "Section" && this.about ? this.pass : null;
  }

  take(about) {
    const names = (of) => JSON.stringify(of?.components);
    if (names(about) !== names(this.about)) {
      const rates = about.components.findIndex(({ name }) => name.startsWith("dot("));
      // of the section, the coordinate after the one that is cut
      const other = rates > 1 ? 1 : 0;
      this.axes = { "Phase portrait": [0, Math.max(rates, 0)], Section: [other, Math.max(rates, 0) + other] };
      this.pass = { component: 0, value: 0 };
    }
    this.about = about;
    // what is printed for another mechanism is not needed any more
    this.printer?.end();
    this.printer = null;
    this.select(this.tab, LATER);
  }

  /** Shows a tab; what the worker prints for it follows after a time in ms. */
  select(name, patience = 0) {
    Object.assign(this, { tab: name, patience });
    for (const tab of this.tabs.children) {
      const own = tab.dataset.name === name;
      tab.setAttribute("aria-selected", String(own));
      tab.tabIndex = own ? 0 : -1;
    }
    this.panel.setAttribute("aria-label", name);
    this.canvas = null;
    clearTimeout(this.later);
    if (this.about) this[TABS[name]]();
  }

  /** Asks for what is printed, and passes it to `show`, unless another mechanism or another tab is shown by then. */
  ask(request, show) {
    const { about, tab } = this;
    const key = JSON.stringify(request);
    this.later = setTimeout(async () => {
      about.answers ??= {};
      const answer = (about.answers[key] ??= await this.print(request));
      if (this.about !== about || this.tab !== tab) return;
      if (answer.is === "refused") {
        // asked again when the tab is selected
        delete about.answers[key];
        this.panel.replaceChildren(answer.why);
      } else show(answer);
    }, this.patience);
  }

  /** Asks a worker of its own, so that the next text need not wait. */
  async print(request) {
    const { about } = this;
    await this.engine.compiled;
    if (this.about !== about) return null;
    if (!this.printer) {
      this.printer = this.engine.another();
      this.printer.ask(about.request);
    }
    return (await this.printer.ask(request)).answer;
  }

  /** Shows the comment on the mechanism, and until its equations are typeset those of its former declaration. */
  equations() {
    const { name, docs } = this.about;
    if (this.typeset?.name !== name) this.typeset = null;
    const show = () => this.panel.replaceChildren(element("p", { textContent: docs }), ...(this.typeset?.parts ?? []));
    show();
    this.ask({ do: "describe" }, async ({ latex }) => {
      if (this.typeset?.latex === latex) return;
      const place = element("div", { textContent: latex });
      if (latex.length < LONGEST) {
        await (this.formulas ??= loader.run("formulas"));
        window.typeset(place, { delimiters: DELIMITERS, throwOnError: false, maxExpand: 1e5 });
      }
      const copy = element("button", { textContent: "Copy LaTeX", onclick: () => navigator.clipboard?.writeText(latex) });
      this.typeset = { name, latex, parts: [copy, place] };
      if (this.tab === "Equations" && this.about.name === name) show();
    });
  }

  operations() {
    if (!this.panel.querySelector("table")) this.panel.replaceChildren();
    this.ask({ do: "describe" }, ({ functions }) => {
      const head = ["Function", "Form", "+ −", "×", "÷", "sin, cos", "other"].map((text) => element("th", { textContent: text, scope: "col" }));
      const rows = functions.map(({ name, docs, form, operations }) =>
        element(
          "tr",
          { title: docs },
          element("th", { textContent: name, scope: "row" }),
          element("td", { textContent: form }),
          ...operations.map((count) => element("td", { textContent: count, className: "number" })),
        ),
      );
      this.panel.replaceChildren(element("table", {}, element("thead", {}, element("tr", {}, ...head)), element("tbody", {}, ...rows)));
    });
  }

  code(language) {
    if (!this.panel.querySelector("pre")) this.panel.replaceChildren();
    this.ask({ do: "code", language }, ({ text }) => {
      const copy = element("button", { textContent: "Copy", onclick: () => navigator.clipboard?.writeText(text) });
      this.panel.replaceChildren(copy, element("pre", { textContent: text, tabIndex: 0 }));
    });
  }

  rust() {
    return this.code("rust");
  }

  c() {
    return this.code("c");
  }

  /** A canvas for a plot, below its controls. */
  chart(label, ...controls) {
    this.canvas = element("canvas");
    this.canvas.setAttribute("role", "img");
    this.canvas.setAttribute("aria-label", label);
    this.panel.replaceChildren(element("div", { className: "row" }, ...controls), this.canvas);
  }

  /** A choice of a component of the state. */
  choice(label, now, change) {
    const options = this.about.components.map(({ name, unit }, n) => new Option(unit ? `${name} in ${unit}` : name, n, false, n === now));
    const select = element("select", {}, ...options);
    select.onchange = () => change(Number(select.value));
    return element("label", {}, label, select);
  }

  energy() {
    this.chart("Energy over time");
  }

  /** A choice of an axis of this tab. */
  axis(k, label) {
    const axes = this.axes[this.tab];
    return this.choice(label, axes[k], (n) => (axes[k] = n));
  }

  phase() {
    this.chart("Phase portrait", this.axis(0, "Across"), this.axis(1, "Up"));
  }

  passages() {
    const value = element("input", { type: "number", step: "any", value: this.pass.value });
    value.onchange = () => (this.pass = { ...this.pass, value: Number(value.value) || 0 });
    this.chart(
      "Poincaré section",
      this.choice("Where", this.pass.component, (component) => (this.pass = { ...this.pass, component })),
      element("label", {}, "rises through", value),
      this.axis(0, "Across"),
      this.axis(1, "Up"),
    );
  }

  draw(simulation) {
    if (!this.canvas?.isConnected || !this.about) return;
    const past = simulation.past;
    if (this.tab === "Energy") {
      const line = (name, colour, of) => ({ name, colour, points: past.map((frame) => [frame.t, of(frame)]) });
      const lines = [
        line("kinetic", "#c8553d", (frame) => frame.kinetic),
        line("potential", "#3c8d5a", (frame) => frame.potential),
        line("total", BLUE, (frame) => frame.kinetic + frame.potential),
      ];
      return plot(this.canvas, { lines, x: "t in s", y: "energy in J" });
    }
    const [a, b] = this.axes[this.tab];
    const { components } = this.about;
    const name = (n) => (components[n]?.unit ? `${components[n].name} in ${components[n].unit}` : components[n]?.name);
    const wrap = (n, value) => (components[n]?.periodic ? value - 2 * Math.PI * Math.round(value / (2 * Math.PI)) : value);
    const point = (x) => [wrap(a, x[a]), wrap(b, x[b])];
    if (this.tab === "Section") return plot(this.canvas, { dots: simulation.passages.map(point), x: name(a), y: name(b) });
    const points = past.map((frame) => point(frame.x));
    // no line across the screen where an angle passes a half turn
    const broken = points.flatMap((own, n) => {
      const jumps = n > 0 && [a, b].some((c, k) => components[c]?.periodic && Math.abs(own[k] - points[n - 1][k]) > Math.PI);
      return jumps ? [[NaN, NaN], own] : [own];
    });
    plot(this.canvas, { lines: [{ name: "", colour: BLUE, points: broken }], x: name(a), y: name(b) });
  }
}
