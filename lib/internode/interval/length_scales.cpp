// SPDX-License-Identifier: MIT
//
// Classes stand with their successors first, so lengths come class by class; those that lead to several final classes
// come last, when the scales are known. arrivals() goes the other way: it carries a row of counts down to the final
// classes. Frequencies and the parts of a shared length both follow from it.

#include "internode/interval/length_scales.h"

#include "internode/interval/eigenvector.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <numeric>
#include <stdexcept>

namespace internode {

namespace {

using Numbers = std::vector<Number>;

/// The lengths of one class from those of the classes it leads to.
void fill_class(const ExactSystem& system, const IntervalClass& one, Numbers& lengths) {
    assert(lengths.size() == system.graph.matrix.size());
    Numbers values;
    if (one.final) {
        values = perron_vector(one.block, system.field);
    } else {
        for (const std::uint32_t member : one.members) {
            Number& sum = values.emplace_back();
            for (const auto& [column, entry] : system.graph.matrix[member])
                if (system.graph.class_of[column] != system.graph.class_of[member])
                    sum += Number(static_cast<long>(entry)) * lengths[column];
        }
        values = resolvent(one.block, system.field, values);
    }
    assert(values.size() == one.members.size());
    for (std::size_t i = 0; i < one.members.size(); ++i) lengths[one.members[i]] = values[i];
}

/// Symbols that lead to several final classes follow from all the others.
void fill_shared(const ExactSystem& system, Numbers& lengths) {
    for (const IntervalClass& one : system.graph.classes)
        if (one.home == no_class) fill_class(system, one, lengths);
}

void multiply_homes(const ExactSystem& system, const std::vector<std::optional<Number>>& scales, Numbers& lengths) {
    for (const IntervalClass& one : system.graph.classes) {
        if (one.home == no_class || !scales[one.home]) continue;
        for (const std::uint32_t member : one.members) lengths[member] *= *scales[one.home];
    }
}

/// n_0ᵀ (ρ-weighted) as it arrives in the final classes: n_F + n_N (ρI − M_NN)^{-1} M_NF.
Numbers arrivals(const ExactSystem& system, Numbers counts) {
    assert(counts.size() == system.graph.matrix.size());
    const auto& classes = system.graph.classes;
    for (auto one = classes.rbegin(); one != classes.rend(); ++one) {
        if (one->final) continue;
        Numbers inside;
        for (const std::uint32_t member : one->members) inside.push_back(counts[member]);
        if (std::ranges::all_of(inside, [](const Number& count) { return count.sign() == 0; })) continue;
        inside = resolvent(transposed(one->block), system.field, inside);
        for (std::size_t i = 0; i < inside.size(); ++i) {
            const std::uint32_t member = one->members[i];
            for (const auto& [column, entry] : system.graph.matrix[member])
                if (system.graph.class_of[column] != system.graph.class_of[member])
                    counts[column] += Number(static_cast<long>(entry)) * inside[i];
        }
    }
    return counts;
}

/// What each final class contributes to the length of a symbol, at the scales that `lengths` has.
std::vector<std::pair<std::uint32_t, Number>> parts(const ExactSystem& system, const Numbers& lengths, Symbol symbol) {
    Numbers counts(lengths.size());
    counts[to_index(symbol)] = 1;
    counts = arrivals(system, std::move(counts));
    std::vector<std::pair<std::uint32_t, Number>> result;
    for (std::uint32_t index = 0; index < system.graph.classes.size(); ++index) {
        const IntervalClass& one = system.graph.classes[index];
        if (!one.final) continue;
        Number part;
        for (const std::uint32_t member : one.members) part += counts[member] * lengths[member];
        if (part.sign() != 0) result.emplace_back(index, part);
    }
    return result;
}

std::string class_text(const IntervalClass& one, const Alphabet& names) {
    return "{" + names.name(to_symbol(one.members.front())) + (one.members.size() > 1 ? ", …}" : "}");
}

/// Takes the declarations one by one and remembers the scales they fix.
class Scaling {
public:
    Scaling(const ExactSystem& system, Numbers lengths, const Alphabet& names, const std::string& generator)
        : system_(system)
        , names_(names)
        , generator_(generator)
        , lengths_(std::move(lengths))
        , scales_(system.graph.classes.size()) {}

    void take(const FixedLength& declaration) {
        const std::uint32_t home = home_of(declaration.symbol);
        const Number& length = lengths_[to_index(declaration.symbol)];
        assert(home != no_class && length.sign() > 0);
        if (!scales_[home])
            scales_[home] = declaration.length / length;
        else
            check(declaration, *scales_[home] * length);
    }

    /// A symbol that leads to several final classes: their sum must come out. False when two or more are open.
    bool take_shared(const FixedLength& declaration) {
        Number known;
        std::vector<std::pair<std::uint32_t, Number>> open;
        for (const auto& part : parts(system_, lengths_, declaration.symbol)) {
            if (scales_[part.first])
                known += *scales_[part.first] * part.second;
            else
                open.push_back(part);
        }
        if (open.size() > 1) return false;
        if (open.empty()) {
            check(declaration, known);
        } else if (const Number rest = declaration.length - known; rest.sign() > 0) {
            scales_[open.front().first] = rest / open.front().second;
        } else {
            refuse(declaration, known,
                   fmt::format("length {} = {} leaves nothing for class {}: the other lengths already make it {}",
                               names_.name(declaration.symbol), text(declaration.length),
                               class_text(system_.graph.classes[open.front().first], names_), text(known)));
        }
        return true;
    }

