package org.robotui.api.config;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class AtomicFileTest {
  @TempDir
  private Path folder;
  private Path file;

  @BeforeEach
  void name() {
    file = folder.resolve("rows.csv");
  }

  private List<String> names() throws IOException {
    try (Stream<Path> all = Files.list(folder)) {
      return all.map(f -> f.getFileName().toString()).sorted().toList();
    }
  }

  @Test
  void aNewFileHoldsTheText() throws IOException {
    AtomicFile.write(file, "größe,1\n");
    assertEquals("größe,1\n", Files.readString(file));
    assertEquals(List.of("rows.csv"), names());
  }

  @Test
  void whatFailsInTheMiddleLeavesWhatStoodThere() throws IOException {
    AtomicFile.write(file, "before");
    IOException full = new IOException("No space left on device");
    assertEquals(full, assertThrows(IOException.class, () -> AtomicFile.write(file, out -> {
      out.write(1);
      throw full;
    })));
    assertEquals("before", Files.readString(file));
    assertEquals(List.of("rows.csv"), names());
  }

  @Test
  void aFullDiskLeavesNothing() throws IOException {
    Path device = Path.of("/dev/full");
    Assumptions.assumeTrue(Files.isWritable(device), "only Linux has a disk that is always full");
    IOException full = assertThrows(IOException.class, () -> AtomicFile.write(device, "text"));
    assertEquals("the disk is full", WriteFailure.reason(full));
    assertTrue(Files.exists(device));
    assertEquals(List.of(), names());
  }

  @Test
  void theRightsStay() throws IOException {
    Assumptions.assumeTrue(folder.getFileSystem().supportedFileAttributeViews().contains("posix"),
        "it has no such rights");
    AtomicFile.write(file, "before");
    Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rw-r-----"));
    AtomicFile.write(file, "after");
    assertEquals("rw-r-----", rights(file));
  }

  private static String rights(Path file) throws IOException {
    return PosixFilePermissions.toString(Files.getPosixFilePermissions(file));
  }

  @Test
  void aPrivateFileIsClosedToOthersAndSoAreFoldersThatAreMadeForIt() throws IOException {
    Assumptions.assumeTrue(folder.getFileSystem().supportedFileAttributeViews().contains("posix"),
        "it has no such rights");
    Path kept = folder.resolve("state").resolve("kept");
    AtomicFile.writePrivate(kept, "before");
    assertEquals("rwx------", rights(kept.getParent()));
    assertEquals("rw-------", rights(kept));
    Files.setPosixFilePermissions(kept, PosixFilePermissions.fromString("rw-r--r--"));
    AtomicFile.writePrivate(kept, "after");
    assertEquals("rw-------", rights(kept));
    assertEquals("after", Files.readString(kept));
  }

  @Test
  void aPrivateFileReplacesWhatItsLinkLeadsTo() throws IOException {
    AtomicFile.write(file, "before");
    Path link = Files.createSymbolicLink(folder.resolve("latest"), file);
    AtomicFile.writePrivate(link, "after");
    assertEquals("after", Files.readString(file));
    assertTrue(Files.isSymbolicLink(link));
  }

  @Test
  void whatALinkLeadsToIsReplaced() throws IOException {
    AtomicFile.write(file, "before");
    Path link = Files.createSymbolicLink(folder.resolve("latest"), file);
    AtomicFile.write(link, "after");
    assertEquals("after", Files.readString(file));
    assertTrue(Files.isSymbolicLink(link));
  }

  @Test
  void aFolderThatIsNotThereIsSaid() {
    IOException missing =
        assertThrows(IOException.class, () -> AtomicFile.write(folder.resolve("no").resolve("rows.csv"), "x"));
    assertEquals("its folder is not there", WriteFailure.reason(missing));
    assertFalse(Files.exists(folder.resolve("no")));
  }
}
