// SPDX-License-Identifier: MIT

#include "cli/intervals/curve_output.h"
#include "cli/intervals/handlers.h"
#include "cli/intervals/limit_output.h"
#include "cli/intervals/polygon.h"
#include "cli/requests/formats.h"
#include "cli/requests/places.h"
#include "cli/shell/generator.h"
#include "cli/shell/output.h"
#include "cli/shell/parts.h"
#include "cli/shell/picture_axes.h"
#include "internode/curve/refinement.h"
#include "internode/io/csv.h"
#include "internode/io/json/curve_json.h"
#include "internode/io/npy.h"
#include "internode/io/obj/obj.h"
#include "internode/report/picture/curve_picture.h"
#include "internode/report/picture/drawn_steps.h"
#include "internode/text/number.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <set>

namespace internode::cli {
namespace {

/// Of all curves together; what --plan says, and what is checked before any work.
RefinementSize planned(const std::vector<SettledCurve>& curves, const SubdivideOptions& options) {
    RefinementSize sum;
    for (const SettledCurve& loaded : curves) {
        const RefinementSize size = refined_size(loaded.curve, options.steps, options.polygon.max_points);
        sum.points += size.points;
        sum.bytes += size.bytes;
        if (size.exceeded || sum.points > options.polygon.max_points)
            throw failure(ExitCode::Refused,
                          fmt::format("{} steps give more than {} points", options.steps, options.polygon.max_points),
                          "fewer steps, or a larger --max-points");
    }
    return sum;
}

bool has_weights(const SettledCurve& loaded) {
    return loaded.coordinates == Coordinates::Homogeneous;
}

/// The steps of a picture of all curves.
DrawnSteps drawn_steps_of(const std::vector<SettledCurve>& curves, std::uint64_t steps) {
    std::vector<const Curve*> all;
    for (const SettledCurve& loaded : curves) all.push_back(&loaded.curve);
    return drawn_steps(all, steps);
}

/// The memory that results in this format take: a picture, or points and a copy of those divided by their weights.
std::uint64_t planned_memory(const std::vector<SettledCurve>& curves, const SubdivideOptions& options,
                             const std::string& format) {
    std::uint64_t memory = 0;
    const std::uint64_t drawn = format == "svg" ? drawn_steps_of(curves, options.steps).steps : 0;
    for (const SettledCurve& loaded : curves) {
        const RefinementSize size = refined_size(loaded.curve, options.steps, options.polygon.max_points);
        const std::uint64_t divided = has_weights(loaded) ? size.points * loaded.curve.dimension() * sizeof(double) : 0;
        memory += format == "svg" ? curve_picture_bytes(loaded.curve, drawn, loaded.coordinates) : size.bytes + divided;
    }
    return memory;
}

void print_plan(const std::vector<SettledCurve>& curves, const SubdivideOptions& options, const std::string& format) {
    const RefinementSize size = planned(curves, options);
    const std::uint64_t memory = planned_memory(curves, options, format);
    std::uint64_t bytes = 0;
    std::size_t states = 0;
    std::size_t rows = 0;
    for (const SettledCurve& loaded : curves) {
        const RefinementSize one = refined_size(loaded.curve, options.steps, options.polygon.max_points);
        bytes += one.points * loaded.curve.dimension() * sizeof(double);
        const Refinement refinement(loaded.curve);
        states += refinement.automaton().state_count();
        rows += refinement.automaton().row_count();
    }
    write_output("-", fmt::format("points {}\nbytes of points {}\nbytes of memory {}\nstates {}\nrows {}\n",
                                  size.points, bytes, memory, states, rows));
}

std::vector<std::string> column_names(const SettledCurve& loaded) {
    return loaded.columns.empty() ? coordinate_names(loaded.space_dimension()) : loaded.columns;
}

/// The points of a refined curve as they are written: in space, with their weights behind them or without.
struct WrittenPoints {
    bool weighted = false;
    std::size_t dimension = 1;
    std::vector<double> divided; ///< the rows divided by their weights; empty when points have none
    const std::vector<double>* given = nullptr;

