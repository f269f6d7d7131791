package org.robotui.rfic.lcm.internal;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class TypeFilesTest {
  private static final long SECOND = 1_000_000_000L;

  private @TempDir Path folder;
  private TypeFiles files;
  private long now;

  @BeforeEach
  void read() throws Exception {
    Files.createDirectories(folder.resolve("deep"));
    Files.writeString(folder.resolve("deep/pose.lcm"), "struct pose_t { double x; }");
    files = new TypeFiles(List.of(folder));
    files.reading(now);
  }

  private boolean look() {
    now += SECOND;
    return files.changed(now);
  }

  @Test
  void nothingChangesByItself() {
    assertFalse(look());
    assertFalse(look());
  }

  @Test
  void aChangedFileCountsOnceItIsWritten() throws Exception {
    Files.writeString(folder.resolve("deep/pose.lcm"), "struct pose_t { double x, y; }");
    assertFalse(look(), "somebody may still write");
    Files.writeString(folder.resolve("deep/pose.lcm"), "struct pose_t { double x, y, z; }");
    assertFalse(look(), "and does");
    assertTrue(look());
    files.reading(now);
    assertFalse(look());
    assertFalse(look());
  }

  @Test
  void filesComeAndGoAndOthersDoNotMatter() throws Exception {
    Files.writeString(folder.resolve("notes.txt"), "mine");
    assertFalse(look() || look());
    Files.writeString(folder.resolve("more.lcm"), "struct more_t { double x; }");
    assertTrue(!look() && look());
    files.reading(now);
    Files.delete(folder.resolve("deep/pose.lcm"));
    assertTrue(!look() && look());
  }

  @Test
  void itIsNotLookedAllTheTime() throws Exception {
    look();
    Files.delete(folder.resolve("deep/pose.lcm"));
    look();
    assertFalse(files.changed(now + SECOND / 2));
    assertTrue(files.changed(now + SECOND));
  }
}
