package org.robotui.uic.diagnostics.internal;

import java.util.List;
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
import org.robotui.data.status.Diagnostics;

/** Shows what the parts of a robot say of themselves, and said. */
@Component(service = UicType.class)
public final class DiagnosticsType implements UicType {
  static final String STALE_AFTER = "stale_after";
  static final String HISTORY = "history";
  static final String PROBLEMS = "only_problems";
  static final String SOURCE = "source";
  static final String OPENED = "opened";
  static final String CLOSED = "closed";

  static final StreamPort<Diagnostics> DIAGNOSTICS =
      new StreamPort<>("diagnostics", Diagnostics.class, Arity.MANY, "the reports of the robot's parts");

  private static final double RATE_HZ = 10;

  private static final Schema SCHEMA = Schema.of(
      Setting.of(STALE_AFTER, new ValueType.Num(0.5, 3600, "s"), 5.0,
          "After how long without a report a part is stale."),
      Setting.of(HISTORY, new ValueType.Int(1, 240), 10L, "How many minutes are looked back on."),
      Setting.of(PROBLEMS, new ValueType.Flag(), false, "Whether parts that are OK are left out."),
      Setting.of(SOURCE, new ValueType.Text(), "",
          "The source that is shown, for example base./diagnostics; * shows all, and without it the one that sorts the others' reports."),
      Setting.of(OPENED, new ValueType.ListOf(new ValueType.Text()), List.of(), "Groups that were opened."),
      Setting.of(CLOSED, new ValueType.ListOf(new ValueType.Text()), List.of(), "Groups that were closed."));

  private static final Descriptor DESCRIPTOR = new Descriptor("diagnostics", "Diagnostics",
      "Shows the diagnostics of a robot as a tree, with what is wrong and its history.",
      SCHEMA, List.of(DIAGNOSTICS));

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
  public Uic create(UicContext context, Settings settings) {
    return new DiagnosticsUic(context);
  }
}
