package org.robotui.architecture.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class IdeRuleTest {

  private static final String LAUNCH = """
      <launchConfiguration type="org.eclipse.pde.ui.%s">
          <setAttribute key="additional_plugins">
              <setEntry value="org.eclipse.equinox.event:0.0.0:default:true:2:true"/>
              <setEntry value="%s:0.0.0:default:true:default:default"/>
          </setAttribute>
          <stringAttribute key="application" value="org.robotui.workbench.application"/>
          <stringAttribute key="org.eclipse.jdt.launching.PROJECT_ATTR" value="org.robotui.core.tests"/>
          <stringAttribute key="org.eclipse.jdt.launching.VM_ARGUMENTS" value="-Dx=${project_loc:/%s}/y"/>
          <setAttribute key="selected_features">
              <setEntry value="org.robotui.feature.%s:default"/>
          </setAttribute>
      </launchConfiguration>
      """;

  @TempDir
  Path folder;

  private Fixture fixture() {
    return new Fixture(folder).bundle("org.robotui.core")
        .file("bundles/org.robotui.core/.project", project("org.robotui.core"))
        .file("features/org.robotui.feature.core/feature.xml", "<feature/>")
        .file("features/org.robotui.feature.core/.project", project("org.robotui.feature.core"))
        .file("tests/org.robotui.core.tests/src/X.java", "")
        .file("tests/org.robotui.core.tests/.project", project("org.robotui.core.tests"))
        .file("product/w.product",
            "<product application=\"org.robotui.workbench.application\"><feature id=\"org.robotui.feature.core\"/></product>")
        .file("releng/.project", project("org.robotui.releng"))
        .file("releng/window.launch",
            LAUNCH.formatted("RuntimeWorkbench", "org.robotui.core", "org.robotui.releng", "core"))
        .file("releng/tests.launch",
            LAUNCH.formatted("JunitLaunchConfig", "org.robotui.core", "org.robotui.releng", "core"));
  }

  private static String project(String name) {
    return "<projectDescription><name>" + name + "</name></projectDescription>";
  }

  private List<String> violations(Fixture fixture) {
    return fixture.violationsOf(new IdeRule());
  }

  @Test
  void projects_and_launches_of_all_that_is_there_are_accepted() {
    assertEquals(List.of(), violations(fixture()));
  }

  @Test
  void what_no_ide_imports_is_refused() {
    assertEquals(List.of("features/org.robotui.feature.ros: has no .project of its name, so that no IDE imports it"),
        violations(fixture().file("features/org.robotui.feature.ros/feature.xml", "<feature/>")));
  }

  @Test
  void what_is_not_there_cannot_be_launched() {
    assertEquals(
        List.of("releng/tests.launch: names org.robotui.gone, which is no project",
            "releng/tests.launch: names org.robotui.away, which is no project",
            "releng/tests.launch: names org.robotui.feature.lost, which is no project"),
        violations(fixture().file("releng/tests.launch",
            LAUNCH.formatted("JunitLaunchConfig", "org.robotui.gone", "org.robotui.away", "lost"))));
  }

  @Test
  void a_launch_lacks_no_feature_of_its_product() {
    assertEquals(List.of("releng/window.launch: has other features than the product of its application"),
        violations(fixture().file("product/w.product",
            "<product application=\"org.robotui.workbench.application\"><feature id=\"org.robotui.feature.core\"/><feature id=\"org.robotui.feature.ros\"/></product>")));
  }

  @Test
  void each_application_and_each_bundle_of_tests_can_be_launched() {
    assertEquals(
        List.of("releng: has no launch configuration of org.robotui.headless.application",
            "releng: has no launch configuration of org.robotui.ros.tests"),
        violations(fixture().file("product/h.product", "<product application=\"org.robotui.headless.application\"/>")
            .file("tests/org.robotui.ros.tests/src/X.java", "")
            .file("tests/org.robotui.ros.tests/.project", project("org.robotui.ros.tests"))));
  }
}
