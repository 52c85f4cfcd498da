"""Additions and multiplications of the series of heyoka's Taylor methods, from their decompositions."""

import re

VARIABLE = re.compile(r"u_\d+")


def series(decomposition, components, order):
    """Operations of the coefficients of the intermediate results up to `order`.

    The first entries are the components of the state, and the last ones name its derivatives. The recurrences are those
    of `heyoka`: products and quotients are sums over the lower orders, squares are sums over half of them.
    """
    texts = [str(expression) for expression, _ in decomposition[components:-components]]
    # the coefficients of the state are those of its derivatives times 1/k
    return components * order + sum(coefficient(text, n) for text in texts for n in range(order))


def coefficient(text, n):
    """Operations of the coefficient of order `n` of an intermediate result."""
    operands = len(VARIABLE.findall(text))
    if re.fullmatch(r"-u_\d+", text):
        return 1
    if re.fullmatch(r"\(u_\d+\*\*2( \+ u_\d+\*\*2)*\)", text):
        return operands * square(n) + operands - 1
    if re.fullmatch(r"u_\d+\*\*2(\.0*)?", text):
        return square(n)
    if re.fullmatch(r"u_\d+\*\*-?[\d.]+", text) or re.fullmatch(r"(combined_)?(sin|cos)\(u_\d+\)", text):
        # terms have a factor besides the two coefficients
        return 0 if n == 0 else 3 * n
    if re.fullmatch(r"div\(.*, u_\d+\)", text):
        return 2 * n
    if re.fullmatch(r"\(\S+ \* \S+\)", text):
        return 2 * n + 1 if operands == 2 else 1
    if re.fullmatch(r"sub\(\S+, \S+\)|\(\S+( [+-] \S+)+\)", text):
        terms = len(re.split(r", | [+-] ", text))
        if n > 0 and operands < terms:
            # constants have no further coefficients, but a difference from one changes the sign
            return 1 if re.match(r"sub\((?!u_)", text) else operands - 1
        return terms - 1
    raise ValueError(f"an operation without a count: {text}")


def square(n):
    """Operations of the coefficient of order `n` of a square, whose mixed products count twice."""
    return 1 if n == 0 else n + 1 + (n + 1) % 2
