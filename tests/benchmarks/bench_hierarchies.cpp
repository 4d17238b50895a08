// Sphere tree against box tree: the sweeps of a replay, recorded once and swept through both.
// Prints Markdown. See --help.

#include <chrono>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <numeric>

#include <CLI/CLI.hpp>

#include "core/collision/sweep_memory.h"
#include "core/haptics/compile.h"
#include "core/haptics/replay.h"
#include "tests/benchmarks/box_surroundings.h"
#include "tests/benchmarks/descent.h"
#include "tests/benchmarks/one_core.h"
#include "tests/benchmarks/subjects.h"
#include "tests/benchmarks/sweep_record.h"
#include "tests/benchmarks/table.h"

using namespace tactum;
using namespace tactum::bench;

namespace {

using Clock = std::chrono::steady_clock;
using Sweeps = std::vector<RecordedSweep>;

constexpr int kRepetitions = 5;
constexpr std::size_t kStretch = 100;

struct Column {
    const char* name = "";
    double buildSeconds = 0, bytes = 0;
    double nanoseconds = 0; ///< a sweep, of the fastest repetition
    Work work;              ///< of all sweeps; zero where it is not counted
};

// A hierarchy as the benchmark sees it: sweeps by its own descent, each from where the last one hit.
template <class Node, class Bound, bool kCounted> class Sweeper {
public:
    Sweeper(std::span<const Node> nodes, std::span<const SphereTree::Leaf> leaves, const TriangleSoup& soup)
        : nodes_(nodes), leaves_(leaves), soup_(soup) {}
    SweepHit operator()(const RecordedSweep& s) {
        const SweepHit hit = Descent<Node, Bound, kCounted>(nodes_, leaves_, soup_, s.path, s.excluded, work)
                                 .run(hint_, nodes_.first(1));
        if (hit.t <= 1) hint_ = hit.leaf;
        return hit;
    }
    Work work;

private:
    std::span<const Node> nodes_;
    std::span<const SphereTree::Leaf> leaves_;
    const TriangleSoup& soup_;
    Index hint_ = 0;
};

std::vector<double> contactsOf(const Sweeps& sweeps, auto&& sweeper) {
    std::vector<double> contacts;
    for (const RecordedSweep& s : sweeps)
        contacts.push_back(sweeper(s).t);
    return contacts;
}

// A sweep's mean time: of every stretch of sweeps the fastest repetition, so that what the machine did
// besides drops out.
double nanosecondsOf(const Sweeps& sweeps, auto&& makeSweeper) {
    const OneCore pinned;
    std::vector<double> fastest(sweeps.size() / kStretch + 1, 1e300);
    for (int i = 0; i < kRepetitions; ++i) {
        auto sweeper = makeSweeper();
        for (std::size_t k = 0; k < fastest.size(); ++k) {
            double sum = 0;
            const auto begin = Clock::now();
            for (std::size_t s = k * kStretch; s < std::min(sweeps.size(), (k + 1) * kStretch); ++s)
                sum += sweeper(sweeps[s]).t;
            const std::chrono::duration<double, std::nano> time = Clock::now() - begin;
            // The sum keeps the compiler from leaving the sweeps out.
            if (std::isfinite(sum)) fastest[k] = std::min(fastest[k], time.count());
        }
    }
    return std::accumulate(fastest.begin(), fastest.end(), 0.0) / double(sweeps.size());
}

// Both hierarchies must find the same contacts, or their times say nothing.
void expectEqual(const std::vector<double>& found, const std::vector<double>& expected, const char* name) {
    for (std::size_t i = 0; i < found.size(); ++i)
        if (std::abs(found[i] - expected[i]) > 1e-9) {
            std::cerr << name << " finds " << found[i] << " instead of " << expected[i] << " in sweep " << i
                      << ": a mistake in one of the hierarchies\n";
            std::exit(1);
        }
}

class Comparison {
public:
    Comparison(const CollisionMesh& mesh, Sweeps sweeps)
        : mesh_(mesh), soup_(*mesh.soup), sweeps_(std::move(sweeps)) {}

