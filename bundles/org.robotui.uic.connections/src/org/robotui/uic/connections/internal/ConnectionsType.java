package org.robotui.uic.connections.internal;

import java.util.List;
import org.osgi.service.component.annotations.Activate;
import org.osgi.service.component.annotations.Component;
import org.osgi.service.component.annotations.Reference;
import org.robotui.api.Descriptor;
import org.robotui.api.Uic;
import org.robotui.api.UicContext;
import org.robotui.api.UicType;
import org.robotui.api.bridge.Bridges;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.Settings;
import org.robotui.api.config.ValueType;

/** Shows every link, connection and bridge of all robots, and why it is as it is. */
@Component(service = UicType.class)
public final class ConnectionsType implements UicType {
  static final String PROBLEMS = "problems";
  static final String ROBOT = "robot";

  private static final double RATE_HZ = 4;

  private static final Schema SCHEMA = Schema.of(
      Setting.of(PROBLEMS, new ValueType.Flag(), false, "Whether only what is wrong, or must be decided, is listed."),
      Setting.of(ROBOT, new ValueType.Text(), "", "The name of the one robot UI that is listed; empty for all."));

  private static final Descriptor DESCRIPTOR = new Descriptor("connections", "Connections",
      "Shows every link of every robot, and why each port is connected, refused, pending or ambiguous.",
      SCHEMA, List.of());

  private final Bridges bridges;

  /** Called by declarative services. */
  @Activate
  public ConnectionsType(@Reference Bridges bridges) {
    this.bridges = bridges;
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
    return new ConnectionsUic(context, bridges::statuses);
  }
}
