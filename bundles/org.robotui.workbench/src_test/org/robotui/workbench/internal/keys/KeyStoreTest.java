package org.robotui.workbench.internal.keys;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.robotui.workbench.internal.keys.KeymapTest.command;
import static org.robotui.workbench.internal.keys.KeymapTest.keys;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class KeyStoreTest {
  private final KeyedCommand lease = command("lease", false, "Ctrl+L");
  private final KeyedCommand search = command("search", false, "Ctrl+3");
  private final KeyedCommand first = command("perspective(1)", false, "Ctrl+Alt+1");
  private final List<String> told = new ArrayList<>();
  private @TempDir Path folder;

  @Test
  void whatIsChangedIsThereInTheNextRun() throws IOException {
    KeyStore store = open();
    AtomicInteger changes = new AtomicInteger();
    Runnable end = store.onChange(changes::incrementAndGet);

    store.change(store.now().with(lease, keys("Ctrl+Shift+L", "F5")).with(first, List.of()));
    store.change(store.now());
    end.run();

    assertEquals(1, changes.get());
    KeyStore next = open();
    assertEquals(store.now(), next.now());
    assertEquals("Ctrl+3", next.text("search"));
    assertEquals("", next.text("perspective(1)"));
    assertEquals("", next.text("nothing"));
    assertTrue(Files.readString(file()).contains("\nversion: 1\n"), Files.readString(file()));
    assertEquals(List.of(), told);
  }

  @Test
  void commentsAndCommandsThatAreNotInstalledStay() throws IOException {
    Files.writeString(file(), """
        # Our lab.
        version: 1
        keys:
          # Dave has no F5.
          lease: [F6]  # as on the old machine
          other.plugin.command: Ctrl+Alt+P
          search: []
        """);
    KeyStore store = open();

    store.change(store.now().with(lease, keys("F7")).reset(search));

    assertEquals("""
        # Our lab.
        version: 1
        keys:
          # Dave has no F5.
          'lease': ['F7']  # as on the old machine
          'other.plugin.command': ['Ctrl+Alt+P']
        """, Files.readString(file()));
    assertEquals(List.of(), told);
  }

  @Test
  void whatIsDamagedIsToldAndSetAsideAndTheRestHolds() throws IOException {
    Files.writeString(file(), "version: 1\nkeys: {lease: [Strg+L], search: [F5, F12], 'perspective(1)': F9}\n");

    KeyStore store = open();

    assertEquals(lease.usual(), store.now().keys(lease));
    assertEquals(keys("F5"), store.now().keys(search));
    assertEquals(keys("F9"), store.now().keys(first));
    assertEquals(1, told.size());
    assertTrue(told.getFirst().contains("'Strg+L'") && told.getFirst().contains("F12 stops all robots"),
        told::toString);
    assertEquals(1, aside().size());
  }

  @Test
  void aFileThatIsNoneIsSetAsideAndWrittenAnewByTheNextChange() throws IOException {
    for (String text : List.of("keys: [", "version: 2\nkeys: {lease: F5}", "{}", "version: 1\nkeys: 7", "\u0000",
        "a: &a [*a]")) {
      Files.writeString(file(), text);
      told.clear();

      KeyStore store = open();
      assertEquals(1, told.size(), text);
      store.change(store.now().with(lease, keys("F5")));

      told.clear();
      assertEquals(keys("F5"), open().now().keys(lease), text);
      assertEquals(List.of(), told, text);
    }
    assertTrue(!aside().isEmpty());
  }

  @Test
  void whereNothingCanBeWrittenTheKeysHoldForThisRun() throws IOException {
    Files.createDirectory(file());
    KeyStore store = open();
    told.clear();

    store.change(store.now().with(lease, keys("F5")));

    assertEquals(keys("F5"), store.now().keys(lease));
    assertTrue(told.getFirst().contains("for this run only"), told::toString);
  }

  private KeyStore open() {
    KeyStore store = new KeyStore(new KeysFile(file()), told::add);
    store.commands(List.of(lease, search, first));
    return store;
  }

  private Path file() {
    return folder.resolve("keys.yaml");
  }

  private List<Path> aside() throws IOException {
    try (Stream<Path> files = Files.list(folder)) {
      return files.filter(f -> f.toString().contains(".damaged-")).toList();
    }
  }
}
