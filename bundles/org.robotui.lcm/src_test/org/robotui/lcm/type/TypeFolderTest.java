package org.robotui.lcm.type;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class TypeFolderTest {
  @TempDir
  Path folder;

  @Test
  void filesCountAtAnyDepth() throws IOException {
    Path deep = Files.createDirectories(folder.resolve("a/b/c"));
    Files.writeString(deep.resolve("pose_t.lcm"), "package demo; struct pose_t { double x; }");
    Files.writeString(deep.resolve("notes.txt"), "no type");

    assertEquals(List.of("demo.pose_t"), TypeFolder.read(List.of(folder)).types().stream().map(LcmType::name).toList());
  }

  @Test
  void theWholeMachineIsNoFolderOfTypes() {
    String message = assertThrows(IOException.class, () -> TypeFolder.read(List.of(Path.of("/")))).getMessage();

    assertTrue(
        message.startsWith("there is far more than types in /") || message.startsWith("/ cannot be looked through"),
        message);
  }
}
