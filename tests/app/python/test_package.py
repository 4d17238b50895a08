"""The package as one thing: halves that need each other not, stubs that say what there is, docstrings on everything."""
import ast
import inspect
import pathlib
import subprocess
import sys
import unittest

import tactum
from tactum import _tactum

sys.argv.pop()  # the samples
FOLDER = pathlib.Path(tactum.__file__).parent


def stub(name):
    return ast.parse((FOLDER / name).read_text())


class Halves(unittest.TestCase):
    def run_without(self, modules, words):
        block = "import sys\n" + "".join(f"sys.modules[{name!r}] = None\n" for name in modules)
        return subprocess.run([sys.executable, "-c", block + words], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              text=True).stdout

    def test_scenes_need_no_grpc(self):
        words = "import tactum\nprint(tactum.Scene(), 'grpc' in sys.modules and sys.modules['grpc'])"
        self.assertEqual(self.run_without(["grpc", "google.protobuf"], words), "<Scene of 0 objects, 0 triangles> None\n")
        said = self.run_without(["grpc"], "import tactum\ntry: tactum.serve\nexcept tactum.Error as error: print(error)")
        self.assertEqual(said, "there is no grpc; the server's client needs python3-grpcio and python3-protobuf: install "
                         "them\n")

    def test_the_server_needs_no_compiled_part(self):
        said = self.run_without(["tactum._tactum"], "import tactum\nprint(tactum.Client.__name__)\n"
                                "try: tactum.open\nexcept tactum.Error as error: print(error)")
        self.assertEqual(said, "Client\nthere is no tactum._tactum; this build has no compiled part: install pybind11-dev "
                         "and python3-dev, and build again\n")

    def test_importing_is_quick_and_loads_neither(self):
        said = self.run_without([], "import tactum\nprint([m for m in ('grpc', 'tactum._tactum') if m in sys.modules])")
        self.assertEqual(said, "[]\n")

    def test_all_names_are_there(self):
        for name in tactum.__all__:
            self.assertIsNotNone(getattr(tactum, name), name)
        self.assertEqual(set(dir(tactum)), set(tactum.__all__))


class Stubs(unittest.TestCase):
    def test_they_name_what_there_is(self):
        said = {node.name: node for node in stub("_tactum.pyi").body if isinstance(node, (ast.ClassDef, ast.FunctionDef))}
        there = {name for name, what in vars(_tactum).items() if not name.startswith("_") and callable(what)}
        self.assertEqual(set(said), there)
        for name in there:
            what = getattr(_tactum, name)
            if not inspect.isclass(what):
                continue
            members = {node.name for node in said[name].body if isinstance(node, ast.FunctionDef)}
            public = {member for member in vars(what) if not member.startswith("_")}
            self.assertEqual({member for member in members if not member.startswith("_")}, public, name)

    def test_the_package_names_the_same(self):
        names = {alias.asname for node in stub("__init__.pyi").body for alias in node.names}
        self.assertEqual(names, set(tactum.__all__))
        self.assertTrue((FOLDER / "py.typed").exists())

    def test_no_type_is_left_open(self):
        text = (FOLDER / "_tactum.pyi").read_text()
        for word in ("handle", "pybind11", "std::", "tactum._tactum."):
            self.assertNotIn(word, text)
        for node in ast.walk(stub("_tactum.pyi")):
            if isinstance(node, ast.FunctionDef) and node.name != "__init__":
                self.assertIsNotNone(node.returns, node.name)


class Docstrings(unittest.TestCase):
    def test_everything_public_has_one(self):
        for name, what in vars(_tactum).items():
            if name.startswith("_") or name == "parameters":
                continue
            self.assertGreater(len(what.__doc__), 20, name)
            if not inspect.isclass(what):
                continue
            for member, value in vars(what).items():
                if not member.startswith("_"):
                    doc = value.__doc__
                    if not isinstance(value, property):
                        doc = doc.partition("\n\n")[2]  # without the signature
                    self.assertGreater(len(doc), 10, f"{name}.{member}")

    def test_lengths_and_forces_say_their_unit(self):
        for parameter in tactum.parameters.values():
            if parameter.of == "surface":
                self.assertIn(parameter.unit, getattr(tactum.Surface, parameter.name).__doc__)
        self.assertIn("force (n, 3) in N", tactum.Scene.touch.__doc__)


class Symbols(unittest.TestCase):
    def test_nobody_sees_the_core(self):
        module, = FOLDER.glob("_tactum.*.so")
        names = subprocess.run(["nm", "-D", "--defined-only", module], check=True, stdout=subprocess.PIPE, text=True).stdout
        self.assertIn("PyInit__tactum", names)
        for word in ("6tactum", "8tinygltf", "Eigen"):
            self.assertNotIn(word, names)


if __name__ == "__main__":
    unittest.main(verbosity=2)