    std::vector<Column> run() {
        expected_ = contactsOf(
            sweeps_, [&](const RecordedSweep& s) { return mesh_.tree.sweep(soup_, s.path, s.excluded); });
        std::vector<Column> columns;
        auto begin = Clock::now();
        columns.push_back(over<PruningPath>("spheres, from the root", SphereTree(soup_), begin));
        begin = Clock::now();
        columns.push_back(
            over<BoxPath>("boxes, from the root", BoxTree(soup_, BoxTree::Division::Midpoint), begin));
        begin = Clock::now();
        const BoxTree boxes(soup_, BoxTree::Division::SurfaceArea);
        columns.push_back(over<BoxPath>("boxes by surface area, from the root", boxes, begin));
        columns.push_back(coherent("spheres, as the proxy sweeps", [&] {
            return [&, memory = SweepMemory{}](const RecordedSweep& s) mutable {
                return sweepFrom(memory, mesh_, s.path, s.excluded);
            };
        }));
        columns.push_back(coherent("boxes by surface area, the same way", [&] {
            return [&, memory = CoherentBoxes(boxes, soup_)](const RecordedSweep& s) mutable {
                return memory.sweep(s.path, s.excluded);
            };
        }));
        return columns;
    }

private:
    Column coherent(const char* name, auto&& makeSweeper) const {
        Column column;
        column.name = name;
        expectEqual(contactsOf(sweeps_, makeSweeper()), expected_, name);
        column.nanoseconds = nanosecondsOf(sweeps_, makeSweeper);
        return column;
    }

    template <class Bound, class Tree>
    Column over(const char* name, const Tree& tree, Clock::time_point begin) const {
        using Node = typename std::decay_t<decltype(tree.nodes())>::value_type;
        Column column;
        column.name = name;
        column.buildSeconds = std::chrono::duration<double>(Clock::now() - begin).count();
        column.bytes = double(tree.bytes());
        Sweeper<Node, Bound, true> counting(tree.nodes(), tree.leaves(), soup_);
        expectEqual(contactsOf(sweeps_, counting), expected_, name);
        column.work = counting.work;
        column.nanoseconds = nanosecondsOf(
            sweeps_, [&] { return Sweeper<Node, Bound, false>(tree.nodes(), tree.leaves(), soup_); });
        return column;
    }

    const CollisionMesh& mesh_;
    const TriangleSoup& soup_;
    Sweeps sweeps_;
    std::vector<double> expected_;
};

Sweeps recordedOver(const World& world, const std::vector<FingerPoint>& finger) {
    Sweeps sweeps;
    sweepRecord = &sweeps;
    replay(world, finger);
    sweepRecord = nullptr;
    return sweeps;
}

void compare(const Subject& subject) {
    const auto opened = openQuickly(subject);
    if (!opened) throw std::runtime_error(opened.error().text);
    const auto world = compile(opened->scene).value();
    // Sweeps of several meshes could not be told apart.
    if (world->obstacles.size() != 1)
        throw std::runtime_error(subject.name + " is not one object; leave it out");
    Sweeps sweeps = recordedOver(*world, opened->finger);
    const std::size_t count = sweeps.size();
    const std::size_t triangles = world->obstacles[0].mesh->soup->triangles.size();
    for (const Column& c : Comparison(*world->obstacles[0].mesh, std::move(sweeps)).run()) {
        std::printf("| %s | %s | %zu | %.0f |", subject.name.c_str(), c.name, count, c.nanoseconds);
        if (c.bytes > 0)
            std::printf(" %.3f | %.0f |", c.buildSeconds, c.bytes / double(triangles));
        else
            std::printf(" | |");
        for (const std::size_t sum : {c.work.nodes, c.work.leaves, c.work.exact}) {
            if (c.work.leaves > 0)
                std::printf(" %.2f |", double(sum) / double(count));
            else
                std::printf(" |");
        }
        std::printf("\n");
    }
}

} // namespace

int main(int argc, char** argv) {
    Selection selection;
    CLI::App app(
        "Sweeps what a replay swept through the sphere tree and through box trees, and prints Markdown");
    selection.addOptions(app);
    app.allow_extras(); // what bench_haptics is asked besides
    CLI11_PARSE(app, argc, argv);
    std::printf("%s\n\n", circumstances().c_str());
    std::printf(
        "| mesh | hierarchy | sweeps | ns a sweep | build s | bytes/tri | nodes | leaves | exact tests |\n"
        "| :-- | :-- | --: | --: | --: | --: | --: | --: | --: |\n");
    try {
        for (const Subject& subject : subjectsOf(selection))
            compare(subject);
    } catch (const std::runtime_error& error) {
        std::cerr << error.what() << "\n";
        return 1;
    }
}
