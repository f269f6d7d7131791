package org.robotui.core.internal.config;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robotui.api.config.Printable;
import org.robotui.api.host.Problem;
import org.robotui.core.internal.config.model.ConfigResult;

/** Files that are none, and values that no robot should meet. */
class HostileConfigTest {
  private static final Duration QUICKLY = Duration.ofSeconds(60);
  private static final String ROBOTS = """
      ruics:
        Natalie:
          type: base
          rfics:
            ros: {master: x, type: ros}
            arm: {master: x, type: ros, robot: Arm}
          safety:
            Natalie: {%s}
      """;

  @TempDir
  Path folder;

  @ParameterizedTest
  @ValueSource(strings = {"1e999", "-1", ".inf", ".nan", "NaN", "Infinity", "100.1", "1d", "0x1p3", "\"\"", "[1]",
      "fast"})
  void aLimitIsANumberThatLimits(String value) {
    assertEquals(List.of("8:29: 'max_linear' must be a number from 0 to 100 in m/s, not "
        + (value.startsWith("[") ? "a list" : "'" + value.replace("\"", "") + "'")),
        messages(ROBOTS.formatted("max_linear: " + value)));
  }

  @Test
  void withoutALimitThereIsNone() {
    assertEquals(Double.POSITIVE_INFINITY,
        read(ROBOTS.formatted("lease: true")).ruics().getFirst().safety("Natalie").limits().linear());
  }

  @Test
  void aStopThatWouldCallNobodyIsAnError() {
    assertEquals(
        List.of("8:40: there is no robot interface 'base', so the stop of 'Natalie' would not call it; valid are ros"),
        messages(ROBOTS.formatted("stop_call: {interface: base, service: /stop}")));
    assertEquals(List.of(
        "8:40: the robot interface 'arm' does not speak to 'Natalie', so the stop of 'Natalie' would not call it; valid are ros"),
        messages(ROBOTS.formatted("stop_call: {interface: arm, service: /stop}")));
    assertEquals(List.of(
        "8:51: robot interfaces of the type 'ros' have no port 'servces' that calls services, so the stop would not reach "
            + "the robot; did you mean 'services'?"),
        messages(ROBOTS.formatted("stop_call: {interface: ros, port: servces, service: /stop}")));
    assertEquals(List.of("8:54: 'service' must be the name of a service, such as /stop, not '/stop now'"),
        messages(ROBOTS.formatted("stop_call: {interface: ros, service: /stop now}")));
    assertEquals(List.of(), messages(ROBOTS.formatted("stop_call: {interface: ros, service: /stop}")));
  }

  @Test
  void settingsOfAViewThatTheTypeBringsAreJudged() {
    String view = "ruics: {A: {type: base, rfics: {r: {type: ros, master: x}}, uics: {map: {%s}}}}";
    assertEquals(List.of(), messages(view.formatted("follow: true")));
    assertEquals(List.of("1:82: 'follow' must be true or false, not 'maybe'"),
        messages(view.formatted("follow: maybe")));
    assertEquals(List.of("1:74: unknown setting 'folow'; did you mean 'follow'?"),
        messages(view.formatted("folow: true")));
  }

  @Test
  void everyWeightOfALayoutIsChecked() {
    String layout = "ruics: {A: {type: base, rfics: {r: {type: ros, master: x}}, layout: %s}}";
    assertEquals(List.of("1:89: 'weight' must be a number from 0.01 to 1000, not '-1'"),
        messages(layout.formatted("{view: map, weight: -1}")));
    assertEquals(List.of("1:91: 'weight' must be a number from 0.01 to 1000, not 'NaN'"),
        messages(layout.formatted("{tabs: [map], weight: NaN}")));
    assertEquals(List.of("1:75: 'row' names no view; write at least one, for example [camera]"),
        messages(layout.formatted("{row: []}")));
  }

  @Test
  void textsHaveNoControlCharacters() {
    List<String> messages =
        messages("ruics: {\"Nata\\e[31mlie\": {type: base, rfics: {r: {type: ros, master: \"a\\nb\"}}}}");
    assertEquals(List.of(
        "1:9: 'Nata\\u001b[31mlie' has line breaks or other control characters; write it in one line, without them",
        "1:70: 'a\\u000ab' has line breaks or other control characters; write it in one line, without them"), messages);
  }

  @Test
  void whatIsQuotedInAMessageIsShort() {
    String longest = "x".repeat(3000);
    messages("ruics: {A: {type: base, rfics: {r: {type: ros, master: x}}, layout: " + longest + "}}")
        .forEach(m -> assertTrue(m.length() < 2100, m));
    assertEquals(List.of("1:56: a text of 5000 characters is too long; write at most 4096"),
        messages("ruics: {A: {type: base, rfics: {r: {type: ros, master: " + "x".repeat(5000) + "}}}}"));
  }

