package org.robotui.architecture.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** {@code releng/ProductFeatures.java}, on a small repository and on this one. */
class ProductFeaturesTest {

  private static final String PRODUCT = "<product>\n  <features>\n  </features>\n</product>\n";

  private static final String LAUNCH = "    <setAttribute key=\"selected_features\">\n    </setAttribute>\n";

  private static final String ROOT_FEATURE = "    <feature id=\"org.robotui.feature.%s\" installMode=\"root\"/>\n";

  @TempDir
  Path folder;

  @BeforeEach
  void aRepositoryWhoseProductsListNothing() {
    new Fixture(folder)
        .file("product/org.robotui.workbench.product", PRODUCT)
        .file("product/org.robotui.headless.product", PRODUCT)
        .file("releng/RobotUI.launch", LAUNCH)
        .file("releng/RobotUI headless.launch", LAUNCH)
        .file("product/category.xml", "<site>\n  <category-def name=\"org.robotui\" label=\"RobotUI\"/>\n</site>\n")
        .file("features/a/feature.xml",
            "<feature id=\"org.robotui.feature.platform\"><includes id=\"org.robotui.feature.platform.headless\"/>"
                + "<plugin id=\"org.eclipse.swt\"/></feature>")
        .file("features/b/feature.xml",
            "<feature id=\"org.robotui.feature.platform.headless\"><plugin id=\"org.eclipse.osgi\"/></feature>")
        .file("features/c/feature.xml",
            "<feature id=\"org.robotui.feature.views\"><plugin id=\"org.robotui.uic.map\"/></feature>")
        .file("features/d/feature.xml",
            "<feature id=\"org.robotui.feature.lcm\"><plugin id=\"org.robotui.rfic.lcm\"/></feature>")
        .file("features/e/feature.xml",
            "<feature id=\"org.robotui.feature.sdk\"><plugin id=\"org.robotui.testkit\"/></feature>")
        .bundle("org.robotui.uic.map", "Import-Package: org.robotui.api;version=\"[1.0,2.0)\",org.robotui.ui.scene")
        .bundle("org.robotui.rfic.lcm", "Import-Package: org.robotui.api");
  }

  @Test
  void the_window_has_all_features_that_no_other_includes() throws Exception {
    assertEquals(0, run(folder));

    assertEquals(listing("platform", "lcm", "views"),
        Files.readString(folder.resolve("product/org.robotui.workbench.product")));
  }

  @Test
  void the_headless_product_has_those_that_need_no_window() throws Exception {
    run(folder);

    assertEquals(listing("platform.headless", "lcm"),
        Files.readString(folder.resolve("product/org.robotui.headless.product")));
  }

  @Test
  void the_update_site_has_all_but_the_platforms_and_also_what_is_for_developers() throws Exception {
    run(folder);

    assertEquals(List.of("lcm", "sdk", "views"), Files.readString(folder.resolve("product/category.xml")).lines()
        .filter(line -> line.contains("<feature")).map(line -> line.replaceAll(".*feature\\.([a-z]+)\".*", "$1"))
        .toList());
  }

  @Test
  void the_ide_starts_a_product_with_its_features() throws Exception {
    run(folder);

    assertEquals(List.of("lcm", "platform", "views"), launched("releng/RobotUI.launch"));
    assertEquals(List.of("lcm", "platform.headless"), launched("releng/RobotUI headless.launch"));
  }

  private List<String> launched(String name) throws IOException {
    return Files.readString(folder.resolve(name)).lines().filter(text -> text.contains("setEntry"))
        .map(text -> text.replaceAll(".*feature\\.([a-z.]+):default.*", "$1")).toList();
  }

  @Test
  void a_check_finds_what_is_missing_and_writes_nothing() throws Exception {
    assertEquals(1, run(folder, "--check"));
    assertEquals(PRODUCT, Files.readString(folder.resolve("product/org.robotui.workbench.product")));

    run(folder);
    assertEquals(0, run(folder, "--check"));
  }

  @Test
  void this_repository_lists_the_features_that_there_are() throws Exception {
    assertEquals(0, run(RepositoryTest.root(), "--check"));
  }

  private static String listing(String... features) {
    return "<product>\n  <features>\n"
        + String.join("", List.of(features).stream().map(ROOT_FEATURE::formatted).toList())
        + "  </features>\n</product>\n";
  }

  /** The exit code. What the program says goes into the failure where it is not the one that it should be. */
  private int run(Path root, String... more) throws IOException, InterruptedException {
    List<String> command = new ArrayList<>(List.of(Path.of(System.getProperty("java.home"), "bin", "java").toString(),
        RepositoryTest.root().resolve("releng/ProductFeatures.java").toString(), root.toString()));
    command.addAll(List.of(more));
    Path said = Files.createTempFile(folder, "said", ".txt");
    Process process = new ProcessBuilder(command).redirectErrorStream(true).redirectOutput(said.toFile()).start();
    int code = process.waitFor();
    assertTrue(code == 0 || code == 1, () -> Trees.read(said));
    return code;
  }
}
