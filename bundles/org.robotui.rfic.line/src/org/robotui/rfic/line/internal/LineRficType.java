package org.robotui.rfic.line.internal;

import java.time.Duration;
import java.util.List;
import org.osgi.service.component.annotations.Component;
import org.robotui.api.Descriptor;
import org.robotui.api.Rfic;
import org.robotui.api.RficContext;
import org.robotui.api.RficType;
import org.robotui.api.config.Settings;
import org.robotui.api.session.SessionRfic;

/**
 * The type that configurations name: what it is called, what can be set, which ports it has, and how an instance is
 * made.
 */
@Component(service = RficType.class)
public final class LineRficType implements RficType {

  private static final Duration RETRY = Duration.ofSeconds(1);

  private static final Descriptor DESCRIPTOR = new Descriptor("line", "Line",
      "A robot that says where it is, and is driven, in lines of text over TCP.",
      LineSettings.SCHEMA, List.of(LineSession.POSE, LineSession.DRIVE));

  @Override
  public Descriptor descriptor() {
    return DESCRIPTOR;
  }

  @Override
  public Rfic create(RficContext context, Settings settings) {
    return rfic(context, LineSettings.of(settings));
  }

  /** Opens a session, and a second after it has ended the next one. */
  static Rfic rfic(RficContext context, LineSettings settings) {
    return new SessionRfic(context, settings.robot().toString(), RETRY, scope -> LineSession.open(context, settings));
  }
}
