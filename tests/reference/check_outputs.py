#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks JSON that internode wrote, from the JSON alone: against its schema, then against the mathematics.

Independent of the program: exact fractions in Q[x]/(minimal polynomial) with an isolating interval for the root; masks
by Oslo algorithm, stencils by Marsden's identity, words by rewriting, curves by de Boor.

  check_outputs.py --schema-dir docs/schema FILE...
  check_outputs.py --schema-dir docs/schema --refined INPUT.json VALIDATION.json STEPS OUTPUT.json
  check_outputs.py --schema-dir docs/schema --composed PYRAMID.json OUTPUT.json

Exit code 0 when everything holds, 1 with a line per fault otherwise.
"""

import argparse
import itertools
import json
import math
import pathlib
import sys
from fractions import Fraction

try:
    import jsonschema
except ImportError:  # the schemas are then not checked, and the last line says so
    jsonschema = None


class Fault(Exception):
    pass


def require(condition, message):
    if not condition:
        raise Fault(message)


# --- the field -------------------------------------------------------------------------------------------------------


class Field:
    """Q(root) by its minimal polynomial (low degree first, monic) and the double nearest to the root."""

    def __init__(self, polynomial, root):
        self.polynomial = [Fraction(c) for c in polynomial]
        self.degree = len(polynomial) - 1
        require(self.polynomial[-1] == 1, "the minimal polynomial is not monic")
        if self.degree == 1:
            self.lower = self.upper = -self.polynomial[0]
        else:
            centre = Fraction(root)
            width = abs(centre) * Fraction(1, 2**50)
            self.lower, self.upper = centre - width, centre + width
            self.low_sign = self._value(self.lower) > 0
            require(self.low_sign != (self._value(self.upper) > 0), "the root is not a root of the minimal polynomial")

    def _value(self, x):
        value = Fraction(0)
        for c in reversed(self.polynomial):
            value = value * x + c
        return value

    def refine(self):
        middle = (self.lower + self.upper) / 2
        if (self._value(middle) > 0) == self.low_sign:
            self.lower = middle
        else:
            self.upper = middle

    def number(self, coefficients):
        require(len(coefficients) == self.degree, "a number has other than degree-of-the-field coefficients")
        return Element(self, [Fraction(c) for c in coefficients])

    def constant(self, value):
        return Element(self, [Fraction(value)] + [Fraction(0)] * (self.degree - 1))

    def generator(self):
        if self.degree == 1:
            return self.constant(self.lower)
        return Element(self, [Fraction(0), Fraction(1)] + [Fraction(0)] * (self.degree - 2))


class Element:
    def __init__(self, field, coefficients):
        self.field = field
        self.c = coefficients

    def __add__(self, other):
        return Element(self.field, [a + b for a, b in zip(self.c, other.c)])

    def __sub__(self, other):
        return Element(self.field, [a - b for a, b in zip(self.c, other.c)])

    def __mul__(self, other):
        product = [Fraction(0)] * (2 * self.field.degree - 1)
        for i, a in enumerate(self.c):
            if a:
                for j, b in enumerate(other.c):
                    if b:
                        product[i + j] += a * b
        for power in range(len(product) - 1, self.field.degree - 1, -1):
            lead = product[power]
            if lead:
                for i in range(self.field.degree):
                    product[power - self.field.degree + i] -= lead * self.field.polynomial[i]
        return Element(self.field, product[: self.field.degree])

    def scaled(self, factor):
        return Element(self.field, [factor * a for a in self.c])

    def inverse(self):
        """Solves self * x = 1 by elimination on the matrix of multiplication."""
        n = self.field.degree
        rows, power = [], self
        for _ in range(n):
            rows.append(list(power.c))
            power = power * self.field.generator() if n > 1 else power
        system = [[rows[j][i] for j in range(n)] + [Fraction(int(i == 0))] for i in range(n)]
        for i in range(n):
            pivot = next(r for r in range(i, n) if system[r][i] != 0)
            system[i], system[pivot] = system[pivot], system[i]
            system[i] = [a / system[i][i] for a in system[i]]
            for r in range(n):
                if r != i and system[r][i] != 0:
                    factor = system[r][i]
                    system[r] = [a - factor * b for a, b in zip(system[r], system[i])]
        return Element(self.field, [system[i][n] for i in range(n)])

    def is_zero(self):
        return not any(self.c)

    def __eq__(self, other):
        return self.c == other.c

    def bounds(self):
        """Between two fractions: Horner in interval arithmetic over the root's interval (which is positive)."""
        low = high = Fraction(0)
        for c in reversed(self.c):
            products = [low * self.field.lower, low * self.field.upper, high * self.field.lower, high * self.field.upper]
            low, high = min(products) + c, max(products) + c
        return low, high

    def sign(self):
        if self.is_zero():
            return 0
        while True:
            low, high = self.bounds()
            if low > 0:
                return 1
            if high < 0:
                return -1
            self.field.refine()

    def to_float(self):
        if not any(self.c[1:]):
            return float(self.c[0])
        for _ in range(400):
            low, high = self.bounds()
            if float(low) == float(high):
                return float(low)
            self.field.refine()
        raise Fault("a number could not be separated from the middle of two doubles")


def total(field, terms):
    result = field.constant(0)
    for term in terms:
        result = result + term
    return result


def read_number(field, entry, what):
    """An exact number, whose value must be the nearest double."""
    number = field.number(entry["exact"])
    if entry["value"] is not None:
        require(number.to_float() == entry["value"], f"{what}: value {entry['value']!r} is not the nearest double")
    return number


