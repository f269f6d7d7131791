package org.robotui.install.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.robotui.install.SiteFeature;

final class P2WorkTest {
  private static SiteFeature feature(String id, String version) {
    return new SiteFeature(id, version, id.toUpperCase(java.util.Locale.ROOT), "");
  }

  @Test
  void whatHasComeChangedAndGoneIsSaid() {
    assertEquals("Updated B from 1.0.0 to 2.0.0. Installed C 3.0.0. Removed A 1.0.0.",
        P2Work.difference(List.of(feature("a", "1.0.0"), feature("b", "1.0.0"), feature("d", "1.0.0")),
            List.of(feature("b", "2.0.0"), feature("c", "3.0.0"), feature("d", "1.0.0"))));
  }
}
