package org.robotui.architecture.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class LayerRuleTest {

  @TempDir
  Path folder;
  private Fixture fixture;

  @BeforeEach
  void twoBundlesThatAreRight() {
    fixture = new Fixture(folder).bundle("org.robotui.data")
        .bundle("org.robotui.core", "Import-Package: org.robotui.data").bundle("org.robotui.ros");
  }

  @Test
  void accepts_an_arrow_down() {
    assertEquals(List.of(), violations());
  }

  @Test
  void refuses_an_upward_import_in_a_manifest() {
    fixture.bundle("org.robotui.data", "Import-Package: org.slf4j;version=\"[2.0,3)\",org.robotui.core.run");

    assertEquals(List.of("org.robotui.data/META-INF/MANIFEST.MF: layer 1 uses org.robotui.core.run of layer 3"),
        violations());
  }

  @Test
  void refuses_an_upward_requirement_of_a_bundle() {
    fixture.bundle("org.robotui.data", "Require-Bundle: org.robotui.core");

    assertEquals(List.of("org.robotui.data/META-INF/MANIFEST.MF: layer 1 uses org.robotui.core of layer 3"),
        violations());
  }

  @Test
  void refuses_an_upward_import_in_a_source() {
    fixture.source("org.robotui.data", "org.robotui.data.Scan", "import org.robotui.core.Core;\nclass Scan { }");

    assertEquals(
        List.of("org.robotui.data/src/org/robotui/data/Scan.java: layer 1 uses org.robotui.core.Core of layer 3"),
        violations());
  }

  @Test
  void refuses_an_upward_qualified_name_in_a_source() {
    fixture.source("org.robotui.data", "org.robotui.data.Scan", "class Scan { org.robotui.core.Core core; }");

    assertEquals(
        List.of("org.robotui.data/src/org/robotui/data/Scan.java: layer 1 uses org.robotui.core.Core of layer 3"),
        violations());
  }

  @Test
  void refuses_an_import_on_the_same_level() {
    fixture.bundle("org.robotui.entity.scan", "Import-Package: org.robotui.entity.path")
        .bundle("org.robotui.entity.path");

    assertEquals(
        List.of("org.robotui.entity.scan/META-INF/MANIFEST.MF: layer 6 uses org.robotui.entity.path of layer 6"),
        violations());
  }

  @Test
  void does_not_mistake_a_comment_or_a_text_for_a_use() {
    fixture.source("org.robotui.data", "org.robotui.data.Scan",
        "/** See org.robotui.core.Core. */\nclass Scan { String id = \"org.robotui.core.Core\"; }");

    assertEquals(List.of(), violations());
  }

  @ParameterizedTest
  @ValueSource(strings = {"org.robotui.rfic.ros", "org.robotui.sim"})
  void accepts_those_whom_a_line_is_for(String user) {
    fixture.bundle(user, "Import-Package: org.robotui.ros.master");

    assertEquals(List.of(), violations());
  }

  @Test
  void refuses_those_whom_a_line_is_not_for() {
    fixture.bundle("org.robotui.uic.map", "Import-Package: org.robotui.ros.master");

    assertEquals(List.of(
        "org.robotui.uic.map/META-INF/MANIFEST.MF: layer 7 uses org.robotui.ros.master of layer 0c, which is for 0d 4 alone"),
        violations());
  }

  @Test
  void refuses_to_import_what_is_for_nobody() {
    fixture.bundle("org.robotui.uic.map", "Require-Bundle: org.robotui.core");

    assertEquals(
        List.of(
            "org.robotui.uic.map/META-INF/MANIFEST.MF: layer 7 uses org.robotui.core of layer 3, which is for nobody"),
        violations());
  }

  @Test
  void refuses_a_bundle_without_a_layer() {
    fixture.bundle("org.robotui.other");

    assertEquals(List.of("org.robotui.other: no line of bundles/LAYERS names it"), violations());
  }

  private List<String> violations() {
    return fixture.violationsOf(new LayerRule());
  }
}
