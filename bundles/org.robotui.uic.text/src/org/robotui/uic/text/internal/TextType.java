package org.robotui.uic.text.internal;

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
import org.robotui.data.Data;

/** Shows in a terminal how a robot is doing. */
@Component(service = UicType.class)
public final class TextType implements UicType {
  static final String UNUSED = "unused";
  static final String TYPES = "types";

  /** Everything that the robot sends: a port that nobody takes from has neither rate nor value. */
  static final StreamPort<Data> ALL =
      new StreamPort<>("all", Data.class, Arity.MANY,
          "Everything that the robot sends; connect it to none to ask for nothing.");

  private static final double RATE_HZ = 2;

  private static final Schema SCHEMA = Schema.of(
      Setting.of(UNUSED, new ValueType.Flag(), true, "Whether ports are listed that no view uses."),
      Setting.of(TYPES, new ValueType.Flag(), true, "Whether the types of ports are listed, where there is room."));

  private static final Descriptor DESCRIPTOR = new Descriptor("text", "Text",
      "Shows link, authority and every port of a robot in a terminal.",
      SCHEMA, List.of(ALL));

  @Override
  public Descriptor descriptor() {
    return DESCRIPTOR;
  }

  @Override
  public Surface surface() {
    return Surface.TEXT;
  }

  @Override
  public double rateHz() {
    return RATE_HZ;
  }

  @Override
  public Uic create(UicContext context, Settings settings) {
    return new TextView(context);
  }
}
