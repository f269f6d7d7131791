package org.robotui.headless.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.BufferedReader;
import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.io.StringReader;
import java.net.URI;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.robotui.install.FeatureInstaller;
import org.robotui.install.InstallOutcome;
import org.robotui.install.InstallWatcher;
import org.robotui.install.SiteContent;
import org.robotui.install.SiteFeature;

final class FeatureRunTest {
  private static final SiteFeature LIDAR = new SiteFeature("lidar", "1.0.0", "Lidar", "");
  private static final SiteFeature SONAR = new SiteFeature("sonar", "2.0.0", "Sonar", "");

  private final ByteArrayOutputStream out = new ByteArrayOutputStream();
  private final ByteArrayOutputStream err = new ByteArrayOutputStream();

  /** A site whose features nobody has signed. */
  private static final class Site implements FeatureInstaller {
    private final List<SiteFeature> offered;
    private final List<SiteFeature> installed = new ArrayList<>();

    Site(SiteFeature... offered) {
      this.offered = List.of(offered);
    }

    @Override
    public List<SiteFeature> installed() {
      return List.copyOf(installed);
    }

    @Override
    public SiteContent look(URI site) {
      return new SiteContent.Offered(offered);
    }

    @Override
    public InstallOutcome install(URI site, List<String> features, InstallWatcher watcher) {
      if (!watcher.acceptsUnsigned(List.of("lidar_1.0.0.jar"))) {
        return new InstallOutcome.Refused(InstallOutcome.Reason.UNSIGNED, "Not signed.");
      }
      offered.stream().filter(feature -> features.contains(feature.id())).forEach(installed::add);
      return new InstallOutcome.Changed("Installed.", false);
    }

    @Override
    public InstallOutcome update(List<String> features, InstallWatcher watcher) {
      return new InstallOutcome.Unchanged("There is nothing newer.");
    }

    @Override
    public InstallOutcome remove(List<String> features, InstallWatcher watcher) {
      installed.removeIf(feature -> features.contains(feature.id()));
      return new InstallOutcome.Changed("Removed.", false);
    }

    @Override
    public List<URI> sites() {
      return List.of();
    }

    @Override
    public void remember(URI site) {
      throw new UnsupportedOperationException("no command asks for it");
    }

    @Override
    public void forget(URI site) {
      throw new UnsupportedOperationException("no command asks for it");
    }
  }

  private Exit run(Site site, String answer, String... words) throws Exception {
    return new FeatureRun(site, new PrintStream(out, true), new PrintStream(err, true),
        new BufferedReader(new StringReader(answer))).run(FeatureArguments.parse(Arrays.asList(words)));
  }

  @Test
  void theOnlyFeatureOfASiteIsInstalledOnceTheUserAgrees() throws Exception {
    Site site = new Site(LIDAR);

    assertEquals(Exit.FINE, run(site, "yes\n", "-features", "install", "-site", "http://localhost/"));

    assertEquals(List.of(LIDAR), site.installed());
    assertTrue(err.toString().contains("Nobody has signed lidar_1.0.0.jar"));
    assertEquals("Installed.", out.toString().strip());
  }

  @Test
  void withoutAnAnswerNothingIsInstalledThatIsNotSigned() throws Exception {
    for (String answer : List.of("", "\n", "no\n")) {
      Site site = new Site(LIDAR);
      assertEquals(Exit.ERRORS, run(site, answer, "-features", "install", "-site", "http://localhost/"));
      assertEquals(List.of(), site.installed());
    }
  }

  @Test
  void nobodyIsAskedWhoHasSaidItBefore() throws Exception {
    Site site = new Site(LIDAR);

    run(site, "", "-features", "install", "-site", "http://localhost/", "-unsigned");

    assertEquals(List.of(LIDAR), site.installed());
  }

  @Test
  void ofSeveralFeaturesTheUserChooses() throws Exception {
    Site site = new Site(LIDAR, SONAR);

    assertEquals(Exit.ERRORS, run(site, "y\n", "-features", "install", "-site", "http://localhost/"));

    assertEquals(List.of(), site.installed());
    assertTrue(out.toString().contains("sonar  2.0.0  Sonar"), out.toString());
    assertTrue(err.toString().contains("Say which"));
  }
}
