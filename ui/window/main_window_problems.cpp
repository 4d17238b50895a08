// The window and its list of problems: where they are, and what repairing them takes.
#include "ui/panels/problems.h"
#include "ui/view/scene_view.h"
#include "ui/widgets/notice_bar.h"
#include "ui/window/main_window.h"

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

void MainWindow::connectProblems() {
    Problems* problems = docks_.problems;
    connect(problems, &Problems::placeAsked, this, &MainWindow::showPlace);
    connect(problems, &Problems::placeGone, this, [this] { view_->setMarked(nullptr, {}, {}); });
    connect(problems, &Problems::repairProgressed, this, [this](double fraction, double secondsLeft) {
        notice_->showProgress(tr("Repairing the mesh"), fraction, secondsLeft, true);
    });
    connect(notice_, &NoticeBar::cancelled, problems, &Problems::cancelRepair);
    connect(problems, &Problems::repaired, this, [this](const QString& sentence) {
        notice_->endProgress();
        notice_->showNote(sentence);
    });
}

void MainWindow::showPlace(ObjectId id, const Problem& problem) {
    const SceneObject* object = document_.scene().find(id);
    if (!object) return;
    const TriangleSoup& soup = *object->geometry;
    if (!isTriangleSet(problem.triangles, soup.triangles.size())) return;
    view_->setMarked(object->geometry, problem.triangles, object->pose);
    view_->flyTo(object->pose.apply(problem.centre), problem.radius,
                 object->pose.rotate(frontOf(soup, problem.triangles)));
}

} // namespace tactum
