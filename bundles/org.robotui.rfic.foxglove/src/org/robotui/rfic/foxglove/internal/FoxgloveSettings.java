package org.robotui.rfic.foxglove.internal;

import java.net.URI;
import java.util.ArrayList;
import java.util.List;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.Settings;
import org.robotui.api.config.TextRule;
import org.robotui.api.config.ValueType;
import org.robotui.message.topic.TopicSettings;
import org.robotui.web.WebAddress;

/**
 * How a server is reached, and what of its robot is offered.
 *
 * @param url of the server
 * @param topics which topics become ports
 */
public record FoxgloveSettings(URI url, TopicSettings topics) {
  private static final String ADDRESS = "ws://localhost:8765";
  private static final int LONGEST = 1000;

  static final Schema SCHEMA = schema();

  private static Schema schema() {
    List<Setting> all = new ArrayList<>();
    all.add(Setting.of("url",
        new ValueType.Text(new TextRule("the address of a server, such as ws://robot:8765", WebAddress::fault)),
        ADDRESS, "address of the server; wss:// for one with TLS"));
    all.addAll(TopicSettings.settings(FoxgloveSettings::checkName));
    return new Schema(all);
  }

  static FoxgloveSettings of(Settings settings) {
    return new FoxgloveSettings(URI.create(settings.text("url")), TopicSettings.of(settings));
  }

  /** Servers that are no bridge to ROS name their topics as they like. */
  private static void checkName(String name) {
    if (name.isBlank() || name.length() > LONGEST || name.chars().anyMatch(Character::isISOControl)) {
      throw new IllegalArgumentException("a name has from 1 to " + LONGEST + " characters, none of them for control");
    }
  }
}
