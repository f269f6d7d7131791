package org.robotui.architecture.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ReservedPackagesRuleTest {

  @TempDir
  Path folder;

  @ParameterizedTest
  @CsvSource({
      "org.robotui.core,     org.eclipse.swt.graphics",
      "org.robotui.rfic.ros, org.eclipse.jface.action",
      "org.robotui.uic.map,  org.eclipse.ui",
      "org.robotui.headless, org.eclipse.swt.widgets"})
  void refuses_what_is_reserved_for_others(String bundle, String used) {
    List<String> violations = violations(bundle, used);

    assertEquals(1, violations.size());
    assertTrue(violations.getFirst().startsWith(bundle + "/META-INF/MANIFEST.MF: uses " + used + ", which only"),
        violations.getFirst());
  }

  @ParameterizedTest
  @CsvSource({
      "org.robotui.uic.map,   org.eclipse.swt.graphics",
      "org.robotui.workbench, org.eclipse.ui"})
  void accepts_its_users(String bundle, String used) {
    assertEquals(List.of(), violations(bundle, used));
  }

  @Test
  void sees_sources_too() {
    Fixture fixture = new Fixture(folder).bundle("org.robotui.core")
        .source("org.robotui.core", "org.robotui.core.internal.Box",
            "class Box { org.eclipse.swt.widgets.Button button; }");

    assertEquals(1, fixture.violationsOf(new ReservedPackagesRule()).size());
  }

  private List<String> violations(String bundle, String used) {
    return new Fixture(folder).bundle(bundle, "Import-Package: " + used).violationsOf(new ReservedPackagesRule());
  }
}
