package org.robotui.uic.body.internal;

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
import org.robotui.data.status.BodyState;
import java.util.List;

/** Shows the state of a whole robot as one tree. */
@Component(service = UicType.class)
public final class BodyType implements UicType {
  static final String STALE_AFTER = "stale_after";
  static final StreamPort<BodyState> BODY =
      new StreamPort<>("body", BodyState.class, Arity.MANY, "the state of the whole robot");

  private static final double RATE_HZ = 10;

  private static final Schema SCHEMA = Schema.of(Setting.of(STALE_AFTER, new ValueType.Num(0.1, 3600, "s"), 3.0,
      "After how long a message that did not come again is old."));

  private static final Descriptor DESCRIPTOR = new Descriptor("body", "Body",
      "The state of a whole robot as one tree: its parts, what each said last, how old that is, and what it said before.",
      SCHEMA, List.of(BODY));

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
    return new BodyUic(context);
  }
}
