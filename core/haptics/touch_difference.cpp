#include "core/haptics/touch_difference.h"

#include <algorithm>
#include <cmath>

#include "core/base/numbers.h"

namespace tactum {

namespace {

/// J that the finger does on its way; the force changes evenly between two steps.
double workOf(const TouchTrace& rows, std::size_t steps) {
    double work = 0;
    for (std::size_t i = 1; i < steps; ++i)
        work -= 0.5 * (rows[i].force + rows[i - 1].force).dot(rows[i].finger - rows[i - 1].finger);
    return work;
}

double ratioOf(const TouchTrace& rows, std::size_t steps) {
    double sum = 0;
    std::size_t touching = 0;
    for (std::size_t i = 0; i < steps; ++i) {
        const double along = rows[i].tangential;
        const double into = std::sqrt(std::max(0.0, rows[i].force.squaredNorm() - along * along));
        if (into <= 0) continue;
        sum += along / into;
        ++touching;
    }
    return touching > 0 ? sum / double(touching) : 0;
}

void append(std::string& out, const Vec3& v) {
    for (const double value : {v.x(), v.y(), v.z()}) {
        out += ',';
        appendNumber(out, value);
    }
}

} // namespace

void limitForces(TouchTrace& rows, double maxForce) {
    if (!(maxForce > 0)) return;
    for (TouchRow& row : rows) {
        const double part = maxForce / row.force.norm();
        if (!(part < 1)) continue;
        row.force *= part;
        row.tangential *= part;
    }
}

TouchDifference differenceOf(const TouchTrace& a, const TouchTrace& b) {
    TouchDifference said;
    said.steps = std::min(a.size(), b.size());
    double squares = 0;
    for (std::size_t i = 0; i < said.steps; ++i) {
        const double difference = (b[i].force - a[i].force).norm();
        squares += difference * difference;
        if (difference <= said.largest) continue;
        said.largest = difference;
        said.largestAt = b[i].t;
        said.largestWhere = b[i].finger;
    }
    if (said.steps > 0) said.rms = std::sqrt(squares / double(said.steps));
    said.workA = workOf(a, said.steps), said.workB = workOf(b, said.steps);
    said.ratioA = ratioOf(a, said.steps), said.ratioB = ratioOf(b, said.steps);
    return said;
}

std::string differenceCsv(const TouchTrace& a, const TouchTrace& b) {
    std::string out = "t,finger_x,finger_y,finger_z,a_x,a_y,a_z,b_x,b_y,b_z,difference\n";
    const std::size_t steps = std::min(a.size(), b.size());
    out.reserve(steps * 220);
    for (std::size_t i = 0; i < steps; ++i) {
        appendNumber(out, a[i].t);
        append(out, a[i].finger);
        append(out, a[i].force);
        append(out, b[i].force);
        out += ',';
        appendNumber(out, (b[i].force - a[i].force).norm());
        out += '\n';
    }
    return out;
}

} // namespace tactum
