package org.robotui.architecture.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ExportRuleTest {

  @TempDir
  Path folder;

  @Test
  void accepts_a_package_of_the_contracts() {
    assertEquals(List.of(), violations("org.robotui.api", "org.robotui.api.port"));
  }

  @Test
  void refuses_any_export_of_a_component() {
    assertEquals(List.of("org.robotui.uic.map: exports org.robotui.uic.map: this bundle exports nothing"),
        violations("org.robotui.uic.map", "org.robotui.uic.map"));
  }

  @Test
  void refuses_an_exported_internal_package() {
    assertEquals(List.of("org.robotui.api: exports org.robotui.api.internal: internal packages stay inside"),
        violations("org.robotui.api", "org.robotui.api.internal"));
  }

  @Test
  void refuses_a_package_that_does_not_exist() {
    List<String> found =
        new Fixture(folder).bundle("org.robotui.data", "Export-Package: org.robotui.data.gone;version=\"1.0.0\"")
            .violationsOf(new ExportRule());

    assertEquals(List.of("org.robotui.data: exports org.robotui.data.gone: there is no such package"), found);
  }

  private List<String> violations(String bundle, String exported) {
    return new Fixture(folder).bundle(bundle, "Export-Package: " + exported)
        .source(bundle, exported + ".Thing", "class Thing { }")
        .violationsOf(new ExportRule());
  }
}
