package org.robotui.architecture.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The rules without which a bundle would be built, but not be there or not run in the product. */
class ShippingRulesTest {

  private static final String COMPONENT =
      "import org.osgi.service.component.annotations.Component;\n@Component\nclass Factory { }";

  @TempDir
  Path folder;

  @Test
  void a_bundle_in_one_feature_is_accepted() {
    assertEquals(List.of(), fixtureWithFeatures("core").violationsOf(new FeatureRule()));
  }

  @Test
  void a_bundle_in_no_feature_is_refused() {
    assertEquals(List.of("org.robotui.core: is in 0 of features/*/feature.xml"),
        fixtureWithFeatures("data").violationsOf(new FeatureRule()));
  }

  @Test
  void a_bundle_in_two_features_is_refused() {
    assertEquals(List.of("org.robotui.core: is in 2 of features/*/feature.xml"),
        fixtureWithFeatures("core", "core").violationsOf(new FeatureRule()));
  }

  @Test
  void components_in_a_lazy_bundle_are_accepted() {
    Fixture fixture = new Fixture(folder).bundle("org.robotui.core", "Bundle-ActivationPolicy: lazy")
        .source("org.robotui.core", "org.robotui.core.internal.Factory", COMPONENT);

    assertEquals(List.of(), fixture.violationsOf(new LazyComponentsRule()));
  }

  @Test
  void components_in_any_other_bundle_are_refused() {
    Fixture fixture = new Fixture(folder).bundle("org.robotui.core")
        .source("org.robotui.core", "org.robotui.core.internal.Factory", COMPONENT);

    assertEquals(1, fixture.violationsOf(new LazyComponentsRule()).size());
  }

  @Test
  void a_component_that_starts_beside_the_window_is_accepted() {
    assertEquals(List.of(),
        fixtureWithLaterBundle("org.robotui.uic.map").bundle("org.robotui.data").violationsOf(new StartLevelRule()));
  }

  @Test
  void a_component_that_the_window_would_wait_for_is_refused() {
    assertEquals(List.of(
        "org.robotui.uic.plot: has no start level in product/org.robotui.workbench.p2.inf: the window would wait for it"),
        fixtureWithLaterBundle("org.robotui.uic.map").bundle("org.robotui.uic.plot")
            .violationsOf(new StartLevelRule()));
  }

  @Test
  void a_bundle_with_components_below_the_views_starts_beside_the_window_too() {
    assertEquals(1,
        fixtureWithLaterBundle("org.robotui.uic.map").bundle("org.robotui.entity.scan", "Bundle-ActivationPolicy: lazy")
            .source("org.robotui.entity.scan", "org.robotui.entity.scan.internal.Kind", COMPONENT)
            .violationsOf(new StartLevelRule()).size());
  }

  @Test
  void what_the_window_needs_must_not_start_beside_it() {
    assertEquals(1, fixtureWithLaterBundle("org.robotui.ui").violationsOf(new StartLevelRule()).size());
  }

  @Test
  void bundles_may_be_named_by_what_their_ids_begin_with() {
    assertEquals(List.of(), fixtureWithLaterBundle("org.robotui.uic.map")
        .file("product/org.robotui.workbench.p2.inf", "units.0.hostRequirements.1.matchExp = id ~= /org.robotui.uic.*/")
        .violationsOf(new StartLevelRule()));
  }

  @Test
  void a_product_that_names_a_bundle_is_refused() {
    assertEquals(List.of(
        "product/org.robotui.workbench.product: names org.robotui.uic.map, whose feature could then not be taken out"),
        fixtureWithLaterBundle("org.robotui.uic.map")
            .file("product/org.robotui.workbench.product",
                "<plugin id=\"org.robotui.uic.map\" autoStart=\"false\" startLevel=\"5\"/>")
            .violationsOf(new StartLevelRule()));
  }

  private Fixture fixtureWithLaterBundle(String later) {
    return new Fixture(folder).bundle(later).file("product/org.robotui.workbench.p2.inf",
        "units.0.hostRequirements.1.matchExp = id ~= /" + later + "/");
  }

  private Fixture fixtureWithFeatures(String... shipped) {
    Fixture fixture = new Fixture(folder).bundle("org.robotui.core");
    for (int i = 0; i < shipped.length; i++) {
      fixture.file("features/f" + i + "/feature.xml",
          "<feature><plugin id=\"org.robotui." + shipped[i] + "\" version=\"0.0.0\"/></feature>");
    }
    return fixture;
  }
}
