package org.robotui.headless.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.api.host.ComponentStatus;
import org.robotui.api.host.PortStatus;
import org.robotui.api.host.RuicState;
import org.robotui.api.link.LinkState;
import org.robotui.api.port.PortKind;
import org.robotui.api.port.SourceId;
import org.robotui.testkit.host.FakeHost;
import org.robotui.testkit.host.FakeRuic;

class JsonLinesTest {
  private static final PortStatus SCAN = new PortStatus(new SourceId("base", "/scan"), PortKind.STREAM, "LaserScan",
      true, 12, 9.98, 0.0124, false, 1, "/scan from /laser: truncated", "360 ranges");
  private static final PortStatus MAP = new PortStatus(new SourceId("base", "/map"), PortKind.STREAM, "GridMap",
      true, 0, 0, Double.NaN, false, 0, "", "");

  @Test
  void printsALinePerPort() {
    FakeHost host = new FakeHost().add(new FakeRuic("Natalie").offering(SCAN, MAP).component(base()));
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();

    new JsonLines(host, new PrintStream(bytes, true, StandardCharsets.UTF_8)).show();

    assertEquals(List.of(
        "{\"ruic\":\"Natalie\",\"port\":\"base./scan\",\"type\":\"LaserScan\",\"rate_hz\":9.980,\"age_s\":0.012,"
            + "\"dropped\":1,\"link\":\"retry 4 s\",\"problem\":\"/scan from /laser: truncated\",\"value\":\"360 ranges\"}",
        "{\"ruic\":\"Natalie\",\"port\":\"base./map\",\"type\":\"GridMap\",\"rate_hz\":0.000,\"age_s\":null,"
            + "\"dropped\":0,\"link\":\"retry 4 s\",\"problem\":\"\",\"value\":\"\"}"),
        bytes.toString(StandardCharsets.UTF_8).lines().toList());
  }

  private static ComponentStatus base() {
    LinkState retry = new LinkState.Failed("no master", Duration.ofSeconds(4));
    return new ComponentStatus("base", "ros", ComponentStatus.Kind.RFIC, RuicState.INITIALIZED, "", Optional.of(retry));
  }
}
