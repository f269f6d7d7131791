package org.robotui.install.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

final class KnownSitesTest {
  private static final URI SITE = URI.create("http://example.org/site");

  @TempDir
  private Path folder;

  @Test
  void sitesAreKeptOnceAndForgotten() {
    KnownSites sites = new KnownSites(folder.resolve("state"));
    sites.add(SITE);
    sites.add(URI.create(SITE + "/"));
    sites.add(URI.create("file:///there"));

    assertEquals(List.of(SITE, URI.create("file:///there")), new KnownSites(folder.resolve("state")).all());

    sites.remove(URI.create(SITE + "/"));
    assertEquals(List.of(URI.create("file:///there")), sites.all());
  }

  @Test
  void aFileThatCannotBeReadIsNoReasonToStop() throws Exception {
    Files.writeString(folder.resolve("update-sites.txt"), "no address at all\n");

    assertEquals(List.of(), new KnownSites(folder).all());
  }
}
