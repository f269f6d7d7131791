package org.robotui.api.config;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class WriteFailureTest {
  @TempDir
  Path folder;

  private static String reason(Path file) {
    return WriteFailure.reason(assertThrows(IOException.class, () -> Files.writeString(file, "text")));
  }

  @Test
  void aFullDiskIsSaidInPlainWords() {
    assertEquals("the disk is full", reason(Path.of("/dev/full")));
  }

  @Test
  void theFileIsNotNamedTwice() {
    assertEquals("its folder is not there", reason(folder.resolve("a/b")));
    assertEquals("Is a directory", reason(folder));
    assertEquals("an unknown error", WriteFailure.reason(new IOException()));
  }
}
