package org.robotui.rfic.roboframe.internal;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.Settings;
import org.robotui.api.config.TextRule;
import org.robotui.api.config.ValueType;
import org.robotui.message.topic.TopicSettings;
import org.robotui.net.socket.HostPort;
import org.robotui.roboframe.wire.BrokerFraming;

/**
 * How an application is reached, and what of it is offered.
 *
 * @param application where it listens
 * @param topics which keys become ports
 */
public record RoboframeSettings(HostPort application, TopicSettings topics) {
  private static final String VARIABLE = "ROBOFRAME_ADDR";
  private static final int LAST_PORT = 0xffff;
  private static final int LONGEST = 100;

  static final Schema SCHEMA = schema();

  private static Schema schema() {
    List<Setting> all = new ArrayList<>();
    all.add(Setting.optional("host", new ValueType.Text(TextRule.HOST),
        "name or address of the application's machine; else that in ROBOFRAME_ADDR, else localhost"));
    all.add(Setting.optional("port", new ValueType.Int(1, LAST_PORT),
        "port of the application; else that in ROBOFRAME_ADDR, else 7420"));
    all.addAll(TopicSettings.settings(RoboframeSettings::checkName));
    return new Schema(all);
  }

  static RoboframeSettings of(Settings settings, Map<String, String> variables) {
    HostPort told =
        HostPort.ofVariable(VARIABLE, variables.getOrDefault(VARIABLE, "").strip(), BrokerFraming.PORT);
    HostPort application = new HostPort(settings.has("host") ? settings.text("host") : told.host(),
        settings.has("port") ? (int) settings.integer("port") : told.port());
    return new RoboframeSettings(application, TopicSettings.of(settings));
  }

  private static void checkName(String name) {
    if (!name.matches("[A-Za-z0-9_.\\-/]{1," + LONGEST + "}")) {
      throw new IllegalArgumentException("a key has 1 to " + LONGEST + " letters, digits and _ - . /");
    }
  }
}
