#include "ui/base/shortcuts.h"

#include <algorithm>
#include <string_view>

#include <QActionGroup>
#include <QMenu>
#include <QMenuBar>

#include "ui/base/mnemonics.h"
#include "ui/base/style.h"

namespace tactum {

namespace {

constexpr Command kCommands[] = {
    {"new", "File", "Ne&w scene", "Ctrl+N", "", "An empty scene, to add models to"},
    {"new-ground", "File", "New scene on a &ground", "", "", "A plate of 320 mm to put models on"},
    {"open", "File", "&Open...", "Ctrl+O", "open", "Open a scene, a model or a recording"},
    {"add", "File/A&dd", "&Models...", "Ctrl+Shift+O", "",
     "Models from files, beside what is in the scene; dropping files on the window does the same"},
    {"add-box", "File/A&dd", "&Box", "", "", "A cube of 60 mm", false, true},
    {"add-sphere", "File/A&dd", "&Sphere", "", "", "A ball of 60 mm"},
    {"add-cylinder", "File/A&dd", "&Cylinder", "", "", "60 mm across and 80 mm high"},
    {"add-plate", "File/A&dd", "P&late", "", "", "120 mm wide and 8 mm high"},
    {"connect", "File", "&Connect to a server...", "", "",
     "A window on the scene and the device of a haptic server"},
    {"update-geometry", "File", "&Update geometry from file...", "Ctrl+U", "",
     "Shapes that another program has changed, with the feel that this scene has"},
    {"taken-m", "File/&Taken as", "Taken as &metres", "", "",
     "What the file leaves open: one unit of it is 1 m; offered after opening, like the bar over the view",
     true},
    {"taken-cm", "File/&Taken as", "Taken as &centimetres", "", "", "One unit of the file is 1 cm", true},
    {"taken-mm", "File/&Taken as", "Taken as m&illimetres", "", "", "One unit of the file is 1 mm", true},
    {"taken-in", "File/&Taken as", "Taken as i&nches", "", "", "One unit of the file is 1 in", true},
    {"up-y", "File/&Taken as", "&y is up", "", "", "The y axis of the file points up", true, true},
    {"up-z", "File/&Taken as", "&z is up", "", "", "The z axis of the file points up", true},
    {"save", "File", "&Save", "Ctrl+S", "save", "Write the scene with all its surfaces as glTF (.glb)", false,
     true},
    {"save-as", "File", "Save &as...", "Ctrl+Shift+S", "",
     "Write the scene under another name, and go on with that"},
    {"export", "File", "&Export a bundle...", "Ctrl+E", "export",
     "One zip for other programs: glTF, X3D for H3D, images, a finger path with its forces, a report", false,
     true},
    {"save-picture", "File", "Save &picture...", "", "picture", "Write the view as a PNG file", false, true},
    {"export-report", "File", "E&xport a report...", "Ctrl+Shift+E", "",
     "One page with pictures, values, their sources and the forces of a stroke, as HTML or PDF"},
    {"export-plot", "File", "Export the p&lot...", "", "", "Write the plot as CSV, PNG or SVG"},
    {"save-recording", "File", "Save &recording of the last minute...", "Ctrl+Shift+R", "record",
     "Everything that was touched and felt in the last minute, to be played again bit for bit", false, true},
    {"quit", "File", "&Quit", "Ctrl+Q", "", "Forces off, and out", false, true},
    {"undo", "Edit", "&Undo", "Ctrl+Z", "undo", "Take the last edit back"},
    {"redo", "Edit", "&Redo", "Ctrl+Shift+Z; Ctrl+Y", "redo", "Do the last undone edit again"},
    {"duplicate", "Edit", "&Duplicate", "Ctrl+D", "duplicate",
     "A copy of the selected objects beside them, with their feel and what moves them", false, true},
    {"remove", "Edit", "D&elete", "Del; Ctrl+Del", "remove",
     "Take the selected objects out of the scene, with their bodies and joints"},
    {"rename", "Edit", "Re&name", "F2", "", "Another name for the object or surface that was selected last"},
    {"group", "Edit", "&Group", "Ctrl+G", "group",
     "The selected objects become a group under a name, which is selected, moved and hidden as a whole",
     false, true},
    {"ungroup", "Edit", "Ta&ke the group apart", "Ctrl+Shift+G", "",
     "What the selected objects are grouped by goes; all objects stay"},
    {"select-group", "Edit", "Select the &whole group", "", "",
     "All objects of the groups that something is selected of; a double click on an object does the same"},
    {"object-up", "Edit/Order &in the list", "&Up in the list", "Alt+Up", "",
     "The selected objects come before the one above them in the list; dragging their rows does the same"},
    {"object-down", "Edit/Order &in the list", "&Down in the list", "Alt+Down", "",
     "The selected objects come behind the one below them in the list"},
    {"align-x-low", "Edit/A&lign and distribute", "Align &left sides", "", "",
     "The lowest x of the selected objects becomes that of the one selected last", false, true},
    {"align-x-middle", "Edit/A&lign and distribute", "Align middles along &x", "", "",
     "The middle x of the selected objects becomes that of the one selected last"},
    {"align-x-high", "Edit/A&lign and distribute", "Align &right sides", "", "",
     "The highest x of the selected objects becomes that of the one selected last"},
    {"align-y-low", "Edit/A&lign and distribute", "Align l&ower sides", "", "",
     "The lowest y of the selected objects becomes that of the one selected last"},
    {"align-y-middle", "Edit/A&lign and distribute", "Align middles along &y", "", "",
     "The middle y of the selected objects becomes that of the one selected last"},
    {"align-y-high", "Edit/A&lign and distribute", "Align u&pper sides", "", "",
     "The highest y of the selected objects becomes that of the one selected last"},
    {"align-z-low", "Edit/A&lign and distribute", "Align &back sides", "", "",
     "The lowest z of the selected objects becomes that of the one selected last"},
    {"align-z-middle", "Edit/A&lign and distribute", "Align middles along &z", "", "",
     "The middle z of the selected objects becomes that of the one selected last"},
    {"align-z-high", "Edit/A&lign and distribute", "Align &front sides", "", "",
     "The highest z of the selected objects becomes that of the one selected last"},
    {"distribute-x", "Edit/A&lign and distribute", "&Distribute along x", "", "",
     "The middles of three or more selected objects; the outer two stay", false, true},
    {"distribute-y", "Edit/A&lign and distribute", "D&istribute along y", "", "",
     "The middles of three or more selected objects; the outer two stay"},
    {"distribute-z", "Edit/A&lign and distribute", "Dis&tribute along z", "", "",
     "The middles of three or more selected objects; the outer two stay"},
    {"drop", "Edit", "Dr&op to the ground", "Ctrl+End", "",
     "The selected objects come down onto what is beneath them, or on the ground"},
    {"palette", "Edit", "&Find a command...", "Ctrl+Shift+P", "", "Every command by a few letters of it",
     false, true},
    {"preferences", "Edit", "Preferen&ces...", "Ctrl+,", "",
     "Mouse, units, theme, language and what is kept for a crash", false, true},
    {"select-all", "Select", "&All surfaces", "A", "", "Every surface that is visible"},
    {"select-none", "Select", "&Nothing", "Alt+A", "", "No surface and no triangle"},
    {"select-like", "Select", "&Same feel", "Shift+G", "", "Every surface that feels like the active one"},
    {"select-colour", "Select", "Sam&e colour", "Shift+C", "",
     "Every surface that has the colour of the active one"},
    {"select-touched", "Select", "What is t&ouched", "T", "",
     "The surface that the finger touches, or has touched last; also while it is held"},
    {"take-surface", "Select", "A click takes the s&urface", "", "",
     "A click takes a surface; with Shift also, with Ctrl not any more", true, true},
    {"take-material", "Select", "A click takes the same &feel", "", "",
     "A click takes every surface that feels like the one under the cursor", true},
    {"take-colour", "Select", "A clic&k takes the same colour", "", "",
     "A click takes every surface that has the colour of the one under the cursor", true},
    {"take-connected", "Select", "A click takes the &connected region", "", "",
     "A click takes all triangles that hang together over edges", true},
    {"take-smooth", "Select", "A click takes the s&mooth region", "", "",
     "A click takes triangles up to edges that bend by more than the angle", true},
    {"take-similar", "Select", "A click takes s&imilar normals", "", "",
     "A click takes the connected triangles that face the same way within the angle", true},
    {"take-facing", "Select", "A click takes all that face the same &way", "", "",
     "A click takes every triangle of the object that faces the same way within the angle, connected or not",
     true},
    {"take-triangle", "Select", "A click takes the &triangle", "", "", "A click takes one triangle", true},
    {"box", "Select", "&Box", "B", "",
     "The next drag takes what lies in a box; with Shift also, with Ctrl not any more", false, true},
    {"lasso", "Select", "&Lasso", "Shift+B", "",
     "The next drag takes what its line goes round; with Shift also, with Ctrl not any more"},
    {"select-brush", "Select", "B&rush", "C", "",
     "Drags take what they go over, until Esc or C again; with Shift also, with Ctrl not any more; [ and ] "
     "size",
     true},
    {"through", "Select", "Through the mo&del", "", "",
     "Box and lasso also take what lies behind; else what is seen, as the brush does", true},
    {"grow", "Select", "&Grow", "Ctrl++", "", "One ring of triangles more"},
    {"shrink", "Select", "S&hrink", "Ctrl+-", "", "One ring of triangles less"},
    {"invert", "Select", "In&vert", "Ctrl+I", "",
     "The other triangles of the object, or the other surfaces where no triangle is selected"},
    {"set-keep", "Select", "Kee&p as a set...", "Ctrl+Alt+K", "",
     "The selection under a name, saved with the scene, to be selected again", false, true},
    {"hide", "Surface", "&Hide", "H", "eye-off",
     "The selected surfaces are neither seen nor felt until they are shown again"},
    {"isolate", "Surface", "Show &alone", "/", "", "Hide everything but the selected surfaces"},
    {"show-all", "Surface", "&Show all", "Alt+H", "eye", "Show every object and every surface"},
    {"lock", "Surface", "&Lock", "L", "lock",
     "No edit changes how the selected surfaces feel or which triangles they have; the same unlocks"},
    {"split", "Surface", "S&plit off", "Y", "split", "The selected triangles become a surface of their own",
     false, true},
    {"merge", "Surface", "&Merge", "Ctrl+J", "merge",
     "The selected surfaces of one object become one, which feels like the one selected last"},
    {"copy-feel", "Surface", "&Copy feel", "Ctrl+C", "",
     "Material, shading, sides and layers of the active surface, to be pasted onto others", false, true},
    {"paste-feel", "Surface", "Paste &feel", "Ctrl+V", "", "The selected surfaces feel like the copied one"},
    {"same-feel", "Surface", "Same as the active &one", "Ctrl+L", "",
     "The other selected surfaces feel like the one that was selected last"},
    {"surface-colour", "Surface", "Colo&ur...", "Shift+U", "",
     "Another colour for the selected surfaces, to be seen by; what is felt stays"},
    {"normals-smooth", "Surface/&Normals", "&Smooth by the crease angle", "", "",
     "Force shading with computed normals: edges below the crease angle feel round", false, true},
    {"normals-file", "Surface/&Normals", "From the &file", "", "",
     "Force shading with the normals that the file brought along"},
    {"normals-flat", "Surface/&Normals", "F&lat", "", "", "No force shading: every facet is felt as it is"},
    {"normals-flip", "Surface/&Normals", "Turn &over", "Alt+N", "",
     "The selected triangles, else the selected surfaces, get their front on the other side", false, true},
    {"normals-agree", "Surface/&Normals", "&Agree on fronts", "Shift+N", "",
     "Neighbours of the object get their fronts on the same side, closed parts outside"},
    {"normals-weld", "Surface/&Normals", "&Weld vertices", "", "",
     "Vertices at the same place become one, so that normals run smoothly over them"},
    {"preset-apply", "Surface", "Apply the p&reset", "Ctrl+Shift+Return", "",
     "The selected surfaces get the values of the preset that is chosen in the library", false, true},
    {"preset-save", "Surface", "Sa&ve as preset...", "", "",
     "Keep how the active surface feels in the library, under a name"},
    {"preset-import", "Surface", "&Import presets...", "", "",
     "Presets from files, or texture models (.xml) of your own copy of the Penn Haptic Texture Toolkit"},
    {"preset-export", "Surface", "&Export the preset...", "", "", "The chosen preset as a file for others"},
    {"layer-noise", "Layer", "Add &noise", "", "", "A layer of noise on all selected surfaces"},
    {"layer-grooves", "Layer", "Add &grooves", "", "", "A layer of parallel ridges on all selected surfaces"},
    {"layer-dots", "Layer", "Add &dots", "", "", "A layer of bumps in rows on all selected surfaces"},
    {"layer-weave", "Layer", "Add &weave", "", "", "A layer like woven cloth on all selected surfaces"},
    {"layer-image", "Layer", "Add an &image...", "", "picture",
     "A layer of a PNG, JPEG or TIFF picture on all selected surfaces; bright is high"},
    {"layer-painted", "Layer", "Add a pain&ted layer", "", "paint",
     "An empty layer to be painted on all selected surfaces"},
    {"layer-duplicate", "Layer", "D&uplicate layer", "", "duplicate", "The same layer once more, above it",
     false, true},
    {"layer-remove", "Layer", "&Remove layer", "", "remove", "Take the selected layer off the surface"},
    {"layer-up", "Layer", "Move layer u&p", "", "up", "Above the layer that lies on it"},
    {"layer-down", "Layer", "Move layer d&own", "", "down", "Beneath the layer that it lies on"},
    {"layer-show", "Layer", "Show or &hide layer", "", "", "Switch the selected layer off, or on again",
     false, true},
    {"layer-solo", "Layer", "&Solo", "", "solo",
     "Feel the selected layer alone; the scene keeps which layers are on", true},
    {"mapping", "Layer", "&Move the mapping", "Ctrl+Alt+G", "frame",
     "Handles in the view that move, turn and scale the selected layer's mapping (G with the select tool)",
     true, true},
    {"touch", "Tools", "&Touch", "W", "touch", "Touch: drag on the model to lead the finger", true},
    {"select", "Tools", "&Select", "Q", "select", "Select: click a surface to see and set how it feels",
     true},
    {"paint", "Tools", "&Paint", "P", "paint",
     "Paint: drag on the model to lay a value or a mask onto it; Ctrl takes away, Shift smooths", true},
    {"arrange", "Tools", "&Move", "M", "move",
     "Move, turn and scale: click an object and drag its handles; G, R and S take hold of it", true},
    {"measure", "Tools", "Meas&ure", "D", "",
     "Measure: two clicks on the model are a distance, a third gives the angle at the second; Esc ends it",
     true},
    {"measure-copy", "Tools", "&Copy the measure", "", "", "Its numbers to the clipboard"},
    {"measure-clear", "Tools", "Clear the m&easure", "", "", "Take its points out of the view"},
    {"paint-height", "Tools/The brush p&aints", "&Height", "", "",
     "A layer of bumps and hollows, as high as its strength says", true, true},
    {"paint-static-friction", "Tools/The brush p&aints", "&Static friction", "", "",
     "A layer that scales the static friction", true},
    {"paint-dynamic-friction", "Tools/The brush p&aints", "&Dynamic friction", "", "",
     "A layer that scales the dynamic friction", true},
    {"paint-viscosity", "Tools/The brush p&aints", "&Viscosity", "", "", "A layer that scales the viscosity",
     true},
    {"paint-stiffness", "Tools/The brush p&aints", "S&tiffness", "", "", "A layer that scales the stiffness",
     true},
    {"paint-layer", "Tools/The brush p&aints", "The chosen &layer", "", "",
     "The values of a painted layer, or the image of one that lies on texture coordinates", true},
    {"paint-mask", "Tools/The brush p&aints", "The &mask of the chosen layer", "", "",
     "Where the layer counts, and how much", true},
    {"brush-add", "Tools/The brush d&oes", "&Add", "", "", "Every stroke adds; with Ctrl it takes away",
     true},
    {"brush-subtract", "Tools/The brush d&oes", "&Subtract", "", "",
     "Every stroke takes away; with Ctrl it adds", true},
    {"brush-set", "Tools/The brush d&oes", "S&et", "", "", "Every stroke goes toward one value", true},
    {"brush-smooth", "Tools/The brush d&oes", "S&mooth", "", "", "Every stroke evens out what is there",
     true},
    {"brush-bigger", "Tools", "&Larger brush", "]", "",
     "A larger radius for the brush that paints, or the one that selects", false, true},
    {"brush-smaller", "Tools", "Smaller brus&h", "[", "",
     "A smaller radius for the brush that paints, or the one that selects"},
    {"brush-stronger", "Tools", "St&ronger brush", "}; Shift+]", "", "A brush that changes more"},
    {"brush-weaker", "Tools", "&Weaker brush", "{; Shift+[", "", "A brush that changes less"},
    {"pivot-middle", "Tools/About what o&bjects turn", "The &middle of all", "", "",
     "Selected objects turn and scale about the middle of them all", true, true},
    {"pivot-each", "Tools/About what o&bjects turn", "&Each about its own", "", "",
     "Every selected object turns and scales about its own middle", true},
    {"pivot-last", "Tools/About what o&bjects turn", "The &last one", "", "",
     "Selected objects turn and scale about the middle of the one selected last", true},
    {"pivot-world", "Tools/About what o&bjects turn", "The &origin", "", "",
     "Selected objects turn and scale about the origin of the world", true},
    {"axes-world", "Tools/A&xes of the handles", "Of the &world", "", "",
     "The handles lie along the axes of the world", true},
    {"axes-own", "Tools/A&xes of the handles", "Of the &object", "", "",
     "The handles lie along the axes of the object selected last", true},
    {"fit", "View", "&Frame all", "Home; F", "fit", "Show the whole scene"},
    {"view-front", "View", "F&ront", "Num+1; Ctrl+1", "view-front", "Look from the front"},
    {"view-right", "View", "R&ight", "Num+3; Ctrl+3", "view-right", "Look from the right"},
    {"view-top", "View", "&Top", "Num+7; Ctrl+7", "view-top", "Look from above"},
    {"view-isometric", "View", "Is&ometric", "Num+0; Ctrl+0", "view-isometric",
     "Look from the corner between them"},
    {"orbit-left", "View/&Camera", "Turn &left", "Num+4; Ctrl+Alt+Left", "", "Look from further left"},
    {"orbit-right", "View/&Camera", "Turn &right", "Num+6; Ctrl+Alt+Right", "", "Look from further right"},
    {"orbit-up", "View/&Camera", "Turn &up", "Num+8; Ctrl+Alt+Up", "", "Look from further above"},
    {"orbit-down", "View/&Camera", "Turn &down", "Num+2; Ctrl+Alt+Down", "", "Look from further below"},
    {"zoom-in", "View/&Camera", "&Nearer", "Num++; Ctrl+Alt+PgUp", "", "Come nearer to the model"},
    {"zoom-out", "View/&Camera", "&Farther", "Num+-; Ctrl+Alt+PgDown", "", "Go away from the model"},
    {"camera-keep", "View/&Camera/&Kept cameras", "&Keep this view...", "", "",
     "Where the view looks from, under a name, saved with the scene", false, true},
    {"split-columns", "View/&Camera/&Split", "&Two side by side", "Ctrl+Alt+2", "",
     "Two views side by side, your own and one from the right; again for one view", true},
    {"split-rows", "View/&Camera/&Split", "Two one &above the other", "Ctrl+Alt+3", "",
     "Two views one above the other, your own and one from the right; again for one view", true},
    {"split-four", "View/&Camera/&Split", "&Four", "Ctrl+Alt+4; Ctrl+Alt+Q", "",
     "Four views, from above, your own, from the front and from the right; again for one view", true},
    {"split-one", "View/&Camera/&Split", "&One view", "Ctrl+Alt+1", "", "Your own view alone", false, true},
    {"overlay", "View", "Finger an&d forces", "Ctrl+T", "overlay", "Show finger, proxy, force and contacts",
     true, true},
    {"contact-normals", "View/&At the contact", "&Normals", "", "", "Where each contact pushes to", true},
    {"contact-planes", "View/&At the contact", "&Planes", "", "",
     "The constraint planes of the proxy as discs, their rims yellow while they stick, violet while they "
     "slip",
     true},
    {"stylus", "View/&At the contact", "A &stylus", "", "",
     "A pen whose tip is the proxy, beside the ball; it leans toward the eye", true},
    {"loupe", "View/&At the contact", "A &loupe", "", "",
     "What is touched from nearby, in a corner of the view; the wheel over it makes it larger", true},
    {"friction-cone", "View/&At the contact", "Friction &cone", "", "cone",
     "The forces that friction holds: the force's arrow lies inside until the contact slips", true},
    {"trail", "View/&At the contact", "&Trail of the proxy", "", "trail",
     "Where the proxy was in the last seconds: beads where it stuck, a line where it slipped", true},
    {"map-stiffness", "View/Colo&ur map", "&Stiffness", "", "", "Colours the surfaces by their stiffness",
     true},
    {"map-damping", "View/Colo&ur map", "&Damping", "", "", "Colours the surfaces by their damping", true},
    {"map-static-friction", "View/Colo&ur map", "S&tatic friction", "", "",
     "Colours the surfaces by their static friction, as their layers make it", true},
    {"map-dynamic-friction", "View/Colo&ur map", "D&ynamic friction", "", "",
     "Colours the surfaces by their dynamic friction, as their layers make it", true},
    {"map-viscosity", "View/Colo&ur map", "&Viscosity", "", "", "Colours the surfaces by their viscosity",
     true},
    {"map-height", "View/Colo&ur map", "&Height of texture", "", "",
     "Colours the surfaces by the sum of their height layers", true},
    {"relief", "View/&Bumps", "In &light and shade", "", "",
     "Height layers tilt the light as they tilt what is felt; the shape stays as it is", true},
    {"bumps-1", "View/&Bumps", "As high as they are &felt", "", "", "Draws the height layers as they are",
     true},
    {"bumps-10", "View/&Bumps", "&Ten times as high", "", "", "Draws the height layers ten times as high",
     true},
    {"bumps-100", "View/&Bumps", "A &hundred times as high", "", "",
     "Draws the height layers a hundred times as high", true},
    {"sound", "View", "&Hear the contact", "", "sound",
     "What the force shakes with, as sound: texture judged without a device", true},
    {"ground", "View/Loo&k", "&Ground and shadow", "", "",
     "A grid of 1, 10 or 100 mm beneath the scene, and the shadow that it casts there", true},
    {"boundaries", "View/Loo&k", "&Lines between surfaces", "", "",
     "A thin line where one surface ends and another begins", true},
    {"wireframe", "View/Loo&k", "&Wireframe", "Shift+Z", "", "The triangles of the model as lines", true},
    {"parallel", "View/Loo&k", "&Parallel projection", "Num+5; Ctrl+5", "",
     "What is far away is as large as what is near", true},
    {"section", "View/Loo&k/&Section plane", "&Cut the model open", "Shift+X", "",
     "A plane with handles cuts the model in the view; what is felt and saved stays whole", true},
    {"section-x", "View/Loo&k/&Section plane", "Across &x", "", "", "Cut across the x axis, in the middle",
     true, true},
    {"section-y", "View/Loo&k/&Section plane", "Across &y", "", "", "Cut across the y axis, in the middle",
     true},
    {"section-z", "View/Loo&k/&Section plane", "Across &z", "", "", "Cut across the z axis, in the middle",
     true},
    {"section-flip", "View/Loo&k/&Section plane", "The &other side", "", "",
     "What was cut away is there, and what was there is cut away", false, true},
    {"felt-normals", "View", "F&elt normals", "N", "normals",
     "Needles along the normals that are felt; the view says where they are not those that are drawn", true},
    {"spheres", "View/&Sphere tree", "&Show", "Ctrl+B", "spheres",
     "The bounding spheres of one level of the collision hierarchy", true},
    {"spheres-finer", "View/&Sphere tree", "One level &finer", "+; =", "",
     "The children of the spheres shown"},
    {"spheres-coarser", "View/&Sphere tree", "One level &coarser", "-", "",
     "The parents of the spheres shown"},
    {"colliders", "View", "&What bodies meet", "Ctrl+Shift+B", "",
     "The hulls, boxes and round shapes as which bodies meet each other, over the model", true},
    {"theme-dark", "View/Loo&k/The&me", "&Dark", "", "", "Light figures on dark grey", true},
    {"theme-light", "View/Loo&k/The&me", "&Light", "", "", "Dark figures on light grey", true},
    {"theme-system", "View/Loo&k/The&me", "Like the &system", "", "", "Dark or light as the desktop is",
     true},
    {"panels", "View", "Hide al&l panels", "F9", "",
     "The view alone; Tab does the same while the view has the focus", true},
    {"present", "View", "Presentation displa&y", "F11", "",
     "The view alone on the whole screen, with larger words and a larger contact; Esc comes back", true},
    {"record-video", "View/&Make a video", "&Record", "Ctrl+Alt+R", "",
     "Write what the view shows as a video, until it is chosen again", true},
    {"video-view", "View/&Make a video", "As large as the &view", "", "", "A video has the size of the view",
     true, true},
    {"video-720", "View/&Make a video", "1280 x &720", "", "", "A video has 1280 x 720 pixels", true},
    {"video-1080", "View/&Make a video", "1920 x &1080", "", "", "A video has 1920 x 1080 pixels", true},
    {"video-plot", "View/&Make a video", "With the &force plot", "", "",
     "The plots that are shown are in the video, beneath the view", true, true},
    {"fold-plots", "View/Foldin&g", "Fold the &plots", "F8", "",
     "Force, health and comparison to their tabs, so that the view has their room", true, true},
    {"fold-lists", "View/Foldin&g", "Fold the &lists", "Shift+F8", "",
     "Presets, problems and history to their tabs, so that the scene has their room", true},
    {"next-panel", "View", "&Next panel", "F6", "", "Give the keys to the next panel", false, true},
    {"previous-panel", "View", "Pre&vious panel", "Shift+F6", "", "Give the keys to the panel before"},
    {"motion-run", "Motion", "&Run", "Ctrl+Space", "play",
     "Let time go on for all that moves: along keys, by its weight, by the hand", true},
    {"motion-slow", "Motion", "&Slow motion", "", "", "A tenth of the pace; the hand keeps its own", true},
    {"motion-step", "Motion", "One st&ep", "Ctrl+.", "", "Stop, and go on by one step of the haptics"},
    {"motion-reset", "Motion", "&Back to the start", "Ctrl+Home", "reset",
     "Everything that moves goes to where it began"},
    {"body-loose", "Motion", "&Loose body", "Ctrl+M", "",
     "The selected object gets a mass, falls, and is pushed by the hand"},
    {"body-hinge", "Motion", "On a &hinge", "", "",
     "The selected object turns about an edge, as its form suggests; the dock Body changes it"},
    {"body-slider", "Motion", "On a sl&ider", "", "",
     "The selected object slides along its length; the dock Body changes it"},
    {"body-path", "Motion", "On a &path", "", "",
     "The selected object rides on a curve, whose points are dragged in the view"},
    {"body-still", "Motion", "S&tanding still", "Ctrl+Shift+M", "", "The selected object moves no more"},
    {"armed", "Device", "&Forces on", "Ctrl+Return", "power",
     "Let the device push. It starts without force and follows", true},
    {"stop", "Device", "&Stop", "", "stop", "Forces off at once; also hold Esc for half a second"},
    {"dead-man", "Device", "Hold the &button to feel", "", "",
     "Force only while a button of the device is held. Of the simulated hand: while the mouse holds the "
     "finger",
     true},
    {"restart-proxy", "Device", "&Put the proxy on the finger", "Ctrl+R", "",
     "Frees a proxy that is on the wrong side of a surface", false, true},
    {"device-panel", "Device", "&Devices", "Ctrl+Shift+D", "",
     "Which devices there are, how the one in use does, and how its workspace lies", false, true},
    {"device-connect", "Device", "&Connect", "", "",
     "Make the device that is chosen in the dock Device ready, step by step"},
    {"device-disconnect", "Device", "D&isconnect", "", "",
     "Give the device back; the mouse leads a simulated hand"},
    {"hand-add", "Device/&Hands", "&Add a device", "Ctrl+Shift+H", "",
     "Make the device that is chosen in the dock Device ready as one more hand"},
    {"hand-next", "Device/&Hands", "&Next hand", "Ctrl+H", "",
     "Status, health, plots and trail are those of the next hand; of a recording's hands while one is shown"},
    {"hand-remove", "Device/&Hands", "&Remove the hand", "Ctrl+Alt+H", "",
     "Give the device of the chosen hand back. The forces of all hands are off then"},
    {"rumble", "Device/&Gamepad", "&Vibrate with what is felt", "", "",
     "A gamepad shakes as the force does, with the mouse, a device or a recording: texture, slips and "
     "impacts",
     true},
    {"workspace-centre", "Device", "Re-c&entre the workspace", "Ctrl+Shift+Home", "",
     "The middle of the device's workspace comes to the middle of the model", false, true},
    {"workspace-fit", "Device", "Fit the &workspace to the model", "", "",
     "Centred, and scaled so that the device's workspace takes in the model"},
    {"workspace-axes", "Device", "Set the a&xes by moving", "", "",
     "Move the handle to the right, up and toward you: the axes follow from that"},
    {"self-test", "Device", "Se&lf-test...", "", "",
     "Measure the device in about ten minutes: what it really is, and what about it is wrong"},
    {"trial-spring", "Device/Try i&t", "&Spring to the centre", "", "",
     "A gentle spring to the middle of the device's workspace, instead of the scene", true},
    {"trial-wall", "Device/Try i&t", "&Wall", "", "", "A stiff wall, instead of the scene", true},
    {"trial-friction", "Device/Try i&t", "&Plate with friction", "", "",
     "A plate that holds and slides, instead of the scene", true},
    {"trial-end", "Device/Try i&t", "&Back to the scene", "", "", "Feel the scene again", false, true},
    {"record-stroke", "Compare", "&Record a stroke", "Ctrl+Shift+K", "",
     "Remember what the finger does until it is chosen again", true},
    {"take-stroke", "Compare", "&Take the last 10 s", "", "",
     "The stroke is what the finger did in the last ten seconds"},
    {"mark-a", "Compare", "&Mark as A", "Ctrl+Shift+A", "",
     "The scene as it is now is what edits are held against", false, true},
    {"swap-ab", "Compare", "&Swap A and B", "Ctrl+Shift+X", "",
     "The scene becomes A again, and A what the scene was"},
    {"compare-now", "Compare", "&Compare now", "Ctrl+Shift+C", "", "The stroke is felt in A and in the scene",
     false, true},
    {"compare-auto", "Compare", "After &each edit", "", "", "Each edit is compared with A at once", true},
    {"compare-csv", "Compare", "E&xport CSV...", "", "", "Both forces of each step of the stroke", false,
     true},
    {"study-keep", "Study", "&Keep this state as...", "Ctrl+K", "",
     "The scene as it is now becomes a condition of the study, under a name"},
    {"study-replace", "Study", "Repla&ce the condition", "", "",
     "The condition that is chosen in the dock Study becomes the scene as it is now"},
    {"study-show", "Study", "S&how the condition", "", "", "The scene becomes the chosen condition again"},
    {"study-remove", "Study", "Re&move the condition", "", "", "The study goes on without it"},
    {"study-edit", "Study", "&Procedure and questions...", "", "",
     "What a trial is, in which order trials come, and what is asked", false, true},
    {"study-run", "Study", "&Run with a participant...", "", "",
     "Answers and touch are logged as CSV; Esc ends it", false, true},
    {"study-new", "Study", "&New study", "", "", "Without conditions", false, true},
    {"study-open", "Study", "&Open a study...", "", "", "Its conditions, procedure and questions"},
    {"study-save", "Study", "&Save the study as...", "", "", "One file with the conditions in it"},
    {"guide", "Help", "&Guide", "", "", "How to do things, task by task"},
    {"keyboard", "Help", "&Keyboard", "F1", "keyboard", "All keys on one page"},
    {"about", "Help", "&About Tactum", "", "", "Version and licence"},
};

constexpr Manner kManners[] = {
    {"Drag on the model", "press the finger into the surface and stroke it (touch tool)"},
    {"Drag on the model, paint tool",
     "paint; with Ctrl take away, with Shift smooth, Esc gives the stroke up"},
    {"Drag, select tool with the brush", "select; with Shift more, with Ctrl less, Esc gives the stroke up"},
    {"Drag the finger", "move it in the plane of the camera"},
    {"Wheel, Ctrl+drag while touching", "move the finger along the view"},
    {"G",
     "the finger follows the mouse until a click or Esc; with the select tool: move the layer's mapping"},
    {"G, R, S, move tool",
     "move, turn, scale the selected objects with the mouse, or by a number that is typed; "
     "X, Y, Z keep to an axis, a click or Enter ends it"},
    {"Drag of a handle",
     "Ctrl snaps to 5 mm, 15 degrees and 0.1, Shift is ten times finer, Esc or the right button gives it up"},
    {"Del, Ctrl+D, Alt+Up, Alt+Down", "in the list of layers: remove, duplicate, move"},
    {"Space, S, F2", "in the list of layers: switch on or off, solo, rename"},
    {"Arrows, Page Up, Page Down", "nudge the finger"},
    {"Middle drag, Alt+drag", "orbit; with Shift pan"},
    {"Wheel", "zoom to the cursor"},
    {"Alt+1 to Alt+9", "look from a camera that is kept, in the order of View > Camera > Kept cameras"},
    {"Right button", "what can be done with the object there, or with the scene"},
    {"Tab in the view", "hide or show all panels"},
    {"Space, Left, Right, Up, Down",
     "in a recording: play or pause, a hundredth of a second back or on, faster or slower"},
    {"Space, Enter", "in a study: go on; each answer names its key, R feels again, Esc asks whether to end"},
    {"Hold Esc for half a second", "forces off"},
};

/// Those of File, View and Help that change the document, and of the others those that change nothing.
constexpr std::string_view kLive[] = {"update-geometry", "camera-keep"};
constexpr std::string_view kLooking[] = {"palette",      "preferences",  "next-panel",    "previous-panel",
                                         "measure",      "measure-copy", "measure-clear", "hand-next",
                                         "device-panel", "rumble"};

constexpr auto kWhyNot = "why-not";

QList<QKeySequence> keysOf(const Command& command) {
    QList<QKeySequence> keys;
    for (const QString& part :
         QString::fromLatin1(command.keys).split(QStringLiteral("; "), Qt::SkipEmptyParts))
        keys << QKeySequence::fromString(part, QKeySequence::PortableText);
    return keys;
}

QString tooltipOf(const Command& command) {
    const QList<QKeySequence> keys = keysOf(command);
    const QString sentence = QObject::tr(command.sentence);
    return keys.isEmpty()
               ? sentence
               : QStringLiteral("%1 (%2)").arg(sentence, keys.front().toString(QKeySequence::NativeText));
}

/// The menu of that name; made at the end of its parent when it is not there yet.
QMenu* menuOf(QMenuBar& bar, const QString& name, QString& used) {
    if (auto* known = bar.findChild<QMenu*>(name)) return known;
    const QString parent = name.section(u'/', 0, -2), title = QObject::tr(qPrintable(name.section(u'/', -1)));
    QMenu* menu =
        parent.isEmpty() ? bar.addMenu(withMnemonic(title, used)) : menuOf(bar, parent, used)->addMenu(title);
    menu->setObjectName(name);
    return menu;
}

} // namespace

std::span<const Command> commands() {
    return kCommands;
}
std::span<const Manner> viewManners() {
    return kManners;
}

bool isLive(const Command& command) {
    const std::string_view id = command.id, menu = command.menu;
    if (menu == "File" || menu.starts_with("View") || menu == "Help")
        return std::ranges::count(kLive, id) > 0;
    return std::ranges::count(kLooking, id) == 0;
}

Actions::Actions(QObject* parent) : QObject(parent), live_(*new QActionGroup(this)) {
    live_.setExclusionPolicy(QActionGroup::ExclusionPolicy::None);
    for (const Command& command : kCommands) {
        auto* action = new QAction(tr(command.text), this);
        action->setObjectName(QString::fromLatin1(command.id));
        action->setShortcuts(keysOf(command));
        action->setToolTip(tooltipOf(command));
        action->setCheckable(command.checkable);
        actions_[command.id] = action;
        if (isLive(command)) live_.addAction(action);
    }
    refreshIcons();
}

QAction& Actions::operator[](const char* id) const {
    return *actions_.at(id);
}

void Actions::allow(const char* id, const QString& whyNot) const {
    QAction& action = *actions_.at(id);
    action.setEnabled(whyNot.isEmpty());
    action.setProperty(kWhyNot, whyNot);
    const auto command = std::ranges::find(kCommands, std::string_view(id), &Command::id);
    action.setToolTip(whyNot.isEmpty() ? tooltipOf(*command) : whyNot);
}

QString Actions::whyNot(const QString& id) const {
    const QAction& action = *actions_.at(id.toStdString());
    return action.isEnabled() ? QString() : action.property(kWhyNot).toString();
}

void Actions::setLive(bool live) const {
    live_.setEnabled(live);
}

void Actions::fill(QMenuBar& bar) const {
    QString used = QStringLiteral("ahn"); // Alt+A, Alt+H and Alt+N are commands
    for (const Command& command : kCommands) {
        QMenu* menu = menuOf(bar, QString::fromLatin1(command.menu), used);
        if (command.separatorBefore) menu->addSeparator();
        menu->addAction(actions_.at(command.id));
    }
}

void Actions::refreshIcons() const {
    for (const Command& command : kCommands)
        if (*command.icon) actions_.at(command.id)->setIcon(icon(QString::fromLatin1(command.icon)));
}

} // namespace tactum
