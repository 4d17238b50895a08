// Studies as files: everything comes back, and hostile files are refused in a line.
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "core/archive/sha256.h"
#include "core/archive/zip_archive.h"
#include "core/base/atomic_file.h"
#include "core/files/gltf/gltf_file.h"
#include "core/study/stimulus.h"
#include "core/study/study_file.h"
#include "tests/core/study/simple_designs.h"
#include "tests/support/compare.h"
#include "tests/support/soups.h"
#include "tests/support/test_program.h"

namespace test_study_file {

using namespace tactum;
using namespace tactum::test;

namespace {

StudyDesign richDesign() {
    StudyDesign design = staircaseOf(3);
    design.conditions = {"soft \"lid\"", "\xC3\xA4"};
    design.procedure = Procedure::Pairs;
    design.order = StudyOrder::AsListed;
    design.instructions = "Two lines,\nand \"quotes\"";
    design.repeats = 12;
    design.seed = 18446744073709551615u;
    design.prompt = "Stiffer?";
    design.staircase.surface = "lid";
    design.staircase.object = "box";
    design.staircase.parameter = "layers[1].mask.size";
    design.staircase.ratio = true;
    design.staircase.smallest = 0.125;
    design.staircase.compares = false;
    design.questions = {{StudyQuestion::Kind::Rating, "Sure?", "no", "yes", 5, {}},
                        {StudyQuestion::Kind::Choice, "Hand?", {}, {}, 7, {"left", "right"}},
                        {StudyQuestion::Kind::Text, "Why?", {}, {}, 7, {}},
                        {StudyQuestion::Kind::Magnitude, "How hard?", {}, {}, 7, {}}};
    design.stimulusSeconds = 2.5;
    design.pauseSeconds = 0.1;
    design.again = false;
    design.forcesOffBetween = true;
    design.view = StudyView::Hidden;
    design.touchEvery = 10;
    return design;
}

Scene plate(double stiffness) {
    Scene scene;
    SceneObject object;
    object.name = "plate";
    object.geometry = SoupBuilder().triangle({0, 0, 0}, {1, 0, 0}, {0, 0, 1}).build();
    object.surfaces.resize(1);
    object.surfaces[0].name = "top";
    object.surfaces[0].material.stiffness = stiffness;
    scene.add(object);
    return scene;
}

std::string contentOf(const std::filesystem::path& path) {
    QFile file(QString::fromStdString(path.string()));
    return file.open(QIODevice::ReadOnly) ? file.readAll().toStdString() : std::string();
}

} // namespace

class TestStudyFile : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;
    std::filesystem::path file(const char* name) const {
        return std::filesystem::path(folder_.filePath(QString::fromLatin1(name)).toStdString());
    }

private slots:
    void everyMemberComesBack();
    void whatIsNotThereIsAsAtFirst();
    void anOlderFileKeepsItsMeaning();
    void conditionsComeBackAsScenes();
    void theSameStudyIsTheSameFile();
    void badDesignsAreOneLine_data();
    void badDesignsAreOneLine();
    void badFilesAreOneLine();
    void cutFilesAreOneLine();
};

void TestStudyFile::everyMemberComesBack() {
    const StudyDesign design = richDesign();
    const auto read = parseDesign(designText(design), "a");
    VERIFY_RESULT(read);
    QVERIFY(*read == design);
    QCOMPARE(designText(*read), designText(design));
    StudyDesign plain;
    plain.name = "plain";
    QVERIFY(*parseDesign(designText(plain), "a") == plain);
    plain.name = "Gef\u00fchl"; // which a person reads in the file as well
    COMPARE_CONTAINS(designText(plain), plain.name);
}

void TestStudyFile::whatIsNotThereIsAsAtFirst() {
    const auto read = parseDesign(R"({"tactumStudy":"1.7","name":"n","later":{"x":[1]}})", "a");
    VERIFY_RESULT(read);
    StudyDesign expected;
    expected.name = "n";
    QVERIFY(*read == expected);
}

/// A study from before paths and objects bends what it did.
void TestStudyFile::anOlderFileKeepsItsMeaning() {
    const auto read = parseDesign(
        R"({"tactumStudy":"1.0","name":"n","conditions":["a"],"procedure":"staircase",)"
        R"("staircase":{"surface":"top","parameter":"static-friction","reference":0.3,"start":0.2,"largest":0.4}})",
        "a");
    VERIFY_RESULT(read);
    VERIFY_RESULT(check(*read));
    Scene scene = plate(100);
    const Scene bent = sceneOf(scene, read->staircase, {0, 0.5});
    scene.objects[0].surfaces[0].material.staticFriction = 0.5;
    QVERIFY(bent == scene);
}

void TestStudyFile::conditionsComeBackAsScenes() {
    const auto path = file("rich.tactum-study");
    VERIFY_RESULT(writeStudy({richDesign(), {plate(100), plate(900)}}, path));
    const auto read = readStudy(path);
    VERIFY_RESULT(read);
    QVERIFY(read->design == richDesign());
    QCOMPARE(read->conditions.size(), std::size_t(2));
    QCOMPARE(read->conditions[0].objects[0].surfaces[0].material.stiffness, 100.0);
    QCOMPARE(read->conditions[1].objects[0].surfaces[0].material.stiffness, 900.0);
    QCOMPARE(read->conditions[1].objects[0].surfaces[0].name, std::string("top"));
    QCOMPARE(read->conditions[0].objects[0].geometry, read->conditions[1].objects[0].geometry); // one mesh
}

