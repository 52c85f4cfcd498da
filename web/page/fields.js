// Fields of parameters, inputs and the state.
import { element } from "./element.js";

/** Number as it is shown. */
const shown = (value, digits = 8) => Number(value.toPrecision(digits));

/** Range of a slider: up to three times the declared value. */
function rangeOf({ declared }) {
  const most = declared > 0 ? 3 * declared : Math.max(10, 3 * Math.abs(declared));
  const least = declared > 0 ? 0 : -most;
  return { least, most };
}

function number({ name, unit }, value = 0) {
  const input = element("input", { type: "number", step: "any", value });
  input.setAttribute("aria-label", `${name}, ${unit || "no unit"}`);
  return input;
}

function row({ name, docs, unit }, ...inputs) {
  const label = element("span", { className: "name", textContent: name, title: docs || name });
  return element("label", {}, label, ...inputs, element("span", { className: "unit", textContent: unit }));
}

export class Fields {
  #state = [];

  /**
   * `onValue()` sends the values of parameters and inputs, and resolves to the reason why they are impossible, if they are;
   * `onState(n, value)` changes a component of the state; `show` writes a note.
   */
  constructor(parameters, state, { onValue, onState, show }) {
    Object.assign(this, { parameters, state, onValue, onState, show });
  }

  /** Takes the quantities of another mechanism. */
  take({ parameters, inputs, components }) {
    this.parameters.replaceChildren(...[...parameters, ...inputs].map((own) => this.#slider(own)));
    this.parameters.parentElement.hidden = this.parameters.childElementCount === 0;
    this.#state = components.map((component, n) => {
      const input = number(component);
      input.onchange = () => {
        if (input.value !== "") this.onState(n, Number(input.value));
        input.blur();
      };
      return input;
    });
    this.state.replaceChildren(...components.map((component, n) => row(component, this.#state[n])));
  }

  /** Shows a state, but for a component that someone types. */
  draw(x) {
    this.#state.forEach((input, n) => {
      if (document.activeElement !== input) input.value = shown(x[n], 6);
    });
  }

  #slider(own) {
    const { least, most } = rangeOf(own);
    const input = number(own, own.value);
    const slider = element("input", { type: "range", min: least, max: most, step: "any", value: own.value });
    slider.setAttribute("aria-label", `${own.name}, slider`);
    let accepted = own.value;
    const change = async (typed) => {
      own.value = Math.min(Math.max(typed, least), most);
      const note = own.value === typed ? "" : `${own.name} goes from ${least} to ${most}: ${shown(own.value, 6)} is set`;
      const refused = await this.onValue();
      if (refused) {
        own.value = accepted;
        await this.onValue();
      }
      accepted = own.value;
      slider.value = input.value = shown(own.value);
      this.show(refused ?? note);
    };
    slider.oninput = () => change(Number(slider.value));
    input.onchange = () => (input.value === "" ? (input.value = shown(own.value)) : change(Number(input.value)));
    return row(own, slider, input);
  }
}
