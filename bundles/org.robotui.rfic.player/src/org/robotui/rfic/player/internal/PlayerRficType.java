package org.robotui.rfic.player.internal;

import java.util.List;
import org.osgi.service.component.annotations.Component;
import org.robotui.api.Descriptor;
import org.robotui.api.Rfic;
import org.robotui.api.RficContext;
import org.robotui.api.RficType;
import org.robotui.api.config.Settings;
import org.robotui.guard.Guards;
import org.robotui.rfic.player.internal.call.PlayerPorts;

/** The type {@code player}: a client of a Player server. */
@Component(service = RficType.class)
public final class PlayerRficType implements RficType {
  /** Streams and commands are those that the server's devices have; only calling and browsing are always there. */
  private static final Descriptor DESCRIPTOR = new Descriptor("player", "Player",
      "Devices of a Player server, found by asking for its list of devices.",
      PlayerSettings.SCHEMA, List.of(PlayerPorts.SERVICES, PlayerPorts.GRAPH));

  private final Guards guards = new Guards();

  @Override
  public Descriptor descriptor() {
    return DESCRIPTOR;
  }

  @Override
  public Rfic create(RficContext context, Settings settings) {
    return PlayerSessions.rfic(context, PlayerSettings.of(settings, System.getenv()), guards);
  }
}
