package org.robotui.workbench.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class SuspectsTest {
  private @TempDir Path folder;

  @Test
  void eachIsAskedForOnce() throws Exception {
    Files.writeString(folder.resolve("suspect-bundles.txt"), "org.a\norg.b\n\norg.a\n");
    List<String> asked = new ArrayList<>();

    List<String> out = new Suspects(folder).judge(bundle -> asked.add(bundle) && bundle.equals("org.b"));

    assertEquals(List.of("org.a", "org.b"), asked);
    assertEquals(List.of("org.b"), out);
    assertEquals(List.of(), new Suspects(folder).judge(bundle -> true));
  }

  @Test
  void nobodyIsAskedForWhatNothingWorksWithout() throws Exception {
    Files.writeString(folder.resolve("suspect-bundles.txt"), "org.robotui.workbench\norg.a\n");

    assertEquals(List.of("org.a"), new Suspects(folder).judge(bundle -> true));
  }

  @Test
  void usuallyThereAreNone() {
    assertFalse(new Suspects(folder).exist());
    assertEquals(List.of(), new Suspects(folder).judge(bundle -> true));
  }

  @Test
  void theyExistUntilTheyWereJudged() throws Exception {
    Files.writeString(folder.resolve("suspect-bundles.txt"), "org.a\n");
    Suspects suspects = new Suspects(folder);

    assertTrue(suspects.exist());
    suspects.judge(bundle -> false);
    assertFalse(suspects.exist());
  }
}
