package org.robotui.architecture.tests;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/** A small repository made for one test, in which everything is right until the test breaks it. */
final class Fixture {

  static final String LAYERS = """
      # as in the real file
      0c  for 0d 4 org.robotui.ros
      0d  for none org.robotui.sim
      1            org.robotui.data
      2            org.robotui.api
      3   for none org.robotui.core
      4   for none org.robotui.rfic.*
      5            org.robotui.ui
      6            org.robotui.entity.*
      7   for none org.robotui.uic.*
      8   for none org.robotui.ruic.*
      9   for none org.robotui.workbench  org.robotui.headless
      """;

  private final Path root;

  Fixture(Path root) {
    this.root = root;
    file("bundles/LAYERS", LAYERS);
    file("ARCHITECTURE.md", "");
  }

  /** Adds a bundle with these further manifest headers. */
  Fixture bundle(String name, String... headers) {
    return file("bundles/" + name + "/META-INF/MANIFEST.MF",
        "Manifest-Version: 1.0\nBundle-SymbolicName: " + name + "\n"
            + String.join("", List.of(headers).stream().map(header -> header + "\n").toList()));
  }

  /** Adds a source to a bundle: a type by its full name, and the text after its package line. */
  Fixture source(String bundle, String type, String text) {
    String packageName = type.substring(0, type.lastIndexOf('.'));
    return file("bundles/" + bundle + "/src/" + type.replace('.', '/') + ".java",
        "package " + packageName + ";\n" + text);
  }

  Fixture file(String path, String text) {
    try {
      Path file = root.resolve(path);
      Files.createDirectories(file.getParent());
      Files.writeString(file, text);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return this;
  }

  List<String> violationsOf(Rule rule) {
    return rule.violations(Repository.at(root)).map(Violation::toString).toList();
  }
}