  @Test
  void whatIsNoTextIsRefusedWithoutShowingIt() throws IOException {
    assertEquals("is a folder; name a file", whole(folder));
    assertEquals("is no text", whole(written("binary", new byte[]{'r', 0, 1})));
    assertEquals("is no text in UTF-8", whole(written("latin", "Räder".getBytes(StandardCharsets.ISO_8859_1))));
    Path closed = written("closed", "ruics: {}".getBytes(StandardCharsets.UTF_8));
    if (closed.toFile().setReadable(false) && !Files.isReadable(closed)) { // root may read everything
      assertEquals("may not be read: permission denied", whole(closed));
    }
    assertEquals(List.of("1:1: this is no text: it has the control character U+001B, as character 2"),
        messages("a\u001bb"));
    assertEquals(List.of("1:1: 'ruics' is missing: names with a section each"), messages(""));
  }

  @Test
  void aDeviceOrAHugeFileIsNotRead() throws IOException {
    Path huge = folder.resolve("huge.yaml");
    try (RandomAccessFile file = new RandomAccessFile(huge.toFile(), "rw")) {
      file.setLength(100L << 20);
    }
    assertTimeoutPreemptively(QUICKLY, () -> {
      assertEquals("has 104857600 bytes; at most 1048576 are read", whole(huge));
      assertEquals("is a device or a pipe; name a file", whole(Path.of("/dev/zero")));
    });
  }

  @Test
  void bombsGoOffInASentence() {
    StringBuilder laughs = new StringBuilder("a: &a0 [lol, lol, lol, lol, lol, lol, lol, lol, lol]\n");
    for (int i = 1; i < 30; i++) {
      laughs.append("b%d: &a%d [%s]\n".formatted(i, i, String.join(", ", Collections.nCopies(9, "*a" + (i - 1)))));
    }
    bomb(laughs.toString());
    bomb("a: &a [*a]\n");
    bomb("a: &a {b: *a}\n");
    bomb("[".repeat(100_000));
    bomb("ruics: {\"${robot}\": {for: [" + "r1..r1000, ".repeat(90_000) + "r1]}}");
    bomb("ruics: {\"${robot}\": {for: r1..r1000, a: {for: r1..r1000, b: {for: r1..r1000, c: d}}}}");
    bomb("t: &t \"" + "${robot}".repeat(500) + "\"\nruics: {\"${robot}\": {for: r1..r1000, a: [" + "*t, ".repeat(90)
        + "*t]}}");
    bomb("ruics: {A: {uics: {" + keys(40_000) + "}, rfics: {" + keys(40_000) + "}}}");
    bomb("ruics: {A: {type: base, safety: {" + keys(90_000) + "}}}");
    bomb(keys(90_000).replace(',', '\n'));
    bomb("\"" + "\\e".repeat(400_000) + "\"");
    bomb("ruics: {A: {type: " + "a".repeat(1_000_000) + "}}");
  }

  private static String keys(int count) {
    StringBuilder keys = new StringBuilder();
    for (int i = 0; i < count; i++) {
      keys.append('k').append(i).append(": {},");
    }
    return keys.toString();
  }

  private void bomb(String text) {
    String start = text.substring(0, Math.min(60, text.length()));
    ConfigResult result = assertTimeoutPreemptively(QUICKLY, () -> read(text), start);
    assertFalse(result.problems().isEmpty(), start);
    assertTrue(result.problems().size() <= 1001, start + " has " + result.problems().size() + " problems");
    result.problems()
        .forEach(p -> assertTrue(p.message().length() < 2100 && Printable.isPlain(p.message()), p.message()));
  }

  private Path written(String name, byte[] content) throws IOException {
    return Files.write(folder.resolve(name), content);
  }

  private String whole(Path file) {
    Problem problem = source().read(file, new FakeTypes()).problems().getFirst();
    assertEquals(0, problem.line());
    assertTrue(problem.message().startsWith("the file "), problem.message());
    return problem.message().substring("the file ".length());
  }

  private static YamlConfigSource source() {
    return new YamlConfigSource(Map.of());
  }

  private static ConfigResult read(String text) {
    return source().read(Path.of("test.yaml"), text, new FakeTypes());
  }

  private static List<String> messages(String text) {
    return read(text).problems().stream().map(p -> p.line() + ":" + p.column() + ": " + p.message()).toList();
  }
}
