// Strokes many meshes with friction, judges each step from the triangles alone, and prints the table of
// docs/physics/friction.md. See --help.
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <functional>
#include <numbers>

#include <CLI/CLI.hpp>

#include "tests/benchmarks/friction_judge.h"
#include "tests/benchmarks/strokes.h"
#include "tests/benchmarks/subjects.h"
#include "tests/benchmarks/table.h"
#include "tests/support/hand.h"

using namespace tactum;
using namespace tactum::bench;

namespace {

constexpr double kOff = 0.005;                            // of mu
constexpr double kBeside = 1e-6;                          // m
constexpr double kBallRadius = 0.1 / std::numbers::sqrt3; // the box of the ball has a diagonal of 0.2 m
constexpr double kLeastStatic = 0.4;

struct Options {
    Selection meshes;
    std::vector<double> radii{0.5, 1, 2, 5}; ///< of the proxy, mm
    std::vector<double> coefficients{0.3, 0.8};
    int strokes = 12;       ///< over each mesh
    std::size_t rows = 235; ///< of each stroke
    std::string off;        ///< file for the rows that are off
};

[[noreturn]] void fail(const std::string& sentence) {
    std::fprintf(stderr, "%s\n", sentence.c_str());
    std::exit(1);
}

struct Mesh {
    std::string name;
    std::function<Result<TriangleSoup>()> make;
};

TriangleSoup bumpyBall(int divisions, double height, double length) {
    TriangleSoup soup = *test::ball(kBallRadius, divisions);
    const double k = 2 * std::numbers::pi / length;
    for (Vec3& p : soup.positions)
        p += height * std::sin(k * p.x()) * std::sin(k * p.y()) * std::sin(k * p.z()) * p.normalized();
    return soup;
}

/// Those of the selection, and some more from formulas.
std::vector<Mesh> meshesOf(const Selection& selection) {
    std::vector<Mesh> meshes;
    for (const Subject& subject : subjectsOf(selection))
        meshes.push_back({subject.name, [subject] { return meshOf(subject); }});
    const auto add = [&](const char* name, auto make) {
        if (selection.isWanted(name)) meshes.push_back({name, make});
    };
    add("ball-320", [] { return *test::ball(kBallRadius, 2); });
    add("ball-5k", [] { return *test::ball(kBallRadius, 4); });
    add("ball-82k", [] { return *test::ball(kBallRadius, 6); });
    add("bumpy-20k", [] { return bumpyBall(5, 2e-3, 0.03); });
    add("bumpy-82k", [] { return bumpyBall(6, 2e-4, 8e-3); });
    add("egg-crate-45k", [] { return *test::eggCrate(0.07, 150, 2e-3, 0.02); });
    return meshes;
}

/// With one radius and one coefficient: over all meshes, and the ratios to mu of the present one.
struct Tally {
    double radius = 0, mu = 0; ///< radius in m
    std::size_t rows = 0, beside = 0, steady = 0, off = 0;
    double gap = 0, lowest = 1, highest = 1, firstPercentile = 1, median = 1;
    std::vector<double> ratios{};

