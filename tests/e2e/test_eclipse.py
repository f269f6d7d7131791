"""What ./robotui new makes outside of the repository, in the hands of Eclipse's own tools for Java and plug-ins, without their windows."""
import os
import pathlib
import re
import shutil
import subprocess
import zipfile

import pytest

from conftest import ROOT, needs_long
from test_new_bundle import KINDS, maven, new
from test_product import PRODUCTS, UPDATE_SITE

SOURCES = pathlib.Path(__file__).parent / "eclipse"
COPY = ("org.apache.maven.plugins:maven-dependency-plugin:3.8.1:copy-dependencies", "-q")
FOR_TESTS = re.compile(r"junit-|opentest4j|apiguardian|component\.annotations")
LOGGING = "org.robotui.logging"                      # SLF4J resolves with it alone
START = {"org.eclipse.equinox.common": "@2:start", "org.eclipse.equinox.event": "@2:start", "org.apache.felix.scr": "@2:start"}
# PDE's builder of descriptors needs windows: who opens the project in Eclipse has it, and the folder that it writes.
OF_DESCRIPTORS = 'build.properties:3: The folder "OSGI-INF/" does not exist in the workspace'


def name_of(jar):
    """The symbolic name of a bundle, or none."""
    with zipfile.ZipFile(jar) as content:
        if "META-INF/MANIFEST.MF" not in content.namelist():
            return None
        manifest = content.read("META-INF/MANIFEST.MF").decode().replace("\r", "").replace("\n ", "")
    found = re.search(r"^Bundle-SymbolicName: *([^;\s]+)", manifest, re.MULTILINE)
    return found and found.group(1)


def java(tool):
    home = os.environ.get("JAVA_HOME")
    return pathlib.Path(home) / "bin" / tool if home else tool


class Ide:
    """The bundles of our own product's platform, which has the installer's, and those of the IDE."""

    def __init__(self, folder):
        self.folder = folder
        maven(folder, "-f", SOURCES / "pom.xml", *COPY, f"-DoutputDirectory={folder}/jars")
        self.junit = folder / "junit"
        self.junit.mkdir()
        for jar in filter(lambda jar: FOR_TESTS.search(jar.name), list((folder / "jars").iterdir())):
            shutil.move(jar, self.junit)
        self.bundles = {}
        for jar in [*(PRODUCTS["workbench"] / "plugins").glob("*.jar"), *sorted((folder / "jars").iterdir())]:
            name = name_of(jar)
            if name and (name == LOGGING or not name.startswith("org.robotui")):
                self.bundles.setdefault(name, jar)
        self.bundles["org.robotui.tests.eclipse"] = self._application()
        self._configure()

    def _application(self):
        classes = self.folder / "classes"
        path = ":".join(map(str, self.bundles.values()))
        subprocess.run([java("javac"), "--release", "21", "-d", classes, "-cp", path, SOURCES / "ProjectBuild.java"], check=True)
        jar = self.folder / "build.jar"
        subprocess.run([java("jar"), "cfm", jar, SOURCES / "MANIFEST.MF", "-C", classes, ".", "-C", SOURCES, "plugin.xml"], check=True)
        return jar

    def _configure(self):
        framework, extension = (self.bundles[name] for name in ("org.eclipse.osgi", "org.eclipse.osgi.compatibility.state"))
        installed = ",".join(f"reference:file:{jar}{START.get(name, '')}" for name, jar in self.bundles.items() if jar not in (framework, extension))
        configuration = self.folder / "configuration"
        configuration.mkdir()
        (configuration / "config.ini").write_text(f"osgi.framework=file:{framework}\nosgi.framework.extensions=reference:file:{extension}\n"
                                                  f"osgi.bundles={installed}\nosgi.bundles.defaultStartLevel=4\neclipse.p2.data.area=@config.dir/p2\n",
                                                  encoding="utf-8")

    def build(self, project):
        """Problems, and the line that says what was done."""
        command = [java("java"), "-jar", self.bundles["org.eclipse.equinox.launcher"], "-nosplash", "-install", self.folder,
                   "-configuration", self.folder / "configuration", "-data", self.folder / "workspace", "-application", "org.robotui.tests.eclipse.build", project, self.junit]
        done = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=500, check=False)
        lines = done.stdout.splitlines()
        assert lines and lines[-1].startswith("projects: "), done.stdout + done.stderr
        return [line for line in lines if line.startswith(("error ", "warning "))], lines[-1]


@needs_long
def test_eclipse_imports_resolves_and_builds_bundles_of_every_kind(tmp_path):
    if not (UPDATE_SITE / "p2.index").exists():
        pytest.skip("there is no update site: ./robotui package makes it")
    project = tmp_path / "acme"
    for kind in KINDS:
        made = new(ROOT, kind, f"acme.my_{kind}", "--in", project)
        assert made.returncode == 0, made.stderr

    problems, done = Ide(tmp_path).build(project)

    assert not [problem for problem in problems if OF_DESCRIPTORS not in problem]
    assert done.startswith(f"projects: {2 * len(KINDS) + 1}, ") and f"launch configurations: {len(KINDS) + 1}, " in done, done
    for kind in KINDS:
        assert list((project / f"bundles/acme.my_{kind}/bin").rglob("*Type.class")), kind
        assert list((project / f"bundles/acme.my_{kind}/bin_test").rglob("*Test.class")), kind