    [[nodiscard]] PointsView view() const {
        assert(given != nullptr);
        return {dimension, divided.empty() ? *given : divided};
    }
};

/// A polygon in OBJ knows no weights; elsewhere they are the last column, or the key "weights".
WrittenPoints written_points(const Curve& curve, const SettledCurve& loaded, const std::string& format) {
    WrittenPoints written;
    written.weighted = has_weights(loaded) && format != "obj";
    written.dimension = loaded.space_dimension() + (written.weighted ? 1 : 0);
    written.given = &curve.points();
    if (written.weighted) written.divided = projected(curve.points(), curve.dimension());
    if (has_weights(loaded) && !written.weighted) written.divided = projected_points(curve.points(), curve.dimension());
    return written;
}

/// The refined curves, a document for all of them.
void write_documents(Sink& sink, const std::vector<SettledCurve>& curves, int steps, const Context& context) {
    std::vector<Curve> fine;
    std::vector<WrittenPoints> points;
    for (const SettledCurve& loaded : curves) fine.push_back(refine(loaded.curve, steps, context.apply));
    for (std::size_t i = 0; i < fine.size(); ++i) points.push_back(written_points(fine[i], curves[i], "json"));
    std::vector<CurveDocument> documents;
    for (std::size_t i = 0; i < fine.size(); ++i)
        documents.push_back(curve_document(fine[i], points[i].view(), points[i].weighted, context));
    if (documents.size() == 1)
        write_curve_json(sink, documents.front());
    else
        write_curves_json(sink, documents);
}

/// Curves one after another, in CSV, NPY and OBJ.
class CurveWriter {
public:
    CurveWriter(Sink& sink, const std::string& format, const Context& context)
        : sink_(sink)
        , format_(format)
        , context_(context) {}

    void write_polygon(const Curve& curve, const SettledCurve& loaded) {
        const WrittenPoints written = written_points(curve, loaded, format_);
        std::vector<std::string> columns = column_names(loaded);
        if (written.weighted) columns.emplace_back("w");
        PartSink part = begin(loaded);
        if (format_ == "csv")
            write_csv(part, written.view(), {.header = columns, .threads = context_.apply.threads});
        else if (format_ == "npy")
            write_npy(sink_, written.view());
        else
            write_obj(sink_, written.view(), curve.ends(), vertices_ == 0 ? comments() : std::vector<std::string>(),
                      vertices_, context_.apply.threads);
        vertices_ += curve.size();
    }

    void write_limit_of(const Refinement& refinement, const SettledCurve& loaded, bool derivatives) {
        PartSink part = begin(loaded);
        Sink& sink = format_ == "csv" ? static_cast<Sink&>(part) : sink_;
        if (derivatives)
            write_limit_frames(sink, format_, loaded.curve, refinement, column_names(loaded), context_.apply.threads);
        else if (format_ == "obj")
            vertices_ += write_limit_obj(sink_, refinement, loaded.coordinates, vertices_, context_.apply.threads);
        else
            write_limit(sink, format_, refinement, loaded.coordinates, column_names(loaded), context_.apply.threads);
    }

private:
    PartSink begin(const SettledCurve& loaded) {
        const bool is_first = parts_++ == 0;
        return {sink_, is_first, written_break(loaded.break_text, is_first)};
    }

    [[nodiscard]] std::vector<std::string> comments() const {
        return {"internode " + generator(context_).version, context_.command_line};
    }

