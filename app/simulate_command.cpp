#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <numeric>

#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/results.h"
#include "app/simulated_forces.h"
#include "app/streams.h"
#include "core/base/numbers.h"
#include "core/dynamics/dynamics.h"
#include "core/dynamics/mechanism_build.h"

namespace tactum {

namespace {

/// Rows and steps that a person can mean: a row is some 200 bytes.
constexpr double kMostRows = 1e7, kMostSteps = 1e9;

/// In quotes where a comma or a quote is in it.
std::string csvField(const std::string& text) {
    if (text.find_first_of(",\"\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text)
        quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + '"';
}

void appendRow(std::string& csv, double t, const std::string& name, const BodyState& body) {
    const auto number = [&](double value) {
        csv += ',';
        appendNumber(csv, value == 0 ? 0.0 : value); // no minus zero
    };
    appendNumber(csv, t);
    csv += ',';
    csv += csvField(name);
    for (const double c : body.centre)
        number(c);
    const Quat& q = body.pose.rotation;
    for (const double c : {q.w(), q.x(), q.y(), q.z()})
        number(c);
    for (const Vec3& v : {body.velocity, body.angularVelocity})
        for (const double c : v)
            number(c);
    number(body.kinetic);
    number(body.potential);
    csv += '\n';
}

nlohmann::ordered_json timesOf(std::vector<std::int64_t> ns) {
    nlohmann::ordered_json json;
    if (ns.empty()) ns.push_back(0);
    std::ranges::sort(ns);
    const auto quantile = [&](double q) {
        return ns[std::min(ns.size() - 1, std::size_t(q * double(ns.size())))];
    };
    json["mean"] = double(std::accumulate(ns.begin(), ns.end(), std::int64_t(0))) / double(ns.size());
    json["median"] = quantile(0.5);
    json["p99"] = quantile(0.99);
    json["p999"] = quantile(0.999);
    json["max"] = ns.back();
    return json;
}

std::int64_t nanoseconds() {
    return std::chrono::duration_cast<std::chrono::nanoseconds>(
               std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

} // namespace

Result<int> runSimulate(const SimulateOptions& options) {
    auto loaded = importGiven(options.scene);
    if (!loaded) return tl::unexpected(loaded.error());
    for (const Finding& finding : loaded->findings)
        if (finding.severity != Finding::Severity::Note) std::cerr << lineOf(finding) << '\n';
    const Mechanics& mechanics = loaded->scene.mechanics;
    const Vec3 gravity = options.gravity.value_or(mechanics.gravity);
    if (mechanics.bodies.empty())
        return inputError(options.scene.string() + ": has no body that moves by forces; give a node a motion "
                                                   "(KHR_physics_rigid_bodies)");
    auto compiled =
        compileMechanism(mechanics.bodies, mechanics.joints, mechanics.colliders, mechanics.airDensity);
    if (!compiled) return tl::unexpected(compiled.error());
    const auto mechanism = std::make_shared<const Mechanism>(std::move(*compiled));
    Dynamics dynamics(mechanism);
    DynamicState state = dynamics.startState();
    std::vector<BodyState> bodies(mechanism->bodies.size());
    const std::vector<std::string> names = tableNames(mechanism->bodies);
    std::string csv = "t,body,x,y,z,qw,qx,qy,qz,vx,vy,vz,wx,wy,wz,kinetic,potential\n";
    double first = 0, most = 0, liveliest = 0, gap = 0;
    const auto writeRows = [&](double t) {
        dynamics.describe(state, gravity, bodies);
        double energy = dynamics.springEnergy(state), kinetic = 0;
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            appendRow(csv, t, names[i], bodies[i]);
            kinetic += bodies[i].kinetic;
            energy += bodies[i].kinetic + bodies[i].potential;
        }
        if (t == 0) first = energy;
        most = std::max(most, std::abs(energy - first));
        liveliest = std::max(liveliest, kinetic);
        if (!mechanism->loops.empty()) gap = std::max(gap, dynamics.loopGap(state));
    };
    // Output steps of whole steps: a step is never longer than asked for.
    const auto perOutput =
        std::max<long long>(1, std::llround(std::ceil(options.every * options.rate - 1e-9)));
    const auto outputs = std::llround(std::floor(options.seconds / options.every + 1e-9));
    if (double(outputs) * double(bodies.size()) > kMostRows ||
        double(outputs) * double(perOutput) > kMostSteps)
        return inputError("--seconds: that would be more than 1e7 rows or 1e9 steps; ask for less time, a "
                          "longer --every or a lower --rate");
    if (outputs == 0)
        return inputError("--seconds: is shorter than --every, and nothing would move; ask for more");
    for (const PushOption& push : options.pushes)
        if (push.to <= 0 || push.from >= double(outputs) * options.every)
            return inputError("--push: is over before the first step or begins after the last; move it, or "
                              "ask for more --seconds");
    const double dt = options.every / double(perOutput);
    Pushes pushes(options.pushes, *mechanism, mechanics);
    KeyedBodies keyed(loaded->scene, *mechanism);
    keyed.start(state);
    double lostAt = -1; // s
    std::vector<std::int64_t> times;
    times.reserve(std::size_t(outputs * perOutput));
    writeRows(0);
    for (long long output = 1; output <= outputs; ++output) {
        for (long long i = 0; i < perOutput; ++i) {
            const double time = (double(output - 1) + double(i) / double(perOutput)) * options.every;
            for (double gone = 0; gone < dt;) {
                const double part = pushes.untilChange(time + gone, dt - gone);
                const auto& forces = pushes.at(time + gone, part, dynamics, state);
                keyed.lead(time + gone, part, state);
                const std::int64_t begin = nanoseconds();
                dynamics.step(state, gravity, forces, part);
                times.push_back(nanoseconds() - begin);
                if (dynamics.stoodStill() > 0 && lostAt < 0) lostAt = time + gone;
                gone = part == dt - gone ? dt : gone + part;
            }
        }
        writeRows(double(output) * options.every);
    }
    if (pushes.missed() > 0)
        return inputError("--push: there is no body that could be pushed; give one a mass");
    for (const std::string& line : pushes.strays())
        std::cerr << "tactum: " << line << '\n';
    if (options.out)
        if (const auto written = writeFile(*options.out, csv); !written)
            return tl::unexpected(written.error());
    nlohmann::ordered_json summary;
    summary["bodies"] = mechanism->bodies.size();
    summary["joints"] = mechanics.joints.size();
    summary["loops"] = mechanism->loopJoints;
    summary["steps"] = times.size();
    summary["step_s"] = dt;
    summary["step_ns"] = timesOf(times);
    // Of the most that was in motion; of what rests only the joules mean anything.
    summary["energy_drift"] = liveliest > 1e-9 ? most / liveliest : 0.0;
    summary["energy_drift_j"] = most;
    summary["largest_loop_gap"] = gap;
    summary["stood_still"] = dynamics.stoodStill();
    summary["contacts_left_out"] = dynamics.contactsLeftOut();
    const std::string text = summary.dump() + '\n';
    if (options.summary)
        if (const auto written = writeFile(*options.summary, text); !written)
            return tl::unexpected(written.error());
    if (!isDash(options.out) && !isDash(options.summary))
        if (const auto written = writeFile("-", text); !written) return tl::unexpected(written.error());
    if (lostAt >= 0) {
        std::string when;
        appendNumber(when, lostAt);
        return inputError("at " + when +
                          " s speeds went beyond what numbers hold, and everything stood still; ask for a "
                          "higher --rate, or damp light bodies less");
    }
    return 0;
}

} // namespace tactum
