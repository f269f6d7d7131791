package org.robotui.uic.log.internal;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import org.osgi.service.component.annotations.Component;
import org.robotui.api.Descriptor;
import org.robotui.api.Uic;
import org.robotui.api.UicContext;
import org.robotui.api.UicType;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.Settings;
import org.robotui.api.config.ValueType;
import org.robotui.api.port.Arity;
import org.robotui.api.port.StreamPort;
import org.robotui.api.show.Showing;
import org.robotui.data.status.LogEntry;
import org.robotui.data.status.Severity;

/** Shows what the nodes of a robot log. */
@Component(service = UicType.class)
public final class LogType implements UicType {
  static final String CAPACITY = "capacity";
  static final String MEMORY = "memory";
  static final String LEVELS = "levels";
  static final String ONLY_NODES = "only_nodes";
  static final String HIDDEN_NODES = "hidden_nodes";
  static final String SEARCH = "search";
  static final String EXPRESSION = "expression";
  static final String COLLAPSE = "collapse";
  static final String NODES = "nodes";

  static final StreamPort<LogEntry> LOG =
      new StreamPort<>("log", LogEntry.class, Arity.MANY, "the entries of the robot's log");

  private static final double RATE_HZ = 20;
  private static final List<String> WORDS = Arrays.stream(Severity.values()).map(LogType::word).toList();

  private static final Schema SCHEMA = Schema.of(
      Setting.of(CAPACITY, new ValueType.Int(1000, 1_000_000), 50_000L,
          "How many entries are kept; twice as many during a pause."),
      Setting.of(MEMORY, new ValueType.Int(1, 1024), 64L,
          "How much memory entries may take, MiB; the oldest go first."),
      Setting.of(LEVELS, new ValueType.ListOf(new ValueType.Choice(WORDS)), WORDS, "The levels that are shown."),
      Setting.of(ONLY_NODES, new ValueType.ListOf(new ValueType.Text()), List.of(),
          "Shows these nodes alone; empty shows all."),
      Setting.of(HIDDEN_NODES, new ValueType.ListOf(new ValueType.Text()), List.of(), "Nodes that are not shown."),
      Setting.of(SEARCH, new ValueType.Text(), "",
          "Shows entries alone that contain this in message, node or location."),
      Setting.of(EXPRESSION, new ValueType.Flag(), false, "Whether the search is a regular expression."),
      Setting.of(COLLAPSE, new ValueType.Flag(), false, "Whether equal entries in a row are one line with a count."),
      Setting.of(NODES, new ValueType.Flag(), false, "Whether the list of nodes is shown."));

  private static final Descriptor DESCRIPTOR = new Descriptor("log", "Log",
      "Shows what the nodes of a robot log, filtered by level, node and search.",
      SCHEMA, List.of(LOG));

  @Override
  public Descriptor descriptor() {
    return DESCRIPTOR;
  }

  @Override
  public Surface surface() {
    return Surface.WINDOW;
  }

  @Override
  public double rateHz() {
    return RATE_HZ;
  }

  @Override
  public List<Showing> showings() {
    return List.of(Showing.nodes("node", "Show in Log"));
  }

  @Override
  public Uic create(UicContext context, Settings settings) {
    return new LogUic(context);
  }

  static String word(Severity severity) {
    return severity.name().toLowerCase(Locale.ROOT);
  }
}
