package org.robotui.workbench.internal.rcp;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class DocumentationTest {
  @TempDir
  Path installation;

  private final List<String> launched = new ArrayList<>();

  @BeforeEach
  void pages() throws IOException {
    Path views = Files.createDirectories(installation.resolve("documentation/docs/views"));
    Files.writeString(views.resolve("map.html"), "map");
    Files.writeString(installation.resolve("documentation/index.html"), "all");
  }

  private Documentation documentation(boolean browser) {
    return new Documentation(installation, address -> {
      launched.add(address);
      return browser;
    });
  }

  @Test
  void aPageIsShownInTheBrowser() {
    Documentation documentation = documentation(true);

    assertEquals(Optional.empty(), documentation.open(documentation.index()));
    assertEquals(List.of(documentation.index().toUri().toString()), launched);
  }

  @Test
  void whereThereIsNoBrowserItIsSaidWhereThePageLies() {
    Documentation documentation = documentation(false);

    assertTrue(documentation.open(documentation.index()).orElseThrow().endsWith(documentation.index().toString()));
  }

  @Test
  void aPageThatIsMissingIsNamed() {
    assertEquals("The documentation is not in this installation: /nowhere/index.html is missing.",
        documentation(true).open(Path.of("/nowhere/index.html")).orElseThrow());
    assertEquals(List.of(), launched);
  }

  @Test
  void aViewHasItsPageWhereThereIsOne() {
    Documentation documentation = documentation(true);

    assertTrue(documentation.view("map").orElseThrow().endsWith("docs/views/map.html"));
    assertEquals(Optional.empty(), documentation.view("ofsomebodyelse"));
    assertEquals(Optional.empty(), documentation.view("../../index"));
  }
}
