package org.robotui.uic.console.internal;

import java.util.List;
import org.osgi.service.component.annotations.Activate;
import org.osgi.service.component.annotations.Component;
import org.osgi.service.component.annotations.Reference;
import org.robotui.api.Descriptor;
import org.robotui.api.Uic;
import org.robotui.api.UicContext;
import org.robotui.api.UicType;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.Settings;
import org.robotui.api.config.ValueType;
import org.robotui.api.script.Scripts;

/** Runs scripts a line at a time. It is there where scripts can be run. */
@Component(service = UicType.class)
public final class ConsoleType implements UicType {
  static final String HISTORY = "history";

  private static final double RATE_HZ = 15;
  private static final Schema SCHEMA = Schema.of(Setting.of(HISTORY, new ValueType.ListOf(new ValueType.Text()),
      List.of(), "What was typed before, the oldest first; arrow up brings it back.").asState());
  private static final Descriptor DESCRIPTOR = new Descriptor("console", "Console",
      "Runs scripts a line at a time: reads what robots send, drives, opens views; completes names, keeps a history.",
      SCHEMA, List.of());

  private final Scripts scripts;

  /** Called by declarative services. */
  @Activate
  public ConsoleType(@Reference Scripts scripts) {
    this.scripts = scripts;
  }

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
    return new ConsoleUic(context, scripts);
  }
}
