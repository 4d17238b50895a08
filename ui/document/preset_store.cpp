#include "ui/document/preset_store.h"

#include <algorithm>
#include <iterator>

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QStandardPaths>

#include "core/base/atomic_file.h"
#include "core/presets/preset_file.h"
#include "core/presets/read_hatt.h"
#include "ui/base/search.h"
#include "ui/base/words.h"
#include "ui/document/preset_picture.h"

// Outside of any namespace, as Qt asks: the resources live in a static library.
static void initPresets() {
    Q_INIT_RESOURCE(presets);
}

namespace tactum {

namespace {

constexpr int kPresetPicture = 80; // device pixels: sharp on a screen of twice the dots
constexpr int kSettle = 150;       // ms
constexpr const char* kAside = ".removed";
const QString kShipped = QStringLiteral(":/presets");

std::filesystem::path presetPathOf(const QString& file) {
    return std::filesystem::path(file.toStdU16String());
}

QString dottedEnding() {
    return u'.' + asIs(kPresetEnding);
}

Result<LoadedPreset> presetIn(const QString& file) {
    if (!file.startsWith(u':')) return readPreset(presetPathOf(file));
    QFile resource(file);
    if (!resource.open(QIODevice::ReadOnly)) return inputError("a preset of the program is missing");
    return parsePreset(resource.readAll().toStdString(), presetPathOf(file));
}

StoredPreset stored(const QString& file, const Preset& preset, bool own) {
    StoredPreset made{file, own, preset, QString::fromStdString(presetText(preset)), {}, {}};
    QStringList words{asIs(preset.name), asIs(preset.category), made.name(), made.category()};
    for (const std::string& tag : preset.tags)
        words << QString::fromStdString(tag);
    for (const auto& [key, source] : preset.sources)
        words << QString::fromStdString(source.words);
    for (std::size_t i = 0; i < kMaterialFields.size(); ++i)
        if (preset.values[i]) words << wordsOf(kMaterialFields[i].parameter->label);
    for (const TextureLayer& layer : preset.layers.value_or(std::vector<TextureLayer>()))
        words << QString::fromStdString(layer.name);
    made.words = words.join(u'\n').toCaseFolded();
    made.picture = presetPicture(preset, kPresetPicture);
    return made;
}

struct Loaded {
    std::vector<StoredPreset> presets;
    QStringList complaints;
};

Loaded loadAll(const Progress& progress) {
    Loaded loaded;
    const auto add = [&](const QString& folder, bool own) {
        for (const QFileInfo& file :
             QDir(folder).entryInfoList({u'*' + dottedEnding()}, QDir::Files, QDir::Name)) {
            if (progress.isCancelled()) return;
            const auto read = presetIn(file.filePath());
            if (read)
                loaded.presets.push_back(stored(file.filePath(), read->preset, own));
            else
                loaded.complaints << QString::fromStdString(read.error().text);
        }
    };
    add(PresetStore::folder(), true);
    add(kShipped, false);
    std::ranges::stable_sort(loaded.presets, [](const StoredPreset& a, const StoredPreset& b) {
        if (a.own != b.own) return a.own;
        if (a.category() != b.category()) return QString::localeAwareCompare(a.category(), b.category()) < 0;
        return QString::localeAwareCompare(a.name(), b.name()) < 0;
    });
    return loaded;
}

QString freeFile(const std::string& name) {
    const QString stem = PresetStore::folder() + u'/' + QString::fromStdString(presetFileName(name));
    QString file = stem + dottedEnding();
    for (int number = 2; QFileInfo::exists(file); ++number)
        file = stem + u'-' + QString::number(number) + dottedEnding();
    return file;
}

Result<LoadedPreset> foreignPreset(const QString& file) {
    return file.endsWith(QStringLiteral(".xml"), Qt::CaseInsensitive) ? readHatt(presetPathOf(file))
                                                                      : readPreset(presetPathOf(file));
}

std::vector<Preset> readFrom(const QString& folder) {
    std::vector<Preset> presets;
    for (const QFileInfo& file : QDir(folder).entryInfoList({u'*' + dottedEnding()}, QDir::Files, QDir::Name))
        if (auto read = presetIn(file.filePath())) presets.push_back(std::move(read->preset));
    return presets;
}

} // namespace

QString shownName(const Preset& preset, const std::vector<StoredPreset>& library) {
    const bool shipped = std::ranges::any_of(library, [&](const StoredPreset& stored) {
        return !stored.own && stored.preset.name == preset.name;
    });
    return shipped ? wordsOf(preset.name) : asIs(preset.name);
}

bool matches(const StoredPreset& stored, const QString& search) {
    return hasWords(stored.words, searchWords(search));
}

PresetStore::PresetStore(QObject* parent) : QObject(parent) {
    initPresets();
    QDir().mkpath(folder());
    watcher_.addPath(folder());
    later_.setSingleShot(true);
    later_.setInterval(kSettle);
    connect(&watcher_, &QFileSystemWatcher::directoryChanged, &later_, qOverload<>(&QTimer::start));
    connect(&later_, &QTimer::timeout, this, &PresetStore::load);
    connect(&reading_, &BackgroundJob::finished, this, [this] {
        if (!waiting_.isEmpty()) importFiles({});
    });
    load();
}

QString PresetStore::folder() {
    return QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + QStringLiteral("/presets");
}

std::vector<Preset> PresetStore::readAll() {
    std::vector<Preset> presets = readOwn();
    std::ranges::move(readShipped(), std::back_inserter(presets));
    return presets;
}

std::vector<Preset> PresetStore::readOwn() {
    return readFrom(folder());
}

std::vector<Preset> PresetStore::readShipped() {
    initPresets();
    return readFrom(kShipped);
}

QString StoredPreset::name() const {
    return own ? asIs(preset.name) : wordsOf(preset.name);
}

QString StoredPreset::category() const {
    return own ? asIs(preset.category) : wordsOf(preset.category);
}

const StoredPreset* PresetStore::find(const QString& file) const {
    const auto found = std::ranges::find(presets_, file, &StoredPreset::file);
    return found == presets_.end() ? nullptr : &*found;
}

void PresetStore::load() {
    job_.start([this](const Progress& progress) -> BackgroundJob::Delivery {
        auto loaded = std::make_shared<Loaded>(loadAll(progress));
        return [this, loaded] {
            presets_ = std::move(loaded->presets);
            emit changed();
            for (const QString& complaint : loaded->complaints) // once for each fault
                if (!complained_.contains(complaint)) emit failed(complaint);
            complained_ = loaded->complaints;
        };
    });
}

bool PresetStore::write(const Preset& preset, const QString& file) {
    const auto written = writeFileAtomically(presetPathOf(file), presetText(preset), 0);
    if (!written) emit failed(QString::fromStdString(written.error().text));
    return written.has_value();
}

QString PresetStore::add(const Preset& preset) {
    QDir().mkpath(folder());
    const QString file = freeFile(preset.name);
    if (!write(preset, file)) return {};
    load();
    return file;
}

void PresetStore::rename(const StoredPreset& stored, const QString& name) {
    if (!stored.own || name.trimmed().isEmpty()) return emit changed();
    if (!QFileInfo::exists(stored.file)) return; // removed meanwhile: a new name does not bring it back
    Preset renamed = stored.preset;
    renamed.name = name.trimmed().toStdString();
    if (write(renamed, stored.file)) load();
}

void PresetStore::remove(const StoredPreset& stored) {
    if (!stored.own) return;
    const QString file = stored.file, aside = file + QLatin1String(kAside);
    QFile::remove(aside);
    if (!QFile::rename(file, aside))
        return emit failed(tr("%1 cannot be removed. Check the rights of its folder.").arg(file));
    removed_ = aside;
    load();
}

void PresetStore::takeBack() {
    if (removed_.isEmpty()) return;
    QString file = removed_.chopped(qsizetype(std::strlen(kAside)));
    if (QFileInfo::exists(file)) file = freeFile(QFileInfo(file).baseName().toStdString());
    if (!QFile::rename(removed_, file)) emit failed(tr("%1 cannot be brought back.").arg(file));
    removed_.clear();
    load();
}

void PresetStore::importFiles(const QStringList& files) {
    waiting_ << files;
    if (reading_.running() || waiting_.isEmpty()) return;
    const QString file = waiting_.takeFirst();
    reading_.start([this, file](const Progress&) -> BackgroundJob::Delivery {
        auto read = std::make_shared<Result<LoadedPreset>>(foreignPreset(file));
        return [this, file, read] {
            if (!*read) return emit failed(QString::fromStdString(read->error().text));
            const QString own = add((*read)->preset);
            if (!own.isEmpty()) emit imported(own, **read);
        };
    });
}

} // namespace tactum
