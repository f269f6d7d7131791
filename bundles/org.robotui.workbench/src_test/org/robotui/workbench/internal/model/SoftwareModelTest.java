package org.robotui.workbench.internal.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.URI;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Queue;
import org.junit.jupiter.api.Test;
import org.robotui.install.SiteFeature;
import org.robotui.ui.Health;

final class SoftwareModelTest {
  private static final URI SITE = URI.create("http://localhost/site");
  private static final SiteFeature OLD = new SiteFeature("lidar", "1.0.0", "Lidar", "sees");
  private static final SiteFeature NEW = new SiteFeature("lidar", "2.0.0", "Lidar", "sees");
  private static final SiteFeature SONAR = new SiteFeature("sonar", "1.0.0", "Sonar", "hears");

  private final FakeInstaller installer = new FakeInstaller();
  private final Queue<Runnable> tasks = new ArrayDeque<>();
  private final List<List<String>> asked = new ArrayList<>();
  private boolean agrees = true;

  private SoftwareModel model() {
    return new SoftwareModel(installer, tasks::add, tasks::add, names -> {
      asked.add(names);
      return agrees;
    });
  }

  private void finish() {
    while (!tasks.isEmpty()) {
      tasks.remove().run();
    }
  }

  private static List<String> versions(SoftwareModel model) {
    return model.rows().stream().map(r -> r.name() + "|" + r.installedVersion() + "|" + r.offeredVersion()).toList();
  }

  @Test
  void whatIsInstalledStandsBesideWhatTheSiteOffers() {
    installer.installs(OLD).offers(SITE, NEW, SONAR);
    SoftwareModel model = model();
    model.choose(SITE);
    assertTrue(model.isBusy());
    finish();

    assertFalse(model.isBusy());
    assertEquals(List.of("Lidar|1.0.0|2.0.0", "Sonar||1.0.0"), versions(model));
    assertEquals(List.of(SITE), model.sites());
  }

  @Test
  void whatIsInstalledIsShownAtOnceAndTheUserIsAskedBefore() {
    installer.offers(SITE, SONAR);
    SoftwareModel model = model();
    model.choose(SITE);
    finish();
    model.install(model.rows().getFirst());
    finish();

    assertEquals(1, asked.size());
    assertEquals(List.of("Sonar|1.0.0|1.0.0"), versions(model));
    assertEquals(Health.OK, model.health());

    model.remove(model.rows().getFirst());
    finish();
    assertEquals(List.of("Sonar||1.0.0"), versions(model));
  }

  @Test
  void whatIsRefusedChangesNothingAndSaysWhy() {
    agrees = false;
    installer.offers(SITE, SONAR);
    SoftwareModel model = model();
    model.choose(SITE);
    finish();
    model.install(model.rows().getFirst());
    finish();

    assertEquals(Health.BAD, model.health());
    assertEquals(FakeInstaller.NOT_SIGNED, model.sentence());
    assertEquals(List.of("Sonar||1.0.0"), versions(model));
  }

  @Test
  void aSiteThatCannotBeReadIsSaidAndCanBeForgotten() {
    installer.installs(OLD);
    SoftwareModel model = model();
    model.choose(SITE);
    finish();
    assertEquals(Health.BAD, model.health());
    assertEquals(List.of("Lidar|1.0.0|"), versions(model));

    model.forget();
    finish();
    assertEquals(Optional.empty(), model.site());
    assertEquals("", model.sentence());
  }

  @Test
  void whileSomethingIsBeingDoneNothingElseBegins() {
    installer.installs(OLD).offers(SITE, OLD);
    SoftwareModel model = model();
    model.choose(SITE);
    model.update();
    finish();

    assertEquals(List.of("look"), installer.calls());
  }

  @Test
  void onlyAddressesOfSitesAreTaken() {
    assertTrue(SoftwareModel.isSite(" http://localhost:8080/site "));
    assertTrue(SoftwareModel.isSite("file:/there"));
    assertFalse(SoftwareModel.isSite("http://"));
    assertFalse(SoftwareModel.isSite("there"));
    assertFalse(SoftwareModel.isSite("ftp://there/"));
  }
}
