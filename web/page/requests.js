// Requests to the worker that more than one place makes.

export const declaration = (text, files, method) => ({ do: "declare", text, files, method });

const values = (quantities) => quantities.map(({ value }) => value);

/** Values of the parameters and inputs of a mechanism. */
export const valuesOf = ({ parameters, inputs }) => ({ do: "set", values: values(parameters), inputs: values(inputs) });
