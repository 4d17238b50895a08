"""How materials feel in Tactum, shown in Blender and kept when glTF is exported.

Tactum writes the feel of a surface into a glTF file twice: as the extension TACTUM_haptics, which Blender drops, and as
extras of the material, which Blender shows as custom properties. This add-on shows them with units and ranges, in
Properties > Material > Feel, and writes them into every glTF that Blender exports, whether "Custom Properties" is
ticked there or not. Tactum reads them again.

To install: Edit > Preferences > Add-ons > Install, choose this file, tick it. For Blender 3.4 and later.
"""

import bpy

bl_info = {
    "name": "Tactum: haptic materials",
    "author": "The Tactum authors",
    "version": (1, 0, 0),
    "blender": (3, 4, 0),
    "location": "Properties > Material > Feel",
    "description": "Shows how materials feel in Tactum, and keeps it in exported glTF",
    "category": "Material",
}

PREFIX = "tactum_"

# A property with label, unit, lowest, highest and initial value: those of Tactum's own table, which a test compares.
NUMBERS = [
    ("tactum_stiffness", "Stiffness", "N/m", 1, 10000, 800),
    ("tactum_damping", "Damping", "N s/m", 0, 20, 0),
    ("tactum_static_friction", "Static friction", "", 0, 2, 0),
    ("tactum_dynamic_friction", "Dynamic friction", "", 0, 2, 0),
    ("tactum_viscosity", "Viscosity", "N s/m", 0, 50, 0),
]


def has_feel(material):
    return any(key.startswith(PREFIX) for key in material.keys())


def feel_of(element):
    """What is ours among the custom properties: numbers and words."""
    return {
        key: value
        for key, value in element.items()
        if key.startswith(PREFIX) and isinstance(value, (int, float, str))
    }


class TactumAddFeel(bpy.types.Operator):
    """Give the material the values that a surface has in Tactum at first"""

    bl_idname = "material.tactum_add_feel"
    bl_label = "Add a feel"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        return context.material is not None

    def execute(self, context):
        material = context.material
        for key, label, unit, low, high, initial in NUMBERS:
            if key not in material:
                material[key] = float(initial)
            described = f"{label}, {unit}" if unit else label
            material.id_properties_ui(key).update(min=low, max=high, description=described)
        return {"FINISHED"}


class TactumFeelPanel(bpy.types.Panel):
    bl_label = "Feel"
    bl_idname = "MATERIAL_PT_tactum_feel"
    bl_space_type = "PROPERTIES"
    bl_region_type = "WINDOW"
    bl_context = "material"

    @classmethod
    def poll(cls, context):
        return context.material is not None

    def draw(self, context):
        layout = self.layout
        material = context.material
        layout.use_property_split = True
        known = [number[0] for number in NUMBERS]
        for key, label, unit, *_ in NUMBERS:
            if key in material:
                layout.prop(material, f'["{key}"]', text=f"{label} ({unit})" if unit else label)
        for key in feel_of(material):
            if key == "tactum_layers":
                layout.label(text="Layers of texture come along, without their pictures")
            elif key not in known:
                words = key[len(PREFIX):].replace("_", " ").capitalize()
                layout.prop(material, f'["{key}"]', text=words)
        if not all(key in material for key in known):
            layout.operator(TactumAddFeel.bl_idname)


class glTF2ExportUserExtension:  # the name that Blender's exporter looks for
    def add(self, gltf2_element, blender_element):
        feel = feel_of(blender_element) if blender_element else {}
        if feel:
            gltf2_element.extras = {**(gltf2_element.extras or {}), **feel}

    def gather_material_hook(self, gltf2_material, blender_material, export_settings):
        self.add(gltf2_material, blender_material)

    def gather_scene_hook(self, gltf2_scene, blender_scene, export_settings):
        self.add(gltf2_scene, blender_scene)


CLASSES = (TactumAddFeel, TactumFeelPanel)


def register():
    for each in CLASSES:
        bpy.utils.register_class(each)


def unregister():
    for each in reversed(CLASSES):
        bpy.utils.unregister_class(each)


if __name__ == "__main__":
    register()
