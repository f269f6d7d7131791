package org.robotui.core.internal.facts;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robotui.core.internal.stop.StopSocket;

class SupportFileTest {
  @TempDir
  private Path folder;
  private Path state;
  private Path file;

  @BeforeEach
  void kept() throws IOException {
    state = folder.resolve("state");
    file = folder.resolve("support.zip");
    write("workspace-1/robotui.log", "12:00 INFO login with token=abc\n");
    write("workspace-2/robotui.log.1", "older\n");
    write("overlays/demo-1.yaml", "Natalie:\n  password: abc\n");
    write("workspace-1/.metadata/other", "no");
  }

  private void write(String name, String text) throws IOException {
    Path to = state.resolve(name);
    Files.createDirectories(to.getParent());
    Files.writeString(to, text);
  }

  private static Map<String, String> read(Path zip) throws IOException {
    Map<String, String> texts = new TreeMap<>();
    try (ZipFile opened = new ZipFile(zip.toFile())) {
      for (ZipEntry entry : opened.stream().map(ZipEntry.class::cast).toList()) {
        try (InputStream in = opened.getInputStream(entry)) {
          texts.put(entry.getName(), new String(in.readAllBytes(), StandardCharsets.UTF_8));
        }
      }
    }
    return texts;
  }

  @Test
  void itHasLogsAndWhatWasKeptAndSaysSo() throws IOException {
    List<String> said = new SupportFile(state, Optional.empty()).write(file, List.of(), Map.of("own.txt", "mine"));

    Map<String, String> texts = read(file);
    assertEquals("12:00 INFO login with token=***\n", texts.get("state/workspace-1/robotui.log"));
    assertEquals("Natalie:\n  password: ***\n", texts.get("state/overlays/demo-1.yaml"));
    assertEquals("mine\n", texts.get("own.txt"));
    assertTrue(texts.containsKey("state/workspace-2/robotui.log.1"));
    assertFalse(texts.containsKey("state/workspace-1/.metadata/other"));
    assertTrue(texts.get("state.txt").contains("overlays/demo-1.yaml"), texts.get("state.txt"));
    assertTrue(texts.get("CONTENTS.txt").contains("state/overlays/demo-1.yaml: "), texts.get("CONTENTS.txt"));
    assertEquals(texts.size() - 1, said.size());
  }

  @Test
  void onlyItsUserCanReadIt() throws IOException {
    Files.writeString(file, "older");
    new SupportFile(state, Optional.empty()).write(file, List.of(), Map.of());
    assertEquals("rw-------", PosixFilePermissions.toString(Files.getPosixFilePermissions(file)));
  }

  @Test
  void aLongLogIsCutAtItsBeginning() throws IOException {
    write("workspace-1/robotui.log", "first\n" + "some words of a log\n".repeat(150_000) + "last\n");
    new SupportFile(state, Optional.empty()).write(file, List.of(), Map.of());

    Map<String, String> texts = read(file);
    String log = texts.get("state/workspace-1/robotui.log");
    assertTrue(log.length() <= FactsZip.MOST_OF_ONE);
    assertTrue(log.startsWith("some words"));
    assertTrue(log.endsWith("last\n"));
    assertTrue(texts.get("CONTENTS.txt").contains("robotui.log: a log, the last 2 MB"));
  }

  @Test
  void allTogetherIsBoundedAndThatIsSaid() throws IOException {
    String much = "x".repeat(1000).concat("\n").repeat(2000);
    for (int i = 0; i < 30; i++) {
      write("overlays/" + i + ".yaml", much);
    }
    List<String> said = new SupportFile(state, Optional.empty()).write(file, List.of(), Map.of());
    assertTrue(said.stream().anyMatch(line -> line.contains("more than 40 MB")), said.toString());
  }

  @Test
  void aConfigurationThatIsGoneIsNamed() throws IOException {
    Path there = Files.writeString(folder.resolve("demo.yaml"), "ruics: {}\n");
    List<String> said = new SupportFile(state, Optional.empty()).write(file,
        List.of(there, folder.resolve("gone.yaml")), Map.of());

    assertEquals("ruics: {}\n", read(file).get("configurations/1-demo.yaml"));
    assertTrue(said.stream().anyMatch(l -> l.startsWith("configurations/2-gone.yaml: not included")), said.toString());
  }

  @Test
  void whatRunsSaysItsThreadsAndConfigurations() throws IOException {
    Path demo = Files.writeString(folder.resolve("demo.yaml"), "ruics: {}\n");
    ProcessFacts facts =
        new ProcessFacts(() -> List.of(demo), () -> List.of("Natalie: SELECTED"), () -> List.of("1 a"));
    try (StopSocket socket = new StopSocket(state.resolve("run"), Map.of("facts", facts::lines))) {
      // Another process has another number.
      Path own = state.resolve("run/stop-" + ProcessHandle.current().pid() + ".sock");
      Files.createSymbolicLink(state.resolve("run/stop-7.sock"), own);
      new SupportFile(state, Optional.empty()).write(file, List.of(), Map.of());
    }

    Map<String, String> texts = read(file);
    String said = texts.get("running-7.txt");
    assertTrue(said.contains("Natalie: SELECTED"));
    assertTrue(said.contains("ThreadFacts.lines"), "a stack");
    assertTrue(said.contains("heap: "));
    assertTrue(texts.containsKey("configurations/1-demo.yaml"));
  }

  @Test
  void theCommandSaysWhatIsInItAndWhereItCannotBeWritten() throws IOException {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    PrintStream print = new PrintStream(out, true, StandardCharsets.UTF_8);
    Path product = Files.createDirectories(folder.resolve("product/configuration"));
    Files.writeString(product.resolve("1.log"), "failed");
    assertEquals(0,
        SupportMain.run(new String[]{state.toString(), product.getParent().toString(), file.toString()}, print, print));
    assertTrue(out.toString(StandardCharsets.UTF_8).contains("product/1.log"), out.toString(StandardCharsets.UTF_8));

    Files.writeString(folder.resolve("no"), "a file");
    String[] nowhere = {state.toString(), product.toString(), folder.resolve("no/support.zip").toString()};
    assertEquals(1, SupportMain.run(nowhere, print, print));
    assertThrows(IOException.class, () -> new SupportFile(state, Optional.empty()).write(folder.resolve("no/x.zip"),
        List.of(), Map.of()));
  }
}