    Sink& sink_;
    const std::string& format_;
    const Context& context_;
    std::size_t parts_ = 0;    ///< begun
    std::size_t vertices_ = 0; ///< written, of OBJ
};

void check_format(const SubdivideOptions& options, const std::string& format, const SettledCurve& loaded) {
    const std::size_t dimension = loaded.space_dimension();
    if (format == "obj" && dimension > max_obj_dimension)
        throw failure(ExitCode::Refused,
                      fmt::format("OBJ has at most {} coordinates, the points have {}", max_obj_dimension, dimension),
                      "use CSV, JSON or NPY");
    if (options.derivatives && has_weights(loaded))
        throw failure(ExitCode::Refused, "the derivatives of curves with weights are not computed");
    if (format == "svg" && dimension == 1 && has_weights(loaded))
        throw failure(ExitCode::Refused, "a curve of one coordinate and a weight has no picture", "use CSV or JSON");
}

/// Formats that hold one curve, or curves that are alike.
void check_together(const std::vector<SettledCurve>& curves, const std::string& format, bool limit) {
    if (format == "npy") refuse_several(curves.size(), format);
    const auto columns = [limit](const SettledCurve& loaded) {
        return loaded.space_dimension() + (has_weights(loaded) && !limit ? 1 : 0);
    };
    const SettledCurve& first = curves.front();
    for (const SettledCurve& other : curves) {
        if (format == "csv") require_equal_columns(columns(first), columns(other));
        if (format == "svg") require_one_plane(first.space_dimension(), other.space_dimension());
    }
}

/// The axes that all points have.
PictureAxes picture_axes(const std::vector<SettledCurve>& curves, const SubdivideOptions& options) {
    std::size_t least = curves.front().space_dimension();
    for (const SettledCurve& loaded : curves) least = std::min(least, loaded.space_dimension());
    return chosen_axes(options.axes, least);
}

/// "degree 3", or the degrees of several curves: "degrees 2, 3".
std::string degrees_of(const std::vector<SettledCurve>& curves) {
    std::set<int> degrees;
    for (const SettledCurve& loaded : curves) degrees.insert(loaded.curve.degree());
    return fmt::format("{} {}", degrees.size() == 1 ? "degree" : "degrees", fmt::join(degrees, ", "));
}

std::string picture_title(const SubdivideOptions& options, const std::vector<SettledCurve>& curves) {
    const SettledCurve& first = curves.front();
    const std::string parts = curves.size() > 1 ? fmt::format(" ({} parts)", curves.size()) : "";
    return fmt::format("{}{} under {}, {}, {} {}", first.source, parts,
                       display_name(first.curve.system().grammar(), options.grammar), degrees_of(curves), options.steps,
                       options.steps == 1 ? "step" : "steps");
}

/// The curves after as many of the steps as can be told apart.
void write_picture(Sink& sink, const std::vector<SettledCurve>& curves, const SubdivideOptions& options,
                   const PictureAxes& axes, const Context& context) {
    const DrawnSteps drawn = drawn_steps_of(curves, options.steps);
    std::vector<PlanarCurve> planar;
    for (const SettledCurve& loaded : curves) {
        Refinement refinement(loaded.curve);
        refinement.advance(static_cast<int>(drawn.steps), context.apply);
        planar.push_back(planar_curve(loaded.curve, refinement, axes, loaded.coordinates));
    }
    write_curve_picture(
        sink, planar,
        {.title = picture_title(options, curves), .generator = generator(context), .remark = drawn_remark(drawn)});
}

std::size_t point_count(const std::vector<SettledCurve>& curves) {
    std::size_t count = 0;
    for (const SettledCurve& loaded : curves) count += loaded.curve.size();
    return count;
}

/// The curve itself, by the states of its cells.
Refinement refinement_of(const Curve& curve, int steps, const ApplyOptions& apply) {
    Refinement refinement(curve);
    refinement.advance(steps, apply);
    return refinement;
}

void write_all(CurveWriter writer, const std::vector<SettledCurve>& curves, const SubdivideOptions& options,
               const ApplyOptions& apply) {
    const int steps = static_cast<int>(options.steps);
    for (const SettledCurve& loaded : curves) {
        if (options.limit)
            writer.write_limit_of(refinement_of(loaded.curve, steps, apply), loaded, options.derivatives);
        else
            writer.write_polygon(refine(loaded.curve, steps, apply), loaded);
    }
}

} // namespace

ExitCode run(const IntervalGrammar& grammar, const LoadedText&, const SubdivideOptions& options,
             const Context& context) {
    const std::string format = settled_format(context, options.output, {"subdivide", Kind::Intervals, ""});
    require_polygon(options.polygon);
    const IntervalSystem system = load_system(grammar, options.grammar);
    const std::vector<SettledCurve> curves = load_curves(system, options.polygon);
    if (options.plan) {
        if (options.output.file != "-") throw failure(ExitCode::Usage, "--plan writes no file: leave -o out");
        print_plan(curves, options, format);
        return ExitCode::Success;
    }
    for (const SettledCurve& loaded : curves) check_format(options, format, loaded);
    check_together(curves, format, options.limit);
    const RefinementSize size = planned(curves, options);
    const PictureAxes axes = picture_axes(curves, options);
    Output output(options.output.file);
    if (context.verbose) say(context, fmt::format("{} points from {}\n", size.points, point_count(curves)));
    const int steps = static_cast<int>(options.steps);
    if (format == "svg")
        write_picture(output.sink(), curves, options, axes, context);
    else if (format == "json")
        write_documents(output.sink(), curves, steps, context);
    else
        write_all(CurveWriter(output.sink(), format, context), curves, options, context.apply);
    output.commit();
    return ExitCode::Success;
}

} // namespace internode::cli
