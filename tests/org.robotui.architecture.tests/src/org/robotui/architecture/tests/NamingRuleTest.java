package org.robotui.architecture.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class NamingRuleTest {

  @TempDir
  Path folder;
  private Fixture fixture;

  @BeforeEach
  void aBundleThatIsRight() {
    fixture = new Fixture(folder).bundle("org.robotui.data", "Export-Package: org.robotui.data")
        .source("org.robotui.data", "org.robotui.data.Scan", "class Scan { }")
        .source("org.robotui.data", "org.robotui.data.internal.Check", "class Check { }");
  }

  @Test
  void accepts_exported_and_internal_packages_under_the_bundles_name() {
    assertEquals(List.of(), violations());
  }

  @Test
  void refuses_another_symbolic_name() {
    fixture.file("bundles/org.robotui.data/META-INF/MANIFEST.MF",
        "Manifest-Version: 1.0\nBundle-SymbolicName: org.robotui.dta;singleton:=true\nExport-Package: org.robotui.data\n");

    assertEquals(List.of("org.robotui.data: its Bundle-SymbolicName is org.robotui.dta"), violations());
  }

  @Test
  void refuses_a_package_outside_the_bundles_name() {
    fixture.source("org.robotui.data", "org.robotui.database.Scan", "class Scan { }");

    assertEquals(
        List.of("org.robotui.data/src/org/robotui/database/Scan.java: lies outside the package org.robotui.data"),
        violations());
  }

  @Test
  void refuses_a_package_line_that_differs_from_the_folder() {
    fixture.file("bundles/org.robotui.data/src/org/robotui/data/Other.java",
        "package org.robotui.other;\nclass Other { }");

    assertEquals(List.of("org.robotui.data/src/org/robotui/data/Other.java: lies outside the package org.robotui.data"),
        violations());
  }

  @Test
  void refuses_a_package_that_is_neither_exported_nor_internal() {
    fixture.source("org.robotui.data", "org.robotui.data.secret.Scan", "class Scan { }");

    assertEquals(List.of("org.robotui.data: the package org.robotui.data.secret is neither exported nor internal"),
        violations());
  }

  @Test
  void accepts_the_package_of_a_main_class() {
    fixture.source("org.robotui.data", "org.robotui.data.tool.Main",
        "class Main { public static void main(String[] a) { } }");

    assertEquals(List.of(), violations());
  }

  private List<String> violations() {
    return fixture.violationsOf(new NamingRule());
  }
}
