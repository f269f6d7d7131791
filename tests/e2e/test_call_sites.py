"""Call sites in the products' jars are linked ahead of time (docs/adr/0153)."""
import os
import pathlib
import re
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]
TOOL = ROOT / "product/target/callsites"
PLUGINS = ROOT / "product/target/products/org.robotui.workbench.product/linux/gtk/x86_64/plugins"
SOURCES = pathlib.Path(__file__).with_name("callsites")


def test_what_is_linked_ahead_of_time_does_the_same(tmp_path):
    classes, jar = tmp_path / "classes", tmp_path / "samples.jar"
    run("javac", "--release", "21", "-d", classes, "-sourcepath", SOURCES, SOURCES / "Samples.java")
    run("jar", "--create", "--file", jar, "-C", classes, ".")
    expected = run("java", "-cp", jar, "Samples")

    run("java", "-cp", TOOL, "callsites.CallSites", r"samples\.jar", jar)

    assert "below open b" in expected
    assert run("java", "-Xverify:all", "-cp", jar, "Samples") == expected
    assert left(jar, "Samples", "Samples$Box") == {"run", "toString"}      # of what can be serialized, and of a record


def test_of_lambdas_in_a_product_few_are_left_to_the_virtual_machine():
    (core,) = PLUGINS.glob("org.robotui.core_*.jar")
    names = [name for name in run("jar", "--list", "--file", core).splitlines() if name.endswith(".class")]

    assert sum("$$Lambda" in name for name in names) > 500
    assert left(core, *(name.removesuffix(".class") for name in names if "$$Lambda" not in name)) == {"toString"}


def left(jar, *names):
    """What the virtual machine is to link, but for strings that are put together."""
    text = run("javap", "-cp", jar, "-p", "-v", *names)
    return set(re.findall(r"= InvokeDynamic +#\d+:#\d+ +// #\d+:(\w+):", text)) - {"makeConcatWithConstants"}


def run(tool, *arguments):
    program = pathlib.Path(os.environ["JAVA_HOME"]) / "bin" / tool
    return subprocess.run([program, *arguments], check=True, text=True, stdout=subprocess.PIPE, timeout=120).stdout
