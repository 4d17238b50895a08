#include "ui/controllers/problem_controller.h"

#include "ui/document/document.h"
#include "ui/panels/problems.h"
#include "ui/view/scene_view.h"
#include "ui/widgets/notice_bar.h"

namespace tactum {

namespace {

/// From where most of some triangles show their front; zero where they look to all sides. Body frame.
Vec3 frontOf(const TriangleSoup& soup, const TriangleSet& triangles) {
    Vec3 sum = Vec3::Zero();
    double area = 0;
    for (Index t : triangles) {
        const auto& c = soup.triangles[t];
        const auto& p = soup.positions;
        const Vec3 normal = (p[c[1]] - p[c[0]]).cross(p[c[2]] - p[c[0]]);
        sum += normal;
        area += normal.norm();
    }
    constexpr double kOneSided = 0.3;
    return sum.norm() > kOneSided * area ? sum : Vec3(Vec3::Zero());
}

} // namespace

ProblemController::ProblemController(const Workbench& bench, Problems& problems)
    : QObject(&bench.window), bench_(bench) {
    connect(&problems, &Problems::placeAsked, this, &ProblemController::showPlace);
    connect(&problems, &Problems::placeGone, this, [this] { bench_.view.setMarked(nullptr, {}, {}); });
    connect(&problems, &Problems::repairProgressed, this, [this](double fraction, double secondsLeft) {
        bench_.notice.showProgress(tr("Repairing the mesh"), fraction, secondsLeft, true);
    });
    connect(&bench.notice, &NoticeBar::cancelled, &problems, &Problems::cancelRepair);
    connect(&problems, &Problems::repaired, this, [this](const QString& sentence) {
        bench_.notice.endProgress();
        bench_.notice.showNote(sentence);
    });
}

void ProblemController::showPlace(ObjectId id, const Problem& problem) {
    const SceneObject* object = bench_.document.scene().find(id);
    if (!object) return;
    const TriangleSoup& soup = *object->geometry;
    if (!isTriangleSet(problem.triangles, soup.triangles.size())) return;
    bench_.view.setMarked(object->geometry, problem.triangles, object->pose);
    bench_.view.flyTo(object->pose.apply(problem.centre), problem.radius,
                      object->pose.rotate(frontOf(soup, problem.triangles)));
}

} // namespace tactum
