package org.robotui.headless.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.PrintStream;
import java.net.HttpURLConnection;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.Test;
import org.robotui.api.bridge.BridgeConfig;
import org.robotui.api.bridge.BridgeEnd;
import org.robotui.api.bridge.BridgeStatus;
import org.robotui.api.bridge.BridgeStatus.Counts;
import org.robotui.api.bridge.BridgeStatus.State;
import org.robotui.api.bridge.BridgeWords;
import org.robotui.api.bridge.Bridges;
import org.robotui.api.port.SourceId;
import org.robotui.testkit.FakeSettings;
import org.robotui.testkit.host.FakeHost;

class BridgeRunTest {
  private static final BridgeEnd FROM = new BridgeEnd("Natalie", new SourceId("base", "scan"));
  private static final BridgeEnd TO = new BridgeEnd("Keira", new SourceId("base", "far/\"scan\""));
  private static final BridgeStatus CARRYING = new BridgeStatus("scan", FROM, TO, State.CARRYING, "carrying",
      new Counts(12, 10, 1, 0, 1), 9.96, 0.00042, Optional.empty());
  private static final BridgeStatus WAITING = new BridgeStatus("drive", FROM, TO, State.WAITING, "nothing came yet",
      Counts.NONE, 0, Double.NaN, Optional.of("Anna"));

  private final ByteArrayOutputStream out = new ByteArrayOutputStream();
  private final ByteArrayOutputStream err = new ByteArrayOutputStream();
  private final CountDownLatch stop = new CountDownLatch(1);

  /** Notes down whether it runs. */
  private static final class Noted implements Bridges {
    private String noted = "";

    @Override
    public void start() {
      noted += "start ";
    }

    @Override
    public void stop() {
      noted += "stop";
    }

    @Override
    public List<BridgeStatus> statuses() {
      return List.of(CARRYING, WAITING);
    }
  }

  private Exit run(FakeHost host, Bridges bridges, String... words) throws Exception {
    return new BridgeRun(host, bridges, new PrintStream(out, true, StandardCharsets.UTF_8),
        new PrintStream(err, true, StandardCharsets.UTF_8), stop).run(BridgeArguments.parse(List.of(words)));
  }

  private static FakeHost bridging() {
    return new FakeHost().bridging(
        new BridgeConfig(Path.of("a.yaml"), 1, "scan", FROM, TO, new FakeSettings(BridgeWords.SCHEMA).current()));
  }

  @Test
  void aConfigurationWithoutBridgesIsToldAndNothingBegins() throws Exception {
    Noted bridges = new Noted();
    assertEquals(Exit.BRIDGE, run(new FakeHost(), bridges, "-bridge"));
    assertTrue(err.toString(StandardCharsets.UTF_8).contains("have no bridge that could run"));
    assertEquals("", bridges.noted);
  }

  @Test
  void bridgesRunUntilTheTimeIsOverAndEndInOrder() throws Exception {
    Noted bridges = new Noted();
    assertEquals(Exit.FINE, run(bridging(), bridges, "-bridge", "-json", "-for", "0.01"));
    assertEquals("start stop", bridges.noted);
    assertTrue(out.toString(StandardCharsets.UTF_8).startsWith("{\"bridge\":\"scan\",\"from\":\"Natalie.base.scan\""));
  }

  @Test
  void lineSaysRateLagCountsAndWhy() {
    assertEquals("scan         Natalie.base.scan -> Keira.base.far/\"scan\"  10.0 Hz, lag 0.4 ms, 10 passed, 1 thinned,"
        + " 0 dropped, 1 refused  carrying", BridgeRun.text(CARRYING));
    assertTrue(
        BridgeRun.text(WAITING).endsWith("lag -, 0 passed, 0 thinned, 0 dropped, 0 refused  waiting: nothing came"
            + " yet (control: Anna)"),
        BridgeRun.text(WAITING));
    assertTrue(BridgeRun.json(WAITING).contains("\"lag_s\":null"), BridgeRun.json(WAITING));
  }

  @Test
  void numbersAreTextForPrometheus() {
    String text = BridgeMetrics.text(List.of(CARRYING, WAITING));
    String labels = "{bridge=\"scan\",from=\"Natalie.base.scan\",to=\"Keira.base.far/\\\"scan\\\"\"";
    assertTrue(
        text.contains("# TYPE robotui_bridge_passed_total counter\nrobotui_bridge_passed_total" + labels + "} 10\n"),
        text);
    assertTrue(text.contains("robotui_bridge_state" + labels + ",state=\"carrying\"} 1\n"), text);
    assertTrue(text.contains("robotui_bridge_state" + labels + ",state=\"wrong\"} 0\n"), text);
    assertTrue(
        text.lines().anyMatch(l -> l.startsWith("robotui_bridge_lag_seconds{bridge=\"drive\"") && l.endsWith(" NaN")));
    text.lines().filter(l -> !l.startsWith("#"))
        .forEach(l -> assertTrue(l.matches("[a-z_]+\\{([a-z]+=\"([^\"\\\\]|\\\\.)*\",?)+} (NaN|[0-9.E-]+)"), l));
  }

  @Test
  void numbersAreGivenOnThisMachineAlone() throws IOException {
    try (MetricsDoor door = MetricsDoor.open(0, () -> "numbers\n")) {
      HttpURLConnection asked = (HttpURLConnection) URI.create(door.address()).toURL().openConnection();
      try (InputStream answer = asked.getInputStream()) {
        assertEquals("numbers\n", new String(answer.readAllBytes(), StandardCharsets.UTF_8));
      }
      assertTrue(asked.getContentType().startsWith("text/plain; version=0.0.4"));
      HttpURLConnection other =
          (HttpURLConnection) URI.create(door.address().replace("/metrics", "/")).toURL().openConnection();
      assertEquals(404, other.getResponseCode());
      assertTrue(InetAddress.getByName(URI.create(door.address()).getHost()).isLoopbackAddress());
    }
  }

  @Test
  void aPortThatIsTakenIsToldWithWhatHelps() throws Exception {
    try (ServerSocket taken = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      Noted bridges = new Noted();
      assertEquals(Exit.BRIDGE,
          run(bridging(), bridges, "-bridge", "-metrics", Integer.toString(taken.getLocalPort())));
      assertTrue(err.toString(StandardCharsets.UTF_8).contains("give another port, or 0 for any"));
      assertEquals("start stop", bridges.noted);
    }
  }

  @Test
  void argumentsAreChecked() throws Exception {
    assertEquals(OptionalInt.of(9464), BridgeArguments.parse(List.of("-bridge", "-metrics", "9464")).metricsPort());
    assertEquals(OptionalInt.empty(), BridgeArguments.parse(List.of("-bridge", "-json")).metricsPort());
    for (String wrong : List.of("65536", "-1", "many", "")) {
      assertThrows(Arguments.Wrong.class, () -> BridgeArguments.parse(List.of("-bridge", "-metrics", wrong)), wrong);
    }
  }
}
