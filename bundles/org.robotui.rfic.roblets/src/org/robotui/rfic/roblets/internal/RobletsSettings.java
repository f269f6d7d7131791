package org.robotui.rfic.roblets.internal;

import java.util.Map;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.Settings;
import org.robotui.api.config.TextRule;
import org.robotui.api.config.ValueType;
import org.robotui.api.session.BaseFrames;
import org.robotui.net.socket.HostPort;
import org.robotui.roblets.wire.BodyDatagram;

/**
 * How a brain is reached, and how frames are called.
 *
 * @param brain where it listens
 * @param frames how the frames are called that carry all others
 */
public record RobletsSettings(HostPort brain, BaseFrames frames) {
  private static final int LAST_PORT = 0xffff;

  static final Schema SCHEMA = Schema.of(
      Setting.optional("host", new ValueType.Text(TextRule.HOST),
          "name or address of the machine with the brain; else that in ROBLETS_BRAIN, else localhost"),
      Setting.optional("port", new ValueType.Int(1, LAST_PORT),
          "UDP port of the brain; else that in ROBLETS_BRAIN, else " + BodyDatagram.BRAIN_PORT),
      BaseFrames.BASE, BaseFrames.ODOM, BaseFrames.MAP);

  static RobletsSettings of(Settings settings, Map<String, String> variables) {
    HostPort told = HostPort.ofVariable(BodyDatagram.BRAIN_VARIABLE,
        variables.getOrDefault(BodyDatagram.BRAIN_VARIABLE, "").strip(), BodyDatagram.BRAIN_PORT);
    HostPort brain = new HostPort(settings.has("host") ? settings.text("host") : told.host(),
        settings.has("port") ? (int) settings.integer("port") : told.port());
    return new RobletsSettings(brain, BaseFrames.of(settings));
  }

  /** The brain as people write it. */
  public String peer() {
    return brain.toString();
  }
}
