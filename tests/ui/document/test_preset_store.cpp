// The presets that there are: files of one's own that come, go and change, beside those of the program. Wrong
// itself if the folder were the person's: each run has its own.
#include <QDir>
#include <QFile>
#include <QSignalSpy>
#include <QTest>

#include "core/presets/preset_file.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"
#include "tests/support/waiting.h"
#include "tests/ui/cube_file.h"
#include "tests/ui/own_folders.h"
#include "ui/document/preset_store.h"

namespace test_preset_store {

using namespace tactum;
using namespace tactum::test;

namespace {

Preset presetOf(const char* name, const char* category = "", std::optional<double> stiffness = 400) {
    Preset preset;
    preset.name = name;
    preset.category = category;
    preset.values[0] = stiffness;
    return preset;
}

/// Of one's own, "Category/Name" in the order of the store.
QString ownOf(const PresetStore& store) {
    QStringList names;
    for (const StoredPreset& each : store.presets())
        if (each.own) names << each.category() + u'/' + each.name();
    return names.join(u' ');
}

} // namespace

class TestPresetStore : public QObject {
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> data_;

private slots:
    void init() {
        data_ = std::make_unique<QTemporaryDir>();
        useFoldersIn(data_->path());
    }

    void ownOnesComeFirst() {
        PresetStore store;
        QVERIFY(store.loading());
        QVERIFY(waitFor([&] { return !store.loading(); }));
        const std::size_t shipped = store.presets().size();
        QCOMPARE_GT(shipped, 10u);
        QCOMPARE(shipped, PresetStore::readShipped().size());
        QCOMPARE(PresetStore::readOwn().size(), 0u);
        for (const auto& [name, category] : {std::pair("b", "2"), {"a", "2"}, {"c", "1"}}) {
            const QString file = store.add(presetOf(name, category));
            QVERIFY(file.startsWith(PresetStore::folder()));
            QVERIFY(waitFor([&] { return !store.loading() && store.find(file); }));
        }
        QCOMPARE(ownOf(store), "1/c 2/a 2/b");
        QCOMPARE(store.presets().size(), shipped + 3);
        for (std::size_t i = 0; i < store.presets().size(); ++i) {
            const StoredPreset& each = store.presets()[i];
            QCOMPARE(each.own, i < 3);
            QCOMPARE(each.picture.size(), QSize(80, 80));
            QCOMPARE(each.text.toStdString(), presetText(each.preset));
            QVERIFY(store.find(each.file) == &each);
        }
        QVERIFY(!store.find(QStringLiteral("/none.json")));
        QCOMPARE(PresetStore::readOwn().size(), 3u);
        QCOMPARE(PresetStore::readAll().size(), shipped + 3);
        QCOMPARE(PresetStore::readAll().front().name, PresetStore::readOwn().front().name);
    }

    /// The same name gets a file of its own.
    void filesHaveNamesThatAreFree() {
        PresetStore store;
        QStringList files;
        for (int i = 0; i < 3; ++i)
            files << QFileInfo(store.add(presetOf("My Wood"))).fileName();
        QCOMPARE(files.join(u' ').replace(QString::fromUtf8(kPresetEnding), QStringLiteral("*")),
                 "my-wood.* my-wood-2.* my-wood-3.*");
    }

    void theyAreRenamed() {
        PresetStore store;
        QSignalSpy changed(&store, &PresetStore::changed), failed(&store, &PresetStore::failed);
        const QString file = store.add(presetOf("a"));
        QVERIFY(waitFor([&] { return store.find(file); }));
        store.rename(*store.find(file), QStringLiteral("  b "));
        QVERIFY(waitFor([&] { return ownOf(store) == QStringLiteral("/b"); }));
        QCOMPARE(store.find(file)->preset.values[0].value(), 400.0);
        QVERIFY(waitFor([&] { return !store.loading(); }));
        changed.clear();
        store.rename(*store.find(file), QStringLiteral("  ")); // no name: the list shows the old one again
        QCOMPARE(changed.size(), 1);
        store.rename(store.presets().back(), QStringLiteral("mine")); // one of the program's
        QCOMPARE(changed.size(), 2);
        QVERIFY(!store.loading());
        const StoredPreset gone = *store.find(file);
        QVERIFY(QFile::remove(file));
        store.rename(gone, QStringLiteral("c"));
        QVERIFY(!QFile::exists(file)); // it does not come back by that
        QCOMPARE(failed.size(), 0);
    }

