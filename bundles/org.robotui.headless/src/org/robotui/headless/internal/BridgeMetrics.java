package org.robotui.headless.internal;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.function.Function;
import org.robotui.api.bridge.BridgeStatus;
import org.robotui.api.bridge.BridgeStatus.State;

/** Numbers of bridges as text that Prometheus reads (exposition format 0.0.4). */
final class BridgeMetrics {
  private BridgeMetrics() {}

  static String text(List<BridgeStatus> statuses) {
    StringBuilder text = new StringBuilder();
    counter(text, statuses, "received", "Values taken from the robot that says them.", s -> s.counts().received());
    counter(text, statuses, "passed", "Values handed on.", s -> s.counts().passed());
    counter(text, statuses, "thinned", "Values left out on purpose.", s -> s.counts().thinned());
    counter(text, statuses, "dropped", "Values lost to full queues.", s -> s.counts().dropped());
    counter(text, statuses, "refused", "Values that the other side did not take.", s -> s.counts().refused());
    family(text, "rate_hertz", "gauge", "Values that pass in a second.");
    statuses.forEach(s -> sample(text, "rate_hertz", labels(s), number(s.rateHz())));
    family(text, "lag_seconds", "gauge", "From being received until being handed on, typically.");
    statuses.forEach(s -> sample(text, "lag_seconds", labels(s), number(s.lagSeconds())));
    family(text, "state", "gauge", "1 for the state that the bridge is in.");
    statuses.forEach(s -> Arrays.stream(State.values()).forEach(state -> sample(text, "state",
        labels(s) + ",state=\"" + state.name().toLowerCase(Locale.ROOT) + "\"", s.state() == state ? "1" : "0")));
    return text.toString();
  }

  private static void counter(StringBuilder text, List<BridgeStatus> statuses, String what, String help,
      Function<BridgeStatus, Long> count) {
    String name = what + "_total";
    family(text, name, "counter", help);
    statuses.forEach(s -> sample(text, name, labels(s), count.apply(s).toString()));
  }

  private static void family(StringBuilder text, String name, String type, String help) {
    text.append("# HELP robotui_bridge_").append(name).append(' ').append(help).append('\n')
        .append("# TYPE robotui_bridge_").append(name).append(' ').append(type).append('\n');
  }

  private static void sample(StringBuilder text, String name, String labels, String value) {
    text.append("robotui_bridge_").append(name).append('{').append(labels).append("} ").append(value).append('\n');
  }

  private static String labels(BridgeStatus status) {
    return "bridge=" + quoted(status.name()) + ",from=" + quoted(status.from().toString()) + ",to="
        + quoted(status.to().toString());
  }

  private static String quoted(String text) {
    return '"' + text.replace("\\", "\\\\").replace("\"", "\\\"").replace("\n", "\\n") + '"';
  }

  private static String number(double value) {
    return Double.isNaN(value) ? "NaN" : Double.toString(value);
  }
}
