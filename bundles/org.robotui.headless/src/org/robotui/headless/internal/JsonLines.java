package org.robotui.headless.internal;

import java.io.PrintStream;
import java.util.List;
import org.robotui.api.host.ComponentStatus;
import org.robotui.api.host.Host;
import org.robotui.api.host.PortStatus;
import org.robotui.api.host.Ruic;
import org.robotui.api.host.RuicSnapshot;

/** Prints a JSON line per port. */
final class JsonLines implements Output {
  private static final long PERIOD_MILLIS = 1000;

  private final Host host;
  private final PrintStream out;

  JsonLines(Host host, PrintStream out) {
    this.host = host;
    this.out = out;
  }

  @Override
  public long periodMillis() {
    return PERIOD_MILLIS;
  }

  @Override
  public void show() {
    for (Ruic ruic : host.ruics()) {
      lines(ruic.snapshot()).forEach(out::println);
    }
    out.flush();
  }

  static List<String> lines(RuicSnapshot ruic) {
    return ruic.ports().stream().map(p -> line(ruic, p)).toList();
  }

  private static String line(RuicSnapshot ruic, PortStatus port) {
    return new Json()
        .put("ruic", ruic.name())
        .put("port", port.port().toString())
        .put("type", port.typeName())
        .put("rate_hz", port.rateHz(), 3)
        .put("age_s", port.ageSeconds(), 3)
        .put("dropped", port.dropped())
        .put("link", link(ruic, port.port().component()))
        .put("problem", port.problem())
        .put("value", port.value())
        .end();
  }

  private static String link(RuicSnapshot ruic, String component) {
    return ruic.components().stream()
        .filter(c -> c.id().equals(component))
        .map(ComponentStatus::link)
        .flatMap(java.util.Optional::stream)
        .findFirst()
        .orElse(ruic.link())
        .word();
  }
}
