package org.robotui.rfic.carmen.internal;

import java.util.Map;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.Settings;
import org.robotui.api.config.TextRule;
import org.robotui.api.config.ValueType;
import org.robotui.api.session.BaseFrames;
import org.robotui.carmen.wire.IpcFraming;
import org.robotui.net.socket.HostPort;

/**
 * How a central is reached, and how frames are called.
 *
 * @param central where it listens
 * @param frames how the frames are called that carry all others
 * @param truth whether the simulator's true pose places the robot on the map
 * @param guard whether a process of its own keeps the connections
 */
public record CarmenSettings(HostPort central, BaseFrames frames, boolean truth, boolean guard) {

  private static final String VARIABLE = "CENTRALHOST";
  private static final int LAST_PORT = 0xffff;

  static final Schema SCHEMA = Schema.of(
      Setting.optional("host", new ValueType.Text(TextRule.HOST),
          "name or address of the central; else that in CENTRALHOST, else localhost"),
      Setting.optional("port", new ValueType.Int(1, LAST_PORT),
          "port of the central; else that in CENTRALHOST, else 1381"),
      BaseFrames.BASE, BaseFrames.ODOM, BaseFrames.MAP,
      Setting.of("truth", new ValueType.Flag(), false,
          "places the robot on the map by the simulator's true pose, for simulations without localisation"),
      Setting.of("guard", new ValueType.Flag(), false,
          "keeps connections in a small process of its own, so that the robot never waits for a workbench that is stopped or killed"));

  static CarmenSettings of(Settings settings, Map<String, String> variables) {
    HostPort told =
        HostPort.ofVariable(VARIABLE, variables.getOrDefault(VARIABLE, "").strip(), IpcFraming.CENTRAL_PORT);
    HostPort central = new HostPort(settings.has("host") ? settings.text("host") : told.host(),
        settings.has("port") ? (int) settings.integer("port") : told.port());
    return new CarmenSettings(central, BaseFrames.of(settings), settings.flag("truth"), settings.flag("guard"));
  }

  /**
   * The central as people write it.
   *
   * @return host and port
   */
  public String peer() {
    return central.toString();
  }
}