    void add(const JudgedStep& step) {
        beside += std::abs(step.gap) > kBeside;
        gap = std::max(gap, std::abs(step.gap));
        if (step.isSteady) ratios.push_back(step.ratio / mu);
    }
    bool isOff(const JudgedStep& step) const {
        return std::abs(step.gap) > kBeside || (step.isSteady && std::abs(step.ratio / mu - 1) > kOff);
    }
    void endMesh() {
        if (ratios.empty()) return;
        std::ranges::sort(ratios);
        const auto part = [&](double p) { return ratios[std::size_t(p * double(ratios.size() - 1))]; };
        steady += ratios.size();
        off += std::size_t(std::ranges::count_if(ratios, [](double r) { return std::abs(r - 1) > kOff; }));
        lowest = std::min(lowest, part(0));
        highest = std::max(highest, part(1));
        firstPercentile = std::min(firstPercentile, part(0.01));
        if (std::abs(part(0.5) - 1) > std::abs(median - 1)) median = part(0.5);
        ratios.clear();
    }
};

/// The rows that are off, each with what it takes to find it again.
class OffRows {
public:
    explicit OffRows(const std::string& file) : out_(file) {
        out_ << "mesh,radius_mm,mu,stroke,step,ratio_to_mu,gap_um,speed_m_s,touches,triangle\n";
    }
    void add(const std::string& mesh, const Tally& of, int stroke, std::size_t step, double speed,
             const JudgedStep& row) {
        const double ratio = row.isSteady ? row.ratio / of.mu : std::nan("");
        out_ << mesh << ',' << 1e3 * of.radius << ',' << of.mu << ',' << stroke << ',' << step << ',' << ratio
             << ',' << 1e6 * row.gap << ',' << speed << ',' << row.touched.on << ',' << row.touched.triangle
             << '\n';
    }

private:
    std::ofstream out_;
};

SlideStep slideStep(const test::Hand& hand) {
    const HapticOutput& output = hand.output();
    SlideStep step{hand.finger(), output.proxy, output.contacts, output.contacts > 0};
    for (int i = 0; i < output.contacts; ++i)
        step.slips &= output.contact[std::size_t(i)].slipping;
    return step;
}

/// Along every stroke with one radius and one coefficient.
void slide(const Mesh& mesh, const test::TriangleGrid& grid, const std::vector<Stroke>& strokes,
           const std::shared_ptr<const World>& world, Tally& tally, OffRows& offRows) {
    for (std::size_t number = 0; number < strokes.size(); ++number) {
        const Stroke& stroke = strokes[number];
        test::Hand hand(world);
        FrictionJudge judge(grid, tally.radius);
        for (std::size_t i = 0; i < stroke.finger.size(); ++i) {
            hand.to(stroke.finger[i]);
            const JudgedStep step = judge.judge(slideStep(hand));
            if (i < stroke.approach) continue;
            ++tally.rows;
            if (hand.output().contacts == 0) continue;
            tally.add(step);
            if (tally.isOff(step)) offRows.add(mesh.name, tally, int(number), i, stroke.speed, step);
        }
    }
    tally.endMesh();
}

void measure(const Mesh& mesh, const Options& options, std::vector<Tally>& all, OffRows& offRows) {
    auto made = mesh.make();
    if (!made) fail(made.error().text);
    const auto soup = std::make_shared<const TriangleSoup>(std::move(*made));
    const test::TriangleGrid grid(*soup, 2e-3);
    std::vector<Stroke> strokes;
    for (int number = 0; number < options.strokes; ++number)
        strokes.push_back(strokeOver(grid, number, options.rows));
    for (Tally& tally : all) {
        const Material material = test::rough(std::max(tally.mu, kLeastStatic), tally.mu);
        slide(mesh, grid, strokes, test::worldOf(soup, material, tally.radius), tally, offRows);
    }
}

std::string tableOf(const std::vector<Tally>& all) {
    std::string table =
        head({"radius mm", "mu", "rows", "over 1 um beside it", "worst gap um", "steady rows",
              "over 0.5 % off", "ratio / mu: lowest", "worst first percentile", "worst median", "highest"},
             0);
    for (const Tally& f : all)
        table += line({text("%g", 1e3 * f.radius), text("%g", f.mu), grouped(f.rows), grouped(f.beside),
                       text("%.4f", 1e6 * f.gap), grouped(f.steady), grouped(f.off), text("%.3f", f.lowest),
                       text("%.3f", f.firstPercentile), text("%.3f", f.median), text("%.3f", f.highest)});
    return table;
}

} // namespace

int main(int argc, char** argv) {
    Options options;
    options.meshes.fingers = false;
    options.meshes.largest = 110000;
    CLI::App app("Slides over a folder of meshes and over generated ones, judges friction from the triangles "
                 "alone, and prints Markdown");
    options.meshes.addOptions(app);
    app.add_option("--radius", options.radii, "of the proxy, mm; several may be given")
        ->check(CLI::Range(0.01, 5.5));
    app.add_option("--mu", options.coefficients, "of dynamic friction; several may be given")
        ->check(CLI::Range(0.01, 2.0));
    app.add_option("--strokes", options.strokes, "over each mesh")->check(CLI::Range(1, 1000000));
    app.add_option("--length", options.rows, "of a stroke, rows")->check(CLI::Range(1, 1000000));
    app.add_option("--rows", options.off, "also write the rows that are off there, as CSV");
    CLI11_PARSE(app, argc, argv);

    std::vector<Tally> all;
    for (double radius : options.radii)
        for (double mu : options.coefficients)
            all.push_back({.radius = 1e-3 * radius, .mu = mu});
    OffRows offRows(options.off);
    for (const Mesh& mesh : meshesOf(options.meshes)) {
        std::fprintf(stderr, "%s\n", mesh.name.c_str());
        measure(mesh, options, all, offRows);
    }
    std::printf("%s\n\n%s", circumstances().c_str(), tableOf(all).c_str());
}
