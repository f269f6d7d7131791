package org.robotui.architecture.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class BuildOrderRuleTest {

  @TempDir
  Path folder;
  private Fixture fixture;

  @BeforeEach
  void aBundleWhoseTestsUseAnother() {
    fixture = new Fixture(folder).bundle("org.robotui.ui").bundle("org.robotui.core")
        .file("bundles/org.robotui.ui/build.properties",
            "source.. = src/\nadditional.bundles = org.robotui.api,\\\n org.robotui.core\n");
  }

  @Test
  void accepts_what_needs_nothing_of_the_tested_bundle() {
    assertEquals(List.of(), fixture.violationsOf(new BuildOrderRule()));
  }

  @Test
  void refuses_what_imports_the_tested_bundle() {
    fixture.bundle("org.robotui.core", "Import-Package: org.robotui.ui;resolution:=optional");

    assertEquals(List.of("org.robotui.ui: its tests use org.robotui.core, which needs it: neither can be built first"),
        fixture.violationsOf(new BuildOrderRule()));
  }

  @Test
  void refuses_what_needs_the_tested_bundle_by_way_of_another() {
    fixture.bundle("org.robotui.core", "Import-Package: org.robotui.data").bundle("org.robotui.data",
        "Import-Package: org.robotui.ui");

    assertEquals(List.of("org.robotui.ui: its tests use org.robotui.core, which needs it: neither can be built first"),
        fixture.violationsOf(new BuildOrderRule()));
  }
}