void TestStudyFile::theSameStudyIsTheSameFile() {
    const auto a = file("a.tactum-study"), b = file("b.tactum-study");
    VERIFY_RESULT(writeStudy({richDesign(), {plate(100), plate(900)}}, a));
    const auto read = readStudy(a);
    VERIFY_RESULT(read);
    VERIFY_RESULT(writeStudy(*read, b));
    QCOMPARE(fingerprintOf(a).size(), std::size_t(64));
    QCOMPARE(fingerprintOf(a), fingerprintOf(b));
    VERIFY_RESULT(writeStudy({richDesign(), {plate(100), plate(901)}}, b));
    QVERIFY(fingerprintOf(a) != fingerprintOf(b));
    QCOMPARE(fingerprintOf(file("none")), std::string());
}

void TestStudyFile::badDesignsAreOneLine_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("says");
    const auto row = [](const char* text, const char* says) {
        QTest::newRow(says) << QByteArray(text) << QString::fromLatin1(says);
    };
    row("", "");
    row("[]", "");
    row("{}", "is no study");
    row(R"({"tactumStudy":1})", "is no study:");
    row(R"({"tactumStudy":"2.0"})", "get a newer Tactum");
    row(R"({"tactumStudy":"1.0","name":7})", "name is not a text");
    row(R"({"tactumStudy":"1.0","repeats":1.5})", "repeats is not a whole number");
    row(R"({"tactumStudy":"1.0","repeats":99999999999999999999})", "repeats is not a whole number;");
    row(R"({"tactumStudy":"1.0","repeats":-9223372036854775808})", "repeats is not a whole");
    row(R"({"tactumStudy":"1.0","seed":-1})", "seed is not a whole number");
    row(R"({"tactumStudy":"1.0","again":"yes"})", "again is not true or false");
    row(R"({"tactumStudy":"1.0","procedure":"abc"})", "take one of list, pairs, abx, staircase");
    row(R"({"tactumStudy":"1.0","conditions":"a"})", "conditions is not a list");
    row(R"({"tactumStudy":"1.0","conditions":[1]})", "conditions is not a list of texts");
    row(R"({"tactumStudy":"1.0","staircase":[]})", "staircase. is no object");
    row(R"({"tactumStudy":"1.0","staircase":{"steps":["a"]}})", "staircase.steps is not a list of numbers");
    row(R"({"tactumStudy":"1.0","staircase":{"start":1e999}})", "");
    row(R"({"tactumStudy":"1.0","questions":{}})", "questions is not a list");
    row(R"({"tactumStudy":"1.0","questions":[1]})", "questions[0]. is no object");
    row(R"({"tactumStudy":"1.0","pauseSeconds":"1"})", "pauseSeconds is not a number");
}

void TestStudyFile::badDesignsAreOneLine() {
    QFETCH(QByteArray, text);
    QFETCH(QString, says);
    const std::string error = refusal(parseDesign(text.toStdString(), "a.tactum-study"));
    COMPARE_BEGINS(error, "a.tactum-study");
    COMPARE_CONTAINS(QString::fromStdString(error), says);
}

void TestStudyFile::badFilesAreOneLine() {
    const auto path = file("bad.tactum-study");
    const std::string design = designText(designOf(Procedure::Pairs, {"a", "b"}));
    const std::vector<std::vector<ZipEntry>> bad{
        {{"other.json", design}},
        {{"study.json", design}, {"condition-1.glb", "glTF"}},
        {{"study.json", design}, {"condition-1.glb", "no scene"}, {"condition-2.glb", ""}},
        {{"study.json", std::string(100000, '[')}}};
    for (const auto& entries : bad) {
        VERIFY_RESULT(writeFileAtomically(path, writeZip(entries), 0));
        COMPARE_CONTAINS(refusal(readStudy(path)), "bad.tactum-study");
    }
    VERIFY_RESULT(writeFileAtomically(path, "PK\3\4 no zip", 0));
    COMPARE_CONTAINS(refusal(readStudy(path)), "bad.tactum-study");
    COMPARE_CONTAINS(refusal(readStudy(file("none.tactum-study"))), "none.tactum-study");
}

void TestStudyFile::cutFilesAreOneLine() {
    const auto path = file("whole.tactum-study"), cut = file("cut.tactum-study");
    VERIFY_RESULT(writeStudy({designOf(Procedure::List, {"a"}), {plate(100)}}, path));
    const std::string bytes = contentOf(path);
    for (std::size_t length = 0; length < bytes.size(); length += 97) {
        VERIFY_RESULT(writeFileAtomically(cut, bytes.substr(0, length), 0));
        COMPARE_CONTAINS(refusal(readStudy(cut)), "cut.tactum-study");
    }
}

} // namespace test_study_file

using test_study_file::TestStudyFile;
TACTUM_TEST(TestStudyFile)
#include "test_study_file.moc"
