// A view in no window, and what it hands to the renderers and to the painter before a picture is drawn: a
// line for all that is seen. For tests.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include <QPainter>

#include <vtkCamera.h>
#include <vtkCellData.h>
#include <vtkImageData.h>
#include <vtkPlaneCollection.h>
#include <vtkRendererCollection.h>
#include <vtkShaderProperty.h>
#include <vtkTexture.h>
#include <vtkUniforms.h>

#include "tests/support/shown.h"
#include "tests/ui/view/props.h"
#include "ui/view/gl_window.h"
#include "ui/view/scene_view.h"

namespace tactum::testing {

/// To a ten-thousandth of the largest: what is summed may differ in its last digits from machine to machine.
inline QString roundedOf(const std::vector<double>& values, double largest) {
    const double step = largest > 0 ? std::pow(10, std::floor(std::log10(largest)) - 4) : 1;
    QStringList texts;
    for (const double each : values) {
        const double steps = std::round(each / step + 1e-3); // powers of two lie on the edge
        texts << QString::number(steps == 0 ? 0 : steps * step, 'g', 5);
    }
    return u'(' + texts.join(u' ') + u')';
}

/// The mean of tuples, each with a weight that goes by its place: none can change, or take another's place,
/// without another mean.
class Mean {
public:
    explicit Mean(int width) : sums_(std::size_t(width), 0.0) {}
    void add(const std::function<double(int)>& component) {
        weight_ = weight_ < 7 ? weight_ + 1 : 1;
        weights_ += weight_;
        for (std::size_t k = 0; k < sums_.size(); ++k) {
            const double value = component(int(k));
            sums_[k] += weight_ * value;
            largest_ = std::max(largest_, std::abs(value));
        }
    }
    QString text() const {
        std::vector<double> means = sums_;
        for (double& each : means)
            each /= std::max(weights_, 1.0);
        return roundedOf(means, largest_);
    }

private:
    std::vector<double> sums_;
    double weight_ = 0, weights_ = 0, largest_ = 0;
};

inline QString meanOf(vtkDataArray& array) {
    Mean mean(array.GetNumberOfComponents());
    for (vtkIdType i = 0; i < array.GetNumberOfTuples(); ++i)
        mean.add([&](int k) { return array.GetComponent(i, k); });
    return mean.text();
}

/// Of the corners of all cells.
inline QString cornersOf(vtkPolyData& data) {
    Mean mean(3);
    for (vtkCellArray* cells : {data.GetVerts(), data.GetLines(), data.GetPolys()}) {
        vtkIdType count = 0;
        const vtkIdType* corners = nullptr;
        for (cells->InitTraversal(); cells->GetNextCell(count, corners);)
            for (vtkIdType i = 0; i < count; ++i) {
                const Vec3 corner(data.GetPoint(corners[i]));
                mean.add([&](int k) { return corner[k]; });
            }
    }
    return mean.text();
}

inline QString textureOf(vtkTexture& texture) {
    texture.Update();
    vtkImageData* image = texture.GetInput();
    if (!image || !image->GetPointData()->GetScalars()) return QStringLiteral("nothing");
    const int* size = image->GetDimensions();
    return QStringLiteral("%1 x %2 mean %3%4%5")
        .arg(size[0])
        .arg(size[1])
        .arg(meanOf(*image->GetPointData()->GetScalars()),
             texture.GetRepeat() ? QStringLiteral(" repeats") : QString(),
             texture.GetInterpolate() ? QStringLiteral(" smooth") : QString());
}

/// Numbers of its own that a shader gets.
inline QString uniformsOf(vtkUniforms& uniforms) {
    QString text;
    for (int i = 0; i < uniforms.GetNumberOfUniforms(); ++i) {
        const char* name = uniforms.GetNthUniformName(i);
        std::vector<float> values;
        if (!uniforms.GetUniform(name, values)) continue;
        text += u' ' + QLatin1String(name) + u' ';
        for (std::size_t from = 0; from < values.size(); from += 4) {
            const std::vector<double> four(values.begin() + std::ptrdiff_t(from),
                                           values.begin() +
                                               std::ptrdiff_t(std::min(from + 4, values.size())));
            double largest = 0;
            for (const double each : four)
                largest = std::max(largest, std::abs(each));
            text += roundedOf(four, largest);
        }
    }
    return text;
}

/// What propOf() leaves out.
inline QString moreOf(vtkActor& actor) {
    vtkProperty& how = *actor.GetProperty();
    QString line;
    if (how.GetRepresentation() != VTK_SURFACE) line += QStringLiteral(" wires");
    if (how.GetInterpolation() == VTK_FLAT) line += QStringLiteral(" flat");
    if (how.GetSpecular() != 0) line += QStringLiteral(" gloss %1").arg(how.GetSpecular(), 0, 'g', 3);
    if (how.GetDiffuse() != 1 || how.GetAmbient() != 0)
        line += QStringLiteral(" light %1 + %2").arg(how.GetDiffuse()).arg(how.GetAmbient());
    for (const auto& [name, texture] : how.GetAllTextures())
        line += QStringLiteral(" %1 %2").arg(QString::fromStdString(name), textureOf(*texture));
    if (actor.GetTexture()) line += QStringLiteral(" picture ") + textureOf(*actor.GetTexture());
    line += uniformsOf(*actor.GetShaderProperty()->GetFragmentCustomUniforms());
    auto* mapper = vtkPolyDataMapper::SafeDownCast(actor.GetMapper());
    if (!mapper || !mapper->GetInput()) return line;
    vtkPolyData& data = *mapper->GetInput();
    if (mapper->GetClippingPlanes() && mapper->GetClippingPlanes()->GetNumberOfItems() > 0) {
        vtkPlane* plane = mapper->GetClippingPlanes()->GetItem(0);
        line += QStringLiteral(" cut at %1 %2")
                    .arg(numbersOf(plane->GetOrigin(), 3), numbersOf(plane->GetNormal(), 3));
    }
    line += QStringLiteral(" corners ") + cornersOf(data);
    for (vtkDataSetAttributes* of : {static_cast<vtkDataSetAttributes*>(data.GetPointData()),
                                     static_cast<vtkDataSetAttributes*>(data.GetCellData())})
        for (int i = 0; i < of->GetNumberOfArrays(); ++i) {
            vtkDataArray* array = of->GetArray(i);
            if (!array) continue;
            const bool colours = array == of->GetScalars() && mapper->GetScalarVisibility();
            line += QStringLiteral(" %1 %2").arg(colours                     ? QStringLiteral("colours")
                                                 : array == of->GetNormals() ? QStringLiteral("normals")
                                                 : array == of->GetTCoords()
                                                     ? QStringLiteral("places")
                                                     : QString::fromLatin1(array->GetName()),
                                                 meanOf(*array));
        }
    return line;
}

/// A view that is laid out and never drawn.
class HeldView : public SceneView {
public:
    explicit HeldView(QSize size = {640, 480}) {
        resize(size);
        setAttribute(Qt::WA_DontShowOnScreen);
        setUpdatesEnabled(false);
        show();
    }