# --- grammars --------------------------------------------------------------------------------------------------------


class System:
    """The exact part of a document: field, ratio, rules, lengths."""

    def __init__(self, document):
        self.field = Field(document["field"]["minimal_polynomial"], document["field"]["root"])
        self.ratio = read_number(self.field, document["ratio"], "ratio")
        generator = self.field.generator()
        power = generator
        for _ in range(document.get("steps", 1) - 1 if isinstance(document.get("steps", 1), int) else 0):
            power = power * generator
        require(self.ratio == power, "the ratio is not the generator of its field to the power of the steps")
        require(generator.to_float() == document["field"]["root"], "the root is not the nearest double")
        self.rules = document["grammar"]["rules"]
        self.axiom = document["grammar"]["axiom"]
        self.lengths = {"0": self.field.constant(0)}
        for symbol in document["symbols"]:
            if symbol["length"] is not None:
                self.lengths[symbol["name"]] = read_number(self.field, symbol["length"], f"length of {symbol['name']}")
        self.check_lengths()

    def image(self, symbol):
        return ["0"] if symbol == "0" else self.rules[symbol]

    def rewritten(self, word):
        return [child for symbol in word for child in self.image(symbol)]

    def check_lengths(self):
        """rho a = M a, a > 0, rho > 1."""
        require((self.ratio - self.field.constant(1)).sign() > 0, "the ratio is not above 1")
        for symbol, length in self.lengths.items():
            if symbol == "0":
                continue
            require(length.sign() > 0, f"the length of {symbol} is not positive")
            image = self.rules[symbol]
            require(all(child in self.lengths for child in image), f"{symbol} has a length, a child of it has none")
            require(
                self.ratio * length == total(self.field, [self.lengths[child] for child in image]),
                f"rho a = M a does not hold for {symbol}",
            )

    def knots(self, word):
        knots = [self.field.constant(0)]
        for symbol in word:
            knots.append(knots[-1] + self.lengths[symbol])
        return knots


def occurring(rules, axiom):
    if axiom is None:
        return set(rules)
    found, queue = set(), [s for s in axiom["word"] if s != "0"]
    while queue:
        symbol = queue.pop()
        if symbol not in found:
            found.add(symbol)
            queue.extend(rules[symbol])
    return found


def reachable_sets(rules, symbols):
    reached = {}
    for start in symbols:
        seen, queue = set(), list(rules[start])
        while queue:
            symbol = queue.pop()
            if symbol not in seen:
                seen.add(symbol)
                queue.extend(rules[symbol])
        reached[start] = seen
    return reached


# --- validation ------------------------------------------------------------------------------------------------------

MOST_SYMBOLS_FOR_CLASSES = 300


def check_classes(document):
    rules = document["grammar"]["rules"]
    symbols = occurring(rules, document["grammar"]["axiom"])
    listed = [s for c in document["classes"] for s in c["symbols"]]
    require(sorted(listed) == sorted(symbols), "the classes are not a partition of the symbols that occur")
    if len(symbols) > MOST_SYMBOLS_FOR_CLASSES:
        return
    reached = reachable_sets(rules, symbols)
    for entry in document["classes"]:
        first = entry["symbols"][0]
        mine = {first} | {s for s in reached[first] if first in reached[s]}
        require(set(entry["symbols"]) == mine, f"the class of {first} is not strongly connected and maximal")
        require(entry["final"] == (reached[first] <= mine), f"the class of {first}: final is wrong")
        require((entry["period"] == 0) == (first not in reached[first]), f"the class of {first}: period is wrong")


def check_frequencies(document, system):
    """s M = rho s, s >= 0, sum 1."""
    field = system.field
    entries = {s["name"]: s["frequency"] for s in document["symbols"] if s["frequency"] is not None}
    if not entries:
        return
    frequency = {name: read_number(field, entry, f"frequency of {name}") for name, entry in entries.items()}
    require(total(field, frequency.values()) == field.constant(1), "the frequencies do not sum to 1")
    for name, value in frequency.items():
        require(value.sign() >= 0, f"the frequency of {name} is negative")
        produced = total(field, [v.scaled(system.rules[other].count(name)) for other, v in frequency.items()])
        require(produced == system.ratio * value, f"s M = rho s does not hold for {name}")


def check_approximately(document):
    """The same for a system known by enclosures only, in doubles."""
    rules = document["grammar"]["rules"]
    lengths = {s["name"]: s["length"]["value"] for s in document["symbols"] if s["length"] is not None}
    ratio = document["ratio"]["value"]
    for name, length in lengths.items():
        image = math.fsum(lengths[child] for child in rules[name])
        require(abs(ratio * length - image) <= 1e-6 * image, f"rho a = M a does not nearly hold for {name}")


def check_validation(document):
    check_classes(document)
    lower, upper = document["enclosure"]["lower"], document["enclosure"]["upper"]
    require(lower <= document["ratio"]["value"] <= upper, "the ratio lies outside its enclosure")
    require(document["valid"] is True or document["reasons"], "not valid, and no reason given")
    if document["valid"] is not True:
        require(all(s["length"] is None for s in document["symbols"]), "lengths without validity")
        return
    require(not document["reasons"], "valid, and yet reasons why not")
    require(document["theorems"], "valid, and no theorem says so")
    if document["exactness"] == "enclosure":
        check_approximately(document)
        return
    system = System(document)
    require(
        set(system.lengths) - {"0"} == occurring(system.rules, system.axiom), "the symbols that occur have the lengths"
    )
    for bound, sign in ((lower, -1), (upper, 1)):
        require(
            (system.field.constant(Fraction(bound)) - system.ratio).sign() in (0, sign), "the enclosure misses the ratio"
        )
    check_frequencies(document, system)
    require(document["free_lengths"] == sum(c["final"] for c in document["classes"]), "free lengths are final classes")