    void refuse_open(const FixedLength& declaration) {
        refuse(declaration, lengths_[to_index(declaration.symbol)],
               fmt::format("length {} = {} does not fix a scale: {} leads to several final classes; declare the length "
                           "of a symbol in all of them but one",
                           names_.name(declaration.symbol), text(declaration.length), names_.name(declaration.symbol)));
    }

    ScaledLengths take_result() {
        if (result_.conflicts.empty()) {
            multiply_homes(system_, scales_, lengths_);
            fill_shared(system_, lengths_);
            result_.lengths = std::move(lengths_);
        }
        return std::move(result_);
    }

    [[nodiscard]] std::uint32_t home_of(Symbol symbol) const {
        return system_.graph.classes[system_.graph.class_of[to_index(symbol)]].home;
    }

private:
    [[nodiscard]] std::string text(const Number& number) const {
        if (number.is_rational()) return number.to_string(system_.field, generator_);
        if (system_.field.degree() > 4) return fmt::format("{:.10g}", number.to_double());
        return fmt::format("{} ≈ {:.10g}", number.to_string(system_.field, generator_), number.to_double());
    }

    void refuse(const FixedLength& declaration, const Number& implied, std::string message) {
        result_.conflicts.push_back({declaration.symbol, declaration.length, implied, std::move(message)});
    }

    void check(const FixedLength& declaration, const Number& implied) {
        const Number residual = declaration.length - implied;
        if (residual.sign() == 0) return;
        refuse(declaration, implied,
               fmt::format("length {} = {} disagrees: with the lengths before it, {} has length {} (residual {:.3g})",
                           names_.name(declaration.symbol), text(declaration.length), names_.name(declaration.symbol),
                           text(implied), residual.to_double()));
    }

    const ExactSystem& system_;
    const Alphabet& names_;
    const std::string& generator_;
    Numbers lengths_;
    std::vector<std::optional<Number>> scales_; ///< the scale of each final class
    ScaledLengths result_;
};

Number inner_product(const Numbers& a, const Numbers& b) {
    assert(a.size() == b.size());
    Number sum;
    for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
    return sum;
}

void normalise(Numbers& values) {
    Number sum;
    for (const Number& value : values) sum += value;
    assert(sum.sign() > 0);
    const Number inverse = Number(1) / sum;
    for (Number& value : values) value *= inverse;
}

Numbers axiom_counts(const Axiom& axiom, std::size_t n) {
    std::vector<long> counts(n);
    for (const Symbol symbol : axiom.word)
        if (symbol != zero_interval) ++counts[to_index(symbol)];
    return Numbers(counts.begin(), counts.end());
}

} // namespace

std::vector<Number> unit_lengths(const ExactSystem& system) {
    const auto& classes = system.graph.classes;
    Numbers lengths(system.graph.matrix.size());
    std::vector<std::optional<Number>> scales(classes.size());
    for (const IntervalClass& one : classes) {
        if (one.home == no_class) continue;
        fill_class(system, one, lengths);
        for (const std::uint32_t member : one.members)
            if (!scales[one.home] || lengths[member] < *scales[one.home]) scales[one.home] = lengths[member];
    }
    for (auto& scale : scales)
        if (scale) scale = Number(1) / *scale;
    multiply_homes(system, scales, lengths);
    fill_shared(system, lengths);
    return lengths;
}

ScaledLengths scale_lengths(const ExactSystem& system, std::vector<Number> lengths,
                            const std::vector<FixedLength>& declarations, const Alphabet& names,
                            const std::string& generator) {
    assert(lengths.size() == names.size());
    Scaling scaling(system, std::move(lengths), names, generator);
    std::vector<FixedLength> shared;
    for (const FixedLength& declaration : declarations) {
        if (declaration.length.sign() <= 0) throw std::invalid_argument("a length must be positive");
        if (system.graph.class_of.at(to_index(declaration.symbol)) == no_class) continue;
        if (scaling.home_of(declaration.symbol) == no_class)
            shared.push_back(declaration);
        else
            scaling.take(declaration);
    }
    for (std::size_t before = shared.size() + 1; shared.size() < before;) {
        before = shared.size();
        std::erase_if(shared, [&](const FixedLength& declaration) { return scaling.take_shared(declaration); });
    }
    for (const FixedLength& declaration : shared) scaling.refuse_open(declaration);
    return scaling.take_result();
}

std::vector<Number> frequencies(const ExactSystem& system, const std::optional<Axiom>& axiom) {
    const auto& classes = system.graph.classes;
    const std::size_t n = system.graph.matrix.size();
    const auto finals = std::ranges::count_if(classes, [](const IntervalClass& one) { return one.final; });
    if (finals > 1 && !axiom) return {};
    const Numbers counts = finals > 1 ? arrivals(system, axiom_counts(*axiom, n)) : Numbers();
    Numbers result(n);
    for (const IntervalClass& one : classes) {
        if (!one.final) continue;
        const Numbers left = perron_vector(transposed(one.block), system.field);
        Number weight = 1;
        if (finals > 1) {
            const Numbers right = perron_vector(one.block, system.field);
            Numbers arrived;
            for (const std::uint32_t member : one.members) arrived.push_back(counts[member]);
            weight = inner_product(arrived, right) / inner_product(left, right);
        }
        for (std::size_t i = 0; i < left.size(); ++i) result[one.members[i]] = weight * left[i];
    }
    normalise(result);
    return result;
}

} // namespace internode