    void whatIsRemovedCanComeBack() {
        PresetStore store;
        QSignalSpy failed(&store, &PresetStore::failed);
        const QString file = store.add(presetOf("a"));
        QVERIFY(waitFor([&] { return store.find(file); }));
        store.takeBack(); // nothing was removed
        QVERIFY(waitFor([&] { return !store.loading(); }));
        store.remove(*store.find(file));
        QVERIFY(waitFor([&] { return !store.loading() && !store.find(file); }));
        QVERIFY(!QFile::exists(file));
        store.takeBack();
        QVERIFY(waitFor([&] { return store.find(file) != nullptr; }));
        QVERIFY(waitFor([&] { return !store.loading(); }));
        // While it was away another one took its name.
        store.remove(*store.find(file));
        QVERIFY(waitFor([&] { return !store.loading() && !store.find(file); }));
        QCOMPARE(store.add(presetOf("a", "new")), file);
        store.takeBack();
        QVERIFY(waitFor([&] { return ownOf(store) == QStringLiteral("/a new/a"); }));
        store.remove(store.presets().back()); // one of the program's
        QVERIFY(waitFor([&] { return !store.loading(); }));
        QCOMPARE(failed.size(), 0);
        StoredPreset gone = *store.find(file);
        gone.file += QStringLiteral(".none");
        store.remove(gone);
        QCOMPARE(failed.size(), 1);
        COMPARE_CONTAINS(failed[0][0].toString(), "cannot be removed. Check the rights of its folder.");
    }

    void theFolderIsFollowed() {
        PresetStore store;
        QVERIFY(waitFor([&] { return !store.loading(); }));
        QSignalSpy failed(&store, &PresetStore::failed);
        const QString file =
            PresetStore::folder() + QStringLiteral("/from-elsewhere.") + QString::fromUtf8(kPresetEnding);
        QFile made(file);
        QVERIFY(made.open(QIODevice::WriteOnly));
        made.write(QByteArray::fromStdString(presetText(presetOf("Elsewhere"))));
        made.close();
        QVERIFY(waitFor([&] { return ownOf(store) == QStringLiteral("/Elsewhere"); }));
        QVERIFY(made.open(QIODevice::WriteOnly | QIODevice::Truncate)); // damaged
        made.write("{");
        made.close();
        QVERIFY(QFile::copy(file, file + QStringLiteral(".other"))); // so that the folder changes
        QVERIFY(waitFor([&] { return failed.size() == 1; }));
        COMPARE_CONTAINS(failed[0][0].toString(), "from-elsewhere");
        QCOMPARE(ownOf(store), "");
        store.add(presetOf("a")); // the fault is said once
        QVERIFY(waitFor([&] { return ownOf(store) == QStringLiteral("/a") && !store.loading(); }));
        QCOMPARE(failed.size(), 1);
    }

    void filesAreImported() {
        PresetStore store;
        QSignalSpy imported(&store, &PresetStore::imported), failed(&store, &PresetStore::failed);
        const QString good = writeFile(*data_, QStringLiteral("one.json"),
                                       QByteArray::fromStdString(presetText(presetOf("One"))));
        const QString bad = writeFile(*data_, QStringLiteral("bad.json"), "[");
        const QString model = writeFile(*data_, QStringLiteral("model.XML"), "<none/>");
        store.importFiles({good, bad, model, good});
        QVERIFY(waitFor([&] { return imported.size() == 2 && failed.size() == 2; }));
        COMPARE_CONTAINS(failed[0][0].toString(), "bad.json");
        COMPARE_CONTAINS(failed[1][0].toString(), "model.XML");
        QVERIFY(imported[0][0].toString() != imported[1][0].toString());
        QVERIFY(waitFor([&] { return ownOf(store) == QStringLiteral("/One /One"); }));
        store.importFiles({});
        QVERIFY(waitFor([&] { return !store.loading(); }));
        QCOMPARE(imported.size(), 2);
    }

    void searchesLookThroughAllThatIsSaid() {
        PresetStore store;
        Preset preset = presetOf("Oak plank", "Wood");
        preset.tags = {"hard"};
        preset.sources["stiffness"] = {"Measured by Somebody", "https://a.b", false};
        preset.layers = std::vector<TextureLayer>(1);
        preset.layers->front().name = "Grain";
        const QString file = store.add(preset);
        QVERIFY(waitFor([&] { return store.find(file); }));
        const StoredPreset& oak = *store.find(file);
        for (const char* words :
             {"oak", "OAK", "wood", "hard", "somebody", "grain", "stiffness", "plank oak", ""})
            QVERIFY2(matches(oak, QString::fromUtf8(words)), words);
        for (const char* words : {"pine", "oak pine", "friction"})
            QVERIFY2(!matches(oak, QString::fromUtf8(words)), words);
        QCOMPARE(shownName(preset, store.presets()), "Oak plank");
        QCOMPARE(shownName(preset, {}), "Oak plank");
    }
};

TACTUM_TEST(TestPresetStore)

} // namespace test_preset_store

#include "test_preset_store.moc"
