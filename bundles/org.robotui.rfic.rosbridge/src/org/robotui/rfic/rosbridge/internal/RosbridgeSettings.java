package org.robotui.rfic.rosbridge.internal;

import java.net.URI;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.Settings;
import org.robotui.api.config.TextRule;
import org.robotui.api.config.ValueType;
import org.robotui.message.topic.TopicSettings;
import org.robotui.web.WebAddress;

/**
 * How a bridge is reached, and what of its robot is offered.
 *
 * @param url of the bridge
 * @param throttleMillis of a topic, a message is sent at most so often; 0 for all
 * @param compression how the bridge sends messages
 * @param topics which topics become ports
 */
public record RosbridgeSettings(URI url, int throttleMillis, String compression, TopicSettings topics) {
  private static final String ADDRESS = "ws://localhost:9090";
  private static final int MOST_MILLIS = 10_000;
  private static final TextRule NAME = TextRule.matching("a name of ROS", "[~/A-Za-z][\\w/~]{0,254}");

  static final Schema SCHEMA = schema();

  private static Schema schema() {
    List<Setting> all = new ArrayList<>();
    all.add(Setting.of("url",
        new ValueType.Text(new TextRule("the address of a bridge, such as ws://robot:9090", WebAddress::fault)),
        ADDRESS, "address of the bridge; wss:// for one with TLS"));
    all.add(Setting.of("throttle", new ValueType.Int(0, MOST_MILLIS), 0L,
        "milliseconds between two messages of a topic, which the bridge keeps; 0 for all messages"));
    all.add(Setting.of("compression", new ValueType.Choice(List.of("cbor-raw", "cbor", "none")), "cbor-raw",
        "how the bridge sends messages: as the bytes of ROS, as CBOR, or as JSON"));
    all.addAll(TopicSettings.settings(RosbridgeSettings::checkName));
    return new Schema(all);
  }

  static RosbridgeSettings of(Settings settings) {
    return new RosbridgeSettings(URI.create(settings.text("url")), (int) settings.integer("throttle"),
        settings.text("compression"), TopicSettings.of(settings));
  }

  private static void checkName(String name) {
    Optional<String> fault = NAME.fault().apply(name);
    if (fault.isPresent()) {
      throw new IllegalArgumentException("a name of ROS has letters, digits, _ and /");
    }
  }
}