    /// The pointer's shape; of each picture its camera and all actors that are seen, of those after the first
    /// what the first has not; what is painted over them.
    QString holds() {
        QStringList lines{QStringLiteral("pointer %1").arg(int(cursor().shape()))}, first;
        const std::vector<QRect> places = pictures();
        prepareFrame();
        for (std::size_t i = 0; i < places.size(); ++i) {
            preparePicture(i);
            const QString pane = places.size() > 1 ? QString::number(i) + u' ' : QString();
            lines << pane + cameraText();
            QStringList actors;
            vtkRendererCollection* renderers = renderWindow().GetRenderers();
            int layer = 0;
            renderers->InitTraversal();
            while (vtkRenderer* renderer = renderers->GetNextItem())
                add(actors, QString::number(layer++) + u' ', *renderer);
            if (i == 0) first = actors;
            for (const QString& actor : actors)
                if (i == 0 || !first.contains(actor)) lines << pane + actor;
        }
        const QString painted = test::drawnBy(size(), [this](QPainter& painter) { drawOver(painter); });
        return lines.join(u'\n') + u'\n' + withoutSteps(painted.split(u'\n')).join(u'\n');
    }

private:
    /// Of the many steps of a scale's colours the first and the last.
    static QStringList withoutSteps(const QStringList& all) {
        const auto isStep = [&](qsizetype i) {
            return i >= 0 && i < all.size() && all[i].startsWith(QStringLiteral("rect filled #"));
        };
        QStringList lines;
        for (qsizetype i = 0; i < all.size(); ++i)
            if (!(isStep(i - 1) && isStep(i) && isStep(i + 1))) lines << all[i];
        return lines;
    }

    QString cameraText() {
        vtkRendererCollection* renderers = renderWindow().GetRenderers();
        vtkCamera& camera = *renderers->GetFirstRenderer()->GetActiveCamera();
        const double* near = camera.GetClippingRange();
        return QStringLiteral("camera at %1 to %2 up %3 from %4 to %5, angle %6%7")
            .arg(numbersOf(camera.GetPosition(), 3), numbersOf(camera.GetFocalPoint(), 3),
                 numbersOf(camera.GetViewUp(), 3))
            .arg(near[0], 0, 'g', 4)
            .arg(near[1], 0, 'g', 4)
            .arg(camera.GetViewAngle(), 0, 'g', 4)
            .arg(camera.GetParallelProjection()
                     ? QStringLiteral(", parallel %1").arg(camera.GetParallelScale(), 0, 'g', 4)
                     : QString());
    }

    static void add(QStringList& lines, const QString& prefix, vtkRenderer& renderer) {
        vtkActorCollection* actors = renderer.GetActors();
        lines << QStringLiteral("%1layer %2 of %3 actors, background %4%5")
                     .arg(prefix)
                     .arg(renderer.GetLayer())
                     .arg(actors->GetNumberOfItems())
                     .arg(numbersOf(renderer.GetBackground(), 3),
                          renderer.GetGradientBackground() ? numbersOf(renderer.GetBackground2(), 3)
                                                           : QString());
        actors->InitTraversal();
        while (vtkActor* actor = actors->GetNextActor())
            if (actor->GetVisibility()) {
                const QString line = prefix + propOf(*actor); // brings the mapper up to date
                lines << line + moreOf(*actor);
            }
    }
};

} // namespace tactum::testing
