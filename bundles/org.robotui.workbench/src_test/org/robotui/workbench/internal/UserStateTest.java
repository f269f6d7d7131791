package org.robotui.workbench.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class UserStateTest {
  private @TempDir Path folder;

  @Test
  void whatIsPutIsThereInTheNextRun() {
    new UserState(folder.resolve("new")).put("theme", "light");

    assertEquals(Optional.of("light"), new UserState(folder.resolve("new")).get("theme"));
  }

  @Test
  void aBrokenFileIsNoReasonToStop() throws Exception {
    Files.writeString(folder.resolve("workbench.properties"), "theme=\\uXYZ");

    assertEquals(Optional.empty(), new UserState(folder).get("theme"));
  }

  @Test
  void aFolderThatCannotBeWrittenIsNoReasonToStop() throws Exception {
    Path file = Files.createFile(folder.resolve("file"));
    UserState state = new UserState(file);

    state.put("theme", "light");

    assertEquals(Optional.of("light"), state.get("theme"));
  }
}
