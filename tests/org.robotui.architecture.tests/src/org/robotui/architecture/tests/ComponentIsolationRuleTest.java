package org.robotui.architecture.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ComponentIsolationRuleTest {

  @TempDir
  Path folder;
  private Fixture fixture;

  @BeforeEach
  void componentsThatAreRight() {
    fixture = new Fixture(folder).bundle("org.robotui.uic.map", "Import-Package: org.robotui.entity.scan")
        .bundle("org.robotui.entity.scan").bundle("org.robotui.rfic.ros").bundle("org.robotui.ruic.single");
  }

  @Test
  void accepts_a_view_that_uses_an_entity() {
    assertEquals(List.of(), violations());
  }

  @Test
  void refuses_a_view_that_knows_a_framework_component() {
    fixture.bundle("org.robotui.uic.map", "Import-Package: org.robotui.rfic.ros");

    assertEquals(List.of(
        "org.robotui.uic.map/META-INF/MANIFEST.MF: uses org.robotui.rfic.ros of the component org.robotui.rfic.ros"),
        violations());
  }

  @Test
  void refuses_a_robot_ui_that_knows_a_view_by_class() {
    fixture.source("org.robotui.ruic.single", "org.robotui.ruic.single.internal.Single",
        "import org.robotui.uic.map.MapView;\nclass Single { }");

    assertEquals(1, violations().size());
  }

  @Test
  void refuses_a_robot_ui_that_knows_an_entity() {
    fixture.bundle("org.robotui.ruic.single", "Import-Package: org.robotui.entity.scan");

    assertEquals(1, violations().size());
  }

  private List<String> violations() {
    return fixture.violationsOf(new ComponentIsolationRule());
  }
}