# --- validation of point grammars ------------------------------------------------------------------------------------

SOUND = ("affine", "mixes-coordinates")


def rational(number):
    """An exact rational number and its double."""
    (text,) = number["exact"]
    require(float(Fraction(text)) == number["value"], f"{text} is not {number['value']}")
    return Fraction(text)


def refined(mask, k, function):
    """p'(k) = sum of a(k - m j) p(j), p(j) = function(j)."""
    arity, first, weights = mask
    total = Fraction(0)
    for i, weight in enumerate(weights):
        if (k - first - i) % arity == 0:
            total += weight * function(Fraction((k - first - i) // arity))
    return total


def reproduces(mask, degree, shift):
    """Whether samples of x^degree at whole numbers give samples at (k - shift)/m."""
    arity = mask[0]
    return all(
        refined(mask, k, lambda x: x**degree) == ((k - shift) / arity) ** degree for k in range(3 * arity)
    )


def check_mask_facts(facts):
    arity, first = facts["arity"], facts["first"]
    weights = [rational(number) for number in facts["weights"]]
    product = [rational(number) for number in facts["quotient"]]
    for _ in range(facts["factor_power"]):
        longer = [Fraction(0)] * (len(product) + arity - 1)
        for i, value in enumerate(product):
            for r in range(arity):
                longer[i + r] += value
        product = longer
    require(product == weights, "quotient times factors is not the mask")
    sums = [sum((w for i, w in enumerate(weights) if (first + i) % arity == r), Fraction(0)) for r in range(arity)]
    require(sums == [rational(number) for number in facts["sums"]], "sums of the residue classes")
    shift, degree = rational(facts["shift"]), facts["reproduction_degree"]
    mask = (arity, first, weights)
    for d in range(0 if degree is None else degree + 1):
        require(reproduces(mask, d, shift), f"degree {d} is not reproduced")
    if degree is not None and degree < facts["generation_degree"]:
        require(not reproduces(mask, degree + 1, shift), f"degree {degree + 1} is reproduced")
    ends = [Fraction(first, arity - 1), Fraction(first + len(weights) - 1, arity - 1)]
    require([rational(number) for number in facts["support"]] == ends, "support")
    smoothness = facts["smoothness"]
    if smoothness and smoothness["hoelder"]["lower"] is not None and smoothness["hoelder"]["upper"] is not None:
        require(smoothness["hoelder"]["lower"] <= smoothness["hoelder"]["upper"], "bounds in the wrong order")
    for scheme in smoothness["differences"] if smoothness else ():
        require(sum(rational(number) for number in scheme["weights"]) == 1, "a difference scheme does not sum to 1")
        require(scheme["radius"]["lower"] <= scheme["radius"]["upper"], "radii in the wrong order")


def check_point_validation(document):
    rules = document["grammar"]["rules"]
    for position in document["positions"]:
        require(position["part"] != "rule" or position["rule"] < len(rules), "a rule that does not exist")
        if position["verdict"] == "affine":
            require(position["sum"] == "1", "affine, and the sum is not 1")
        if position["verdict"] == "sum-is-not-one":
            require(position["sum"] != "1", "the sum is 1, and is said not to be")
    sound = all(position["verdict"] in SOUND for position in document["positions"])
    coverage = document["coverage"]
    complete = coverage is not None and coverage["ends_complete"]
    require(document["valid"] == (sound and complete and not document["problems"]), "the verdict does not follow")
    compilation = document["compilation"]
    if compilation:
        require(compilation["compiles"] == (not compilation["reasons"]), "reasons and verdict of the compiler disagree")
    if document["mask"]:
        check_mask_facts(document["mask"])


# --- masks -----------------------------------------------------------------------------------------------------------


def oslo_weights(system, word):
    """Weights of the basis function of `word` over the refined ones, left to right (Cohen, Lyche, Riesenfeld 1980)."""
    field, degree = system.field, len(word) - 1
    images = [system.image(symbol) for symbol in word]
    image = [child for part in images for child in part]
    owner = [k for k, part in enumerate(images) for _ in part]
    old = [knot * system.ratio for knot in system.knots(word)]  # in the unit of the refined lengths
    new = system.knots(image)

    def interval(position):
        """The old interval that holds the refined knot `position`: the first one with a length from there on."""
        while position < len(image) and image[position] == "0":
            position += 1
        return owner[position] if position < len(image) else None

    def quotient(numerator, denominator):
        return field.constant(0) if denominator.is_zero() else numerator * denominator.inverse()

    weights = []
    for l in range(len(image) - degree):
        alpha = [field.constant(int(interval(l) == j)) for j in range(degree + 1)]
        for k in range(1, degree + 1):
            u = new[l + k]
            alpha = [
                quotient((u - old[j]) * alpha[j], old[j + k] - old[j])
                + quotient((old[j + k + 1] - u) * alpha[j + 1], old[j + k + 1] - old[j + 1])
                for j in range(degree + 1 - k)
            ]
        weights.append(alpha[0])
    return weights, image


def check_decomposition(system, entry, degree):
    word = entry["word"]
    name = " ".join(word)
    require(len(word) == degree + 1, f"{name}: a decomposition has degree + 1 letters")
    expected, image = oslo_weights(system, word)
    require(len(entry["mask"]) == len(expected), f"{name}: {len(entry['mask'])} weights, not {len(expected)}")
    new = system.knots(image)
    mass = system.field.constant(0)
    for l, (item, weight) in enumerate(zip(entry["mask"], expected)):
        require(item["word"] == image[l : l + degree + 1], f"{name}: entry {l} is not a factor of its image")
        number = read_number(system.field, item["weight"], f"{name}, entry {l}")
        require(number.sign() >= 0, f"{name}: entry {l} is negative")
        require(number == weight, f"{name}: entry {l} is not the weight of knot insertion")
        mass = mass + number * (new[l + degree + 1] - new[l])
    require(mass == new[-1], f"{name}: the mass identity does not hold")


def check_graph(document):
    """Persistent words: on a cycle or reached from one; and the list is closed under images."""
    words = [tuple(entry["word"]) for entry in document["decompositions"]]
    require(len(set(words)) == len(words), "a decomposition stands twice")
    arcs = {tuple(e["word"]): {tuple(i["word"]) for i in e["mask"]} for e in document["decompositions"]}
    for word, targets in arcs.items():
        for target in targets:
            require(target in arcs, f"{' '.join(target)}, a child of {' '.join(word)}, is missing")
    persistent = set(words)  # keep taking images of the whole list: what stays is what occurs for ever
    while True:
        image = set().union(*(arcs[word] for word in persistent)) if persistent else set()
        if image == persistent:
            break
        require(image < persistent, "images are not among the words")
        persistent = image
    for entry in document["decompositions"]:
        require(entry["persistent"] == (tuple(entry["word"]) in persistent), f"{entry['word']}: persistent is wrong")


def elementary(field, values):
    """Elementary symmetric polynomials 0 ... n of n numbers."""
    polynomials = [field.constant(1)]
    for value in values:
        higher = [p * value for p in polynomials]
        polynomials = [
            (polynomials[k] if k < len(polynomials) else field.constant(0)) + (higher[k - 1] if k else field.constant(0))
            for k in range(len(polynomials) + 1)
        ]
    return polynomials


def check_row(system, local, arguments, entries, what):
    """Marsden: a row maps the symmetric polynomials of old knots to those of the new: sums to 1, Greville, all degrees."""
    degree = len(arguments)
    require(len(entries) == degree + 1, f"{what}: a row has degree + 1 weights")
    weights = [read_number(system.field, entry, what) for entry in entries]
    for weight in weights:
        require(weight.sign() >= 0, f"{what}: a weight is negative")
    wanted = elementary(system.field, arguments)
    sums = [system.field.constant(0)] * (degree + 1)
    for i, weight in enumerate(weights):
        for k, value in enumerate(elementary(system.field, local[i : i + degree])):
            sums[k] = sums[k] + weight * value
    for k in range(degree + 1):
        require(sums[k] == wanted[k], f"{what}: polynomials of degree {k} are not reproduced")


def check_window(system, document, entry, degree):
    word = entry["word"]
    name = " ".join(word)
    require(len(word) == 2 * degree - 1 and word[degree - 1] != "0", f"{name}: not a window")
    image = system.rewritten(word)
    first = len(system.rewritten(word[: degree - 1]))
    children = system.image(word[degree - 1])
    local = [knot * system.ratio for knot in system.knots(word)]
    new = system.knots(image)
    require(len(entry["children"]) == len(children), f"{name}: {len(entry['children'])} children")
    for c, child in enumerate(entry["children"]):
        place = first + c
        window = document["windows"][child["window"]]["word"]
        require(window == image[place - degree + 1 : place + degree], f"{name}: child {c} has another window")
        check_row(system, local, new[place + 1 : place + degree + 1], child["weights"], f"{name}, child {c}")
    require(len(entry["leading"]) == degree, f"{name}: there are d leading rows")
    for z in range(1, degree + 1):
        arguments = new[first - z + 1 : first - z + degree + 1]
        check_row(system, local, arguments, entry["leading"][z - 1], f"{name}, z = {z}")


def check_masks(document):
    system = System(document)
    degree = document["degree"]
    require(document["decompositions"] and document["windows"], "nothing in the table")
    for entry in document["decompositions"]:
        check_decomposition(system, entry, degree)
    check_graph(document)
    for entry in document["windows"]:
        check_window(system, document, entry, degree)


# --- the automaton ---------------------------------------------------------------------------------------------------


def check_state(system, document, index):
    """Window, offset and children of a state, each row by Marsden's identity at the knots of its child."""
    state, degree = document["states"][index], document["degree"]
    window, lead = state["window"], state["lead"]
    name = f"state {index}"
    require(len(window) == 2 * degree - 1 and window[degree - 1] != "0", f"{name}: not a window")
    require(lead <= degree and state["offset"] == lead - degree, f"{name}: lead and offset do not fit")
    image = system.rewritten(window)
    first = len(system.rewritten(window[: degree - 1]))
    local = [knot * system.ratio for knot in system.knots(window)]
    new = system.knots(image)
    children = 1 if lead > 0 else len(system.image(window[degree - 1]))
    require(len(state["children"]) == children, f"{name}: {len(state['children'])} children")
    for c, child in enumerate(state["children"]):
        target = document["states"][child["state"]]
        place = first + c
        require(target["window"] == image[place - degree + 1 : place + degree], f"{name}: child {c} has another window")
        require(target["lead"] == lead, f"{name}: child {c} has another lead")
        arguments = new[place + 1 - lead : place + 1 - lead + degree]
        check_row(system, local, arguments, document["rows"][child["row"]], f"{name}, child {c}")


def check_automaton(document):
    system = System(document)
    keys = [(tuple(state["window"]), state["lead"]) for state in document["states"]]
    require(len(set(keys)) == len(keys), "a state stands twice")
    rows = [tuple(tuple(weight["exact"]) for weight in row) for row in document["rows"]]
    require(len(set(rows)) == len(rows), "a row stands twice")
    used = {child["row"] for state in document["states"] for child in state["children"]}
    require(used == set(range(len(rows))), "a row that no state uses, or a row that is missing")
    for index in range(len(keys)):
        check_state(system, document, index)


# --- convergence -----------------------------------------------------------------------------------------------------


def check_constant(document, system):
    """C* of its word: the mean square distance of d knots."""
    degree = document["degree"]
    constant = read_number(system.field, document["constant"], "constant")
    word = document["constant_word"]
    if degree == 1:
        require(constant.is_zero(), "the constant of degree 1 is 0")
        return
    require(len(word) == degree - 1, "the constant is attained at d - 1 letters")
    knots = system.knots(word)
    squares = [(a - b) * (a - b) for a, b in itertools.combinations(knots, 2)]
    expected = total(system.field, squares).scaled(Fraction(1, 2 * degree**2 * (degree - 1)))
    require(constant == expected, "the constant is not that of its word")


def check_convergence(document):
    system = System(document)
    one = system.field.constant(1)
    expected = read_number(system.field, document["expected_ratio"], "expected ratio")
    require(expected * system.ratio * system.ratio == one, "the expected ratio is not 1 / rho^2")
    check_constant(document, system)
    period = document["period"]
    steps = document["steps"]
    for s, step in enumerate(steps):
        require(step["step"] == s, "a step is missing")
        require(step["envelope"] >= step["error"] * (1 - 1e-9), f"step {s}: the error leaves its envelope")
        if s > 0:
            require(step["points"] >= steps[s - 1]["points"], f"step {s}: fewer points than before")
        if s >= period and steps[s - period]["error"] > 0 and step["error"] > 0:
            ratio = (step["error"] / steps[s - period]["error"]) ** (1 / period)
            require(step["ratio"] is not None, f"step {s}: the ratio is missing")
            require(abs(ratio - step["ratio"]) <= 1e-9 * ratio, f"step {s}: the ratio is not that of the errors")
        else:
            require(step["ratio"] in (None, 0), f"step {s}: a ratio out of nothing")
    if document["degree"] == 1:
        require(all(step["error"] == 0 for step in steps), "at degree 1 the polygon is the curve")
    depth = document["depth_for_tolerance"]
    if depth and depth["steps"] is not None and depth["measured"] and depth["steps"] < len(steps):
        require(steps[depth["steps"]]["envelope"] <= depth["tolerance"], "the tolerance is not reached where it says so")


# --- curves ----------------------------------------------------------------------------------------------------------


def check_knots(word, lengths, origin, knots, degree, closed):
    """The knots are the sums of the lengths of the word, the origin where the domain begins."""
    values = [0.0 if symbol == "0" else lengths[symbol]["value"] for symbol in word]
    require(len(knots) == len(word) + 1, f"{len(knots)} knots for {len(word)} letters")
    require(knots[0 if closed else degree] == origin["value"], "the domain does not begin at the origin")
    near = 1e-12 * max(abs(knot) for knot in knots)
    require(all(abs(b - a - value) <= near for a, b, value in zip(knots, knots[1:], values)), "a knot interval is wrong")


def check_curve(document):
    points = document["points"]
    require(len({len(point) for point in points}) == 1, "points of different dimension")
    closed = document.get("closed", False)
    if "word" in document:
        letters = len(points) + (0 if closed else document["degree"])
        require(len(document["word"]) == letters, f"{len(document['word'])} letters for {len(points)} points")
    if "word" in document and "knots" in document:
        check_knots(
            document["word"], document["lengths"], document["origin"], document["knots"], document["degree"], closed
        )


def check_curves(document):
    for curve in document["curves"]:
        check_curve(curve)


def check_points(document):
    """Every point stands in a strand, branches begin at points of other strands, all points have one dimension."""
    points = document["points"]
    require(len({len(point) for point in points} | {len(end) for line in document["lines"] for end in line}) <= 1,
            "points of several dimensions")
    require("weights" not in document or len(document["weights"]) == len(points), "weights and points disagree")
    seen = [index for strand in document["strands"] for index in strand["points"]]
    require(all(index < len(points) for index in seen), "a strand has an index without a point")
    require(set(seen) == set(range(len(points))), "a point stands in no strand")
    require(document["closed"] or not any(strand["closed"] for strand in document["strands"]), "an open word has a ring")
    for constant in document["grammar"]["constants"].values():
        exact = constant["exact"]
        require(exact is None or float(Fraction(exact)) == constant["value"], "a constant is not the nearest double")


def check_parts(document):
    for part in document["parts"]:
        require(part["format"] == "internode-points", "a part is no internode-points")
        require(part["grammar"] == document["parts"][0]["grammar"], "the parts have different grammars")
        check_points(part)


def check_grid(document):
    rows = document["points"]
    require(len({len(row) for row in rows}) == 1, "rows of different size")
    require(len({len(point) for row in rows for point in row}) == 1, "points of different dimension")
    if document.get("rational", False):
        require(all(point[-1] > 0 for row in rows for point in row), "a weight that is not positive")
    for side, count in enumerate((len(rows), len(rows[0]))):
        letters = count + (0 if document["closed"][side] else document["degree"][side])
        require(len(document["word"][side]) == letters, f"{len(document['word'][side])} letters for {count} points")
        if document.get("knots", [None, None])[side] is not None:
            parts = [document[key][side] for key in ("word", "lengths", "origin", "knots", "degree", "closed")]
            check_knots(*parts)


def refined_word(rules, word, degree, closed):
    def image(part):
        return [child for symbol in part for child in (["0"] if symbol == "0" else rules[symbol])]

    if closed:
        return image(word)
    return image(word[:degree])[-degree:] + image(word[degree:-degree]) + image(word[-degree:])[:degree]


class SampledCurve:
    """A curve evaluated by de Boor in fractions. The domain starts at 0."""

    def __init__(self, document, lengths):
        self.degree, self.closed = document["degree"], document.get("closed", False)
        word, points = document["word"], [[Fraction(x) for x in p] for p in document["points"]]
        if self.closed:  # unrolled: d letters before, d + 1 behind
            letters = [word[i % len(word)] for i in range(-self.degree, len(word) + self.degree + 1)]
            self.points = [points[i % len(points)] for i in range(-self.degree, len(word) + 1)]
            self.last = self.degree + len(word)
        else:
            letters, self.points = word, points
            self.last = len(points)
        self.word = letters
        self.knots = [Fraction(0)]
        for symbol in letters:
            self.knots.append(self.knots[-1] + (Fraction(0) if symbol == "0" else lengths[symbol]))
        start = self.knots[self.degree]
        self.knots = [knot - start for knot in self.knots]

    def end(self):
        return self.knots[self.last]

    def at(self, x):
        j = self.degree
        while j + 1 < self.last and self.knots[j + 1] <= x:
            j += 1
        values = [list(p) for p in self.points[j - self.degree : j + 1]]
        for r in range(1, self.degree + 1):
            for i in range(self.degree, r - 1, -1):
                low, high = self.knots[j - self.degree + i], self.knots[j + 1 + i - r]
                t = (x - low) / (high - low)
                values[i] = [(1 - t) * a + t * b for a, b in zip(values[i - 1], values[i])]
        return values[self.degree]


def sharp_field(validation):
    """The field, its root enclosed far beyond double precision."""
    field = Field(validation["field"]["minimal_polynomial"], validation["field"]["root"])
    for _ in range(80):
        if field.degree > 1:
            field.refine()
    return field


def exact_lengths(field, validation, curve):
    """Those of the curve where it has its own, else those of the system."""
    entries = {s["name"]: s["length"] for s in validation["symbols"] if s["length"] is not None}
    given = curve.get("lengths", {})
    for name, entry in given.items():
        require(isinstance(entry, dict), f"the length of {name} is not written exactly")
        require(field.number(entry["exact"]).to_float() == entry["value"], f"length of {name}: not the nearest double")
    entries.update(given)
    return {name: field.number(entry["exact"]) for name, entry in entries.items()}


SAMPLES = 24
TOLERANCE = Fraction(1, 10**12)  # relative to the coordinates, which are doubles


def check_refined(coarse, validation, steps, fine):
    """Words letter by letter, counts, and the same curve at some parameters."""
    require(coarse["degree"] == fine["degree"], "the degree changed")
    require(coarse.get("closed", False) == fine.get("closed", False), "an open curve became closed, or closed open")
    word = coarse["word"]
    for _ in range(steps):
        word = refined_word(validation["grammar"]["rules"], word, coarse["degree"], coarse.get("closed", False))
    require(word == fine["word"], "the word is not the rewritten word")
    field = sharp_field(validation)
    scale = field.constant(1)
    for _ in range(steps):
        scale = scale * field.generator()
    old, new = exact_lengths(field, validation, coarse), exact_lengths(field, validation, fine)
    for name in set(word) - {"0"}:
        require(new[name] * scale == old[name], f"the length of {name} was not divided by rho^{steps}")
    before = SampledCurve(coarse, {name: length.bounds()[0] for name, length in old.items()})
    after = SampledCurve(fine, {name: length.bounds()[0] for name, length in new.items()})
    size = max(abs(x) for point in coarse["points"] for x in point) or 1
    for k in range(SAMPLES):
        x = before.end() * Fraction(2 * k + 1, 2 * SAMPLES + 1)
        for a, b in zip(before.at(x), after.at(x)):
            require(abs(a - b) <= TOLERANCE * Fraction(size), f"the curves differ at {float(x)}: {float(a - b)}")


# --- pyramids --------------------------------------------------------------------------------------------------------


def pyramid_words(document):
    """The words of all levels, the coarse one first."""
    words = [document["word"]]
    for _ in document["levels"]:
        words.append(refined_word(document["grammar"]["rules"], words[-1], document["degree"], document["closed"]))
    return words


def check_pyramid(document):
    System(document)
    extra = 0 if document["closed"] else document["degree"]
    words = pyramid_words(document)
    require(len(document["points"]) == len(words[0]) - extra, "the coarse polygon does not fit its word")
    for s, level in enumerate(document["levels"]):
        require(level["points"] == len(words[s + 1]) - extra, f"level {s + 1}: the points do not fit the word")
        require(level["inserted"] == len(words[s + 1]) - len(words[s]), f"level {s + 1}: inserted")
        at = level["at"]
        require(len(at) == len(level["details"]) <= level["inserted"], f"level {s + 1}: details")
        require(at == sorted(set(at)) and all(0 <= i < level["points"] for i in at), f"level {s + 1}: places of details")
        longest = max((math.hypot(*detail) for detail in level["details"]), default=0)
        require(longest <= level["longest"] * (1 + 1e-12), f"level {s + 1}: a detail longer than the longest")
    require(document["fitting"]["points"] == len(words[-1]) - extra, "the fine polygon does not fit its word")
    require(document["round_trip"]["largest"] <= 1e-10, "the details do not give the fine polygon back")
    require(document["error"]["largest"] >= document["error"]["root_mean_square"], "a largest error below the mean")


def check_point_masks(document):
    mask, matrix = document["mask"], document["matrix"]
    rows, columns = matrix["rows"], matrix["columns"]
    for row in rows:
        places = [entry["column"] for entry in row]
        require(places == sorted(set(places)) and all(column < columns for column in places), "columns of a row")
    if mask and document["closed"]:
        arity, dense = mask["arity"], [[Fraction(0)] * columns for _ in range(mask["arity"] * columns)]
        require(len(rows) == len(dense), "the matrix does not have the rows of the arity")
        for j in range(columns):
            for i, weight in enumerate(mask["coefficients"]):
                dense[(arity * j + mask["first"] + i) % len(dense)][j] += Fraction(weight)
        for row, expected in zip(rows, dense):
            written = {entry["column"]: Fraction(entry["weight"]) for entry in row}
            require(written == {j: weight for j, weight in enumerate(expected) if weight}, "the matrix is not the mask's")


def check_cells(document):
    states, rows = document["states"], document["rows"]
    require(len({len(row) for row in rows}) <= 1, "rows of several widths")
    for state in states:
        for child in state["children"]:
            require(child["state"] < len(states) and child["row"] < len(rows), "a child outside the tables")
    require(all(state < len(states) for state in document["start"]), "a start state outside the tables")
    for row in rows:
        require(sum(map(Fraction, row)) == 1, "a row is not affine")


def check_reversal(document):
    counts = [document["fitting"]["points"]] + [level["points"] for level in document["levels"]]
    require(len(document["points"]) == counts[-1], "the points are not those of the last level")
    require(len({len(point) for point in document["points"]}) == 1, "points of several dimensions")
    rule = document["rule"]
    for fine, coarse in zip(counts, counts[1:]):
        require(coarse < fine or (rule and rule["arity"] == 1), "a level is not coarser than the one above it")
        require(not rule or coarse * rule["arity"] == fine, "a level does not have the points of its arity")
    for level in document["levels"]:
        require((level["rms_error"] is None) == (rule is None), "errors are known with a rule")
        require(rule is None or level["rms_error"] <= level["largest_error"], "a mean above the largest error")
    if rule:
        weights = [Fraction(weight) for weight in rule["weights"]]
        require(sum(weights) == 1, "the weights of the rule do not sum to 1")
        require(sum(map(abs, weights)) == Fraction(rule["gain"]), "the gain is not the sum of the absolute weights")


def step_rows(system, word, degree, closed):
    """P in doubles: each new point as {old point: weight}, by scattering the basis functions."""
    letters = len(system.rewritten(word))
    if closed:
        points, new_points, first = len(word), letters, 0
    else:
        ends = [len(system.rewritten(part)) for part in (word[:degree], word[-degree:])]
        points, first = len(word) - degree, ends[0] - degree
        new_points = letters - sum(ends) + degree
    rows = [{} for _ in range(new_points)]
    start = 0
    known = {}
    for k in range(points):
        support = tuple(word[(k + i) % len(word)] for i in range(degree + 1))
        if support not in known:
            known[support] = [weight.to_float() for weight in oslo_weights(system, list(support))[0]]
        for e, weight in enumerate(known[support]):
            place = start + e
            place = place % new_points if closed else place - first
            if weight and 0 <= place < new_points:
                rows[place][k] = rows[place].get(k, 0.0) + weight
        start += len(system.image(word[k]))
    return rows


def normal_solution(rows, columns, right):
    """The x with least |P x - right|, by elimination on the normal equations; `right` and x are rows of coordinates."""
    matrix = [[0.0] * columns + [0.0] * len(right[0]) for _ in range(columns)]
    for row, values in zip(rows, right):
        for i, a in row.items():
            for j, b in row.items():
                matrix[i][j] += a * b
            for c, value in enumerate(values):
                matrix[i][columns + c] += a * value
    for i in range(columns):  # positive definite: no pivoting
        matrix[i] = [a / matrix[i][i] for a in matrix[i]]
        for r in range(columns):
            if r != i and matrix[r][i]:
                factor = matrix[r][i]
                matrix[r] = [a - factor * b for a, b in zip(matrix[r], matrix[i])]
    return [row[columns:] for row in matrix]


def check_composed(document, fine):
    """Puts a least-squares pyramid together: f = P (c - A e) + e at every level."""
    require(document["method"] == "least-squares", "only least squares is put together here")
    system = System(document)
    words = pyramid_words(document)
    points = document["points"]
    size = max(abs(x) for point in points for x in point) or 1
    for word, level in zip(words, document["levels"]):
        rows = step_rows(system, word, document["degree"], document["closed"])
        filled = [[0.0] * len(points[0]) for _ in rows]
        for i, detail in zip(level["at"], level["details"]):
            filled[i] = detail
        shift = normal_solution(rows, len(points), filled)
        points = [[a - b for a, b in zip(p, q)] for p, q in zip(points, shift)]
        points = [
            [sum(weight * points[k][c] for k, weight in row.items()) + value for c, value in enumerate(values)]
            for row, values in zip(rows, filled)
        ]
    require(fine["word"] == words[-1] and len(fine["points"]) == len(points), "another polygon")
    error = max(abs(a - b) for p, q in zip(points, fine["points"]) for a, b in zip(p, q))
    require(error <= 1e-9 * size, f"put together it is {error} off")


# --- all -------------------------------------------------------------------------------------------------------------

def check_word(document):
    word, counts = document["word"], document["counts"]
    require(document["letters"] == len(word), "letters of the word")
    require({name: word.count(name) for name in counts} == counts, "counts of the letters")
    require(set(word) <= set(counts), "every letter is counted")


def check_formats(document):
    names = [row["name"] for row in document["formats"]]
    extensions = [extension for row in document["formats"] for extension in row["extensions"]]
    require(len(set(names)) == len(names), "a format has one row")
    require(len(set(extensions)) == len(extensions), "an extension stands for one format")


def check_mesh(document):
    sizes = document["face_sizes"]
    require(sum(row["faces"] for row in sizes) == document["faces"], "the faces by their corners")
    sides = sum(row["faces"] * row["corners"] for row in sizes)
    isolated = sum(1 for fault in document["faults"] if fault["kind"] == "isolated vertex")
    others = len(document["faults"]) - isolated
    for fault in document["faults"]:
        require(all(vertex < document["vertices"] for vertex in fault["vertices"]) or fault["kind"] == "index out of range",
                "the vertices of a fault")
        require(all(face < document["faces"] for face in fault["faces"]), "the faces of a fault")
    topology = document["topology"]
    require((topology is None) == (others > 0), "a manifold has a topology")
    if topology is None:
        return
    valences = {name: [(row["valence"], row["vertices"]) for row in topology[f"{name}_valences"]] for name in ("interior", "boundary")}
    vertices = document["vertices"] - isolated
    require(sum(count for of in valences.values() for _, count in of) == vertices, "every vertex has a valence")
    require(sum(v * count for of in valences.values() for v, count in of) == 2 * document["edges"], "the valences sum to the ends of edges")
    require(sides + topology["boundary_edges"] == 2 * document["edges"], "an edge has two sides, or one and the boundary")
    require(sum(count for _, count in valences["boundary"]) == topology["boundary_edges"], "as many boundary vertices as edges")
    euler = vertices - document["edges"] + document["faces"]
    require(topology["euler_characteristic"] == euler, "vertices - edges + faces")
    require(euler == 2 * topology["components"] - 2 * topology["genus"] - topology["boundary_loops"], "genus and Euler characteristic")


CHECKS = {
    "internode-validation": ("validation", check_validation),
    "internode-point-validation": ("point-validation", check_point_validation),
    "internode-masks": ("masks", check_masks),
    "internode-automaton": ("automaton", check_automaton),
    "internode-convergence": ("convergence", check_convergence),
    "internode-curve": ("curve", check_curve),
    "internode-curves": ("curves", check_curves),
    "internode-grid": ("grid", check_grid),
    "internode-points": ("points", check_points),
    "internode-parts": ("parts", check_parts),
    "internode-pyramid": ("pyramid", check_pyramid),
    "internode-reversal": ("reversal", check_reversal),
    "internode-point-masks": ("point-masks", check_point_masks),
    "internode-cells": ("cells", check_cells),
    "internode-word": ("word", check_word),
    "internode-mesh": ("mesh", check_mesh),
    "internode-formats": ("formats", check_formats),
}


def no_constant(name):
    raise Fault(f"{name} is not JSON")


def load(path, schemas):
    document = json.loads(pathlib.Path(path).read_text(encoding="utf-8"), parse_constant=no_constant)
    require(document.get("format") in CHECKS, f"unknown format {document.get('format')!r}")
    name = CHECKS[document["format"]][0]
    if jsonschema is not None and schemas is not None:
        schema = json.loads((schemas / f"{name}.schema.json").read_text(encoding="utf-8"))
        validator = jsonschema.Draft202012Validator(schema)
        fault = jsonschema.exceptions.best_match(validator.iter_errors(document))
        require(fault is None, f"schema: {fault and fault.message} at {fault and list(fault.absolute_path)}")
    return document


def main():
    parser = argparse.ArgumentParser(description="Checks JSON that internode wrote.")
    parser.add_argument("--schema-dir", type=pathlib.Path)
    parser.add_argument("--refined", nargs=4, action="append", default=[], metavar=("INPUT", "VALIDATION", "STEPS", "OUTPUT"))
    parser.add_argument("--composed", nargs=2, action="append", default=[], metavar=("PYRAMID", "OUTPUT"))
    parser.add_argument("files", nargs="*", type=pathlib.Path)
    options = parser.parse_args()
    faults = checked = 0

    def attempt(name, check):
        nonlocal faults, checked
        checked += 1
        try:
            check()
        except (Fault, KeyError, IndexError, ValueError, TypeError, OSError) as fault:
            faults += 1
            print(f"{name}: {type(fault).__name__}: {fault}", file=sys.stderr)

    def check_file(path):
        document = load(path, options.schema_dir)
        CHECKS[document["format"]][1](document)

    for path in options.files:
        attempt(path, lambda: check_file(path))
    for coarse, validation, steps, fine in options.refined:
        attempt(
            fine,
            lambda: check_refined(
                load(coarse, options.schema_dir), load(validation, options.schema_dir), int(steps), load(fine, options.schema_dir)
            ),
        )
    for pyramid, fine in options.composed:
        attempt(
            fine,
            lambda: check_composed(load(pyramid, options.schema_dir), load(fine, options.schema_dir)),
        )
    schemas = "" if jsonschema is not None and options.schema_dir else " (schemas not checked)"
    print(f"{checked} checked, {faults} at fault{schemas}")
    return 1 if faults or not checked else 0


if __name__ == "__main__":
    sys.exit(main())
