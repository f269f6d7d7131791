"""Makes the small update sites that README.md lists:  python3 tests/sample-site/sample_sites.py FOLDER"""
import os
import pathlib
import re
import subprocess
import sys
import zipfile

HERE = pathlib.Path(__file__).resolve().parent
PRODUCT = HERE.parents[1] / "product/target"
PUBLISHER = PRODUCT / "products/org.robotui.headless.product/linux/gtk/x86_64/robotui"
LINE, TRIP = "org.robotui.rfic.line", "org.robotui.uic.trip"
SITES = {
    "one": (LINE, "org.example.feature.line", "Robots that speak lines", "1.0.0", ""),
    "two": (LINE, "org.example.feature.line", "Robots that speak lines", "2.0.0", ""),
    "view": (TRIP, "org.example.feature.trip", "A trip of a robot", "1.0.0", ""),
    "lacking": (LINE, "org.example.feature.lacking", "Lines by radio", "1.0.0", '<requires><import plugin="org.example.radio" version="3.0.0" match="compatible"/></requires>'),
}


def make(folder, name):
    """One site, from its sources."""
    plugin, feature, label, version, needs = SITES[name]
    sources = folder / f"{name}-sources"
    for part in ("plugins", "features"):
        (sources / part).mkdir(parents=True)
    (built,) = (PRODUCT / "repository/plugins").glob(f"{plugin}_*.jar")
    bundle = f"{version}.sample"
    with_version(built, sources / f"plugins/{plugin}_{bundle}.jar", bundle)
    text = (HERE / "feature.xml.in").read_text(encoding="utf-8")
    for word, value in {"id": feature, "label": label, "version": version, "plugin": plugin, "bundle": bundle, "needs": needs}.items():
        text = text.replace(f"@{word}@", value)
    with zipfile.ZipFile(sources / f"features/{feature}_{version}.jar", "w") as jar:
        jar.writestr("feature.xml", text)
    publish(sources, folder / name)
    return folder / name


def with_version(built, jar, version):
    """The same bundle as another version."""
    with zipfile.ZipFile(built) as source, zipfile.ZipFile(jar, "w", zipfile.ZIP_DEFLATED) as target:
        for entry in source.infolist():
            content = source.read(entry)
            if entry.filename == "META-INF/MANIFEST.MF":
                content = re.sub(rb"(?m)^Bundle-Version: .*?(\r?)$", f"Bundle-Version: {version}".encode() + rb"\1", content)
            target.writestr(entry.filename, content)


def publish(sources, site):
    done = subprocess.run([PUBLISHER, "-application", "org.eclipse.equinox.p2.publisher.FeaturesAndBundlesPublisher", "-source", sources,
                           "-metadataRepository", site.as_uri(), "-artifactRepository", site.as_uri(), "-publishArtifacts", "-compress"],
                          env=dict(os.environ) | {"ROBOTUI_VMARGS": "-XX:TieredStopAtLevel=1"}, stdin=subprocess.DEVNULL, text=True, capture_output=True, timeout=120, check=False)
    assert done.returncode == 0, done.stdout + done.stderr


if __name__ == "__main__":
    for each in SITES:
        print(make(pathlib.Path(sys.argv[1]).resolve(), each))
