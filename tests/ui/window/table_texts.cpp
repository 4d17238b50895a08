#include "tests/ui/window/table_texts.h"

#include <string_view>

#include <QStringList>

#include "core/loop/urgency.h"
#include "core/paint/brush.h"
#include "core/safety/inhibit_words.h"
#include "core/scene/bodies.h"
#include "core/scene/colliders.h"
#include "core/self_test/words.h"
#include "core/study/design.h"
#include "core/surface/material.h"
#include "core/surface/shading.h"
#include "device/registry.h"
#include "ui/base/preferences.h"
#include "ui/base/shortcuts.h"
#include "ui/base/words.h"
#include "ui/document/preset_store.h"
#include "ui/engine/device_settings.h"
#include "ui/tools/paint_goal.h"
#include "ui/tools/select_tool.h"

namespace tactum {

namespace {

struct Texts {
    std::set<QString> all;

    void add(std::string_view text) {
        if (!text.empty()) all.insert(asIs(text));
    }
    void add(const Parameter& parameter) {
        add(parameter.label);
        add(parameter.sentence);
    }
    void addFields(const auto& fields) {
        for (const auto& field : fields)
            add(*field.parameter);
    }
    void addChoices(const auto& choices) {
        for (const auto& choice : choices)
            add(choice.label);
    }
};

void addCommands(Texts& texts) {
    for (const Command& each : commands()) {
        texts.add(each.text);
        texts.add(each.sentence);
        for (const QString& menu : QString::fromLatin1(each.menu).split(u'/'))
            texts.all.insert(menu);
    }
    for (const Manner& each : viewManners()) {
        texts.add(each.keys);
        texts.add(each.text);
    }
}

/// What a participant is asked where the author has written nothing.
void addStudies(Texts& texts) {
    StudyDesign design;
    for (const Procedure procedure : {Procedure::Pairs, Procedure::Abx, Procedure::Staircase})
        for (const bool compares : {true, false}) {
            design.procedure = procedure;
            design.staircase.compares = compares;
            texts.add(promptOf(design));
            for (const std::string& choice : choicesOf(design))
                if (choice.size() > 1) texts.add(choice);
        }
}

} // namespace

std::set<QString> tableTexts() {
    Texts texts;
    addCommands(texts);
    texts.addFields(kMaterialFields);
    texts.addFields(kPatternFields);
    texts.addFields(kBrushFields);
    texts.addFields(kBodyFields);
    texts.addFields(kWorldFields);
    for (const AxisField& field : kAxisFields) {
        texts.add(*field.hinge);
        texts.add(*field.slider);
    }
    for (const Parameter* each :
         {&kCreaseAngle, &kProxyRadius, &kTextureHeight, &kTextureRatio, &kTextureOpacity, &kBodyMass,
          &kWorkspaceScale, &kShellRadius, &kSelectAngle})
        texts.add(*each);
    texts.addChoices(kReachChoices);
    texts.addChoices(kTextureSources);
    texts.addChoices(kTextureMappings);
    texts.addChoices(kTextureBlends);
    texts.addChoices(kTextureTargets);
    texts.addChoices(kBrushModes);
    texts.addChoices(kPaintGoals);
    for (const auto& form : kColliderForms) {
        texts.add(form.label);
        texts.add(form.sentence);
    }
    for (const InhibitWords& words : kInhibitWords)
        for (const char* text : {words.brief, words.what, words.done, words.remedy})
            texts.add(text);
    for (const Preference& each : preferenceTable()) {
        texts.add(each.page);
        texts.add(each.parameter);
        for (const char* choice : each.choices)
            texts.add(choice);
    }
    addStudies(texts);
    for (const std::string_view words : kUrgencyWords)
        texts.add(words);
    for (const char* words : trial_words::kAll)
        texts.add(words);
    for (const BuiltIn& each : kBuiltIn) {
        texts.add(each.name);
        texts.add(each.sentence);
    }
    for (const Preset& each : PresetStore::readShipped()) {
        texts.add(each.name);
        texts.add(each.category);
    }
    return texts.all;
}

} // namespace tactum
