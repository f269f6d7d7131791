package org.robotui.rfic.smartsoft.internal;

import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.Settings;
import org.robotui.api.config.TextRule;
import org.robotui.api.config.ValueType;
import org.robotui.api.session.BaseFrames;
import org.robotui.net.socket.HostPort;
import org.robotui.smartsoft.wire.SmartFraming;

/**
 * How a naming service is reached, how objects are described, and how frames are called.
 *
 * @param naming where it listens
 * @param frames how the frames are called that carry all others
 * @param objects a folder with descriptions of objects
 * @param guard whether a process of its own keeps the connections
 */
public record SmartSettings(HostPort naming, BaseFrames frames, Optional<Path> objects,
    boolean guard) {

  private static final String VARIABLE = "SMART_NS_ADDR";
  private static final int LAST_PORT = 0xffff;

  static final Schema SCHEMA = Schema.of(
      Setting.optional("host", new ValueType.Text(TextRule.HOST),
          "name or address of the naming service; else that in SMART_NS_ADDR, else localhost"),
      Setting.optional("port", new ValueType.Int(1, LAST_PORT),
          "port of the naming service; else that in SMART_NS_ADDR, else 20002"),
      Setting.optional("objects", new ValueType.WithPlace(new ValueType.Text(TextRule.ANY)),
          "folder with descriptions of further communication objects, such as DomainPTU.idl, relative to this file"),
      BaseFrames.BASE, BaseFrames.ODOM, BaseFrames.MAP,
      Setting.of("guard", new ValueType.Flag(), false,
          "keeps connections in a small process of its own, so that the robot never waits for a workbench that is stopped or killed"));

  static SmartSettings of(Settings settings, Map<String, String> variables) {
    HostPort told =
        HostPort.ofVariable(VARIABLE, variables.getOrDefault(VARIABLE, "").strip(), SmartFraming.NAMING_PORT);
    HostPort naming = new HostPort(settings.has("host") ? settings.text("host") : told.host(),
        settings.has("port") ? (int) settings.integer("port") : told.port());
    Optional<Path> objects = settings.has("objects")
        ? Optional.of(settings.placed("objects").resolve(settings.placed("objects").value().toString()))
        : Optional.empty();
    return new SmartSettings(naming, BaseFrames.of(settings), objects, settings.flag("guard"));
  }

  /**
   * The naming service as people write it.
   *
   * @return host and port
   */
  public String peer() {
    return naming.toString();
  }
}
