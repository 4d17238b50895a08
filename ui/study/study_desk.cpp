#include "ui/study/study_desk.h"

#include <algorithm>

#include "core/base/text.h"
#include "core/scene/selection_sets.h"
#include "ui/document/document.h"

namespace tactum {

namespace {

Study emptyStudy() {
    Study study;
    study.design.name = StudyDesk::tr("Study").toStdString();
    return study;
}

std::filesystem::path studyPath(const QString& file) {
    return std::filesystem::path(file.toStdU16String());
}

} // namespace

StudyDesk::StudyDesk(Document& document, QObject* parent)
    : QObject(parent), document_(document), study_(emptyStudy()) {}

void StudyDesk::begin() {
    study_ = emptyStudy();
    file_.clear();
    modified_ = false;
    emit changed();
}

void StudyDesk::edited() {
    modified_ = true;
    ++edits_;
    emit changed();
}

void StudyDesk::setDesign(StudyDesign design) {
    design.conditions = study_.design.conditions; // they belong to the scenes
    if (design == study_.design) return;
    study_.design = std::move(design);
    edited();
}

bool StudyDesk::isFree(const QString& name) const {
    return !name.trimmed().isEmpty() && std::size_t(name.size()) < kLongestName &&
           std::ranges::find(study_.design.conditions, name.trimmed().toStdString()) ==
               study_.design.conditions.end();
}

bool StudyDesk::keep(const QString& name) {
    if (!isFree(name) || study_.conditions.size() >= std::size_t(kMaxConditions)) return false;
    study_.design.conditions.push_back(name.trimmed().toStdString());
    study_.conditions.push_back(document_.scene());
    edited();
    return true;
}

void StudyDesk::replace(int condition) {
    study_.conditions.at(std::size_t(condition)) = document_.scene();
    edited();
}

bool StudyDesk::rename(int condition, const QString& name) {
    if (!isFree(name)) return false;
    study_.design.conditions.at(std::size_t(condition)) = name.trimmed().toStdString();
    edited();
    return true;
}

void StudyDesk::remove(int condition) {
    study_.conditions.erase(study_.conditions.begin() + condition);
    study_.design.conditions.erase(study_.design.conditions.begin() + condition);
    edited();
}

void StudyDesk::show(int condition) {
    const auto index = std::size_t(condition);
    Scene shown = study_.conditions.at(index);
    keepSets(document_.scene(), shown);
    document_.replaceScene(
        tr("Show state %1").arg(QString::fromStdString(study_.design.conditions.at(index))), shown);
}

void StudyDesk::open(const QString& file) {
    job_.start([this, file](const Progress& progress) -> BackgroundJob::Delivery {
        auto read = readStudy(studyPath(file), progress);
        if (!read) return [this, text = read.error().text] { emit failed(QString::fromStdString(text)); };
        return [this, file, study = std::move(*read)] {
            study_ = study;
            file_ = file;
            modified_ = false;
            emit changed();
        };
    });
}

void StudyDesk::save(const QString& file, std::function<void()> after) {
    job_.start([this, file, after = std::move(after), study = study_,
                edits = edits_](const Progress& progress) -> BackgroundJob::Delivery {
        const auto written = writeStudy(study, studyPath(file), progress);
        if (!written)
            return [this, text = written.error().text] { emit failed(QString::fromStdString(text)); };
        return [this, file, after, edits] {
            file_ = file;
            if (edits == edits_) modified_ = false; // else it was edited meanwhile
            emit changed();
            if (after) after();
        };
    });
}

} // namespace tactum
