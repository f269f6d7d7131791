package org.robotui.rfic.ros.internal;

import java.net.URI;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.Settings;
import org.robotui.api.config.TextRule;
import org.robotui.api.config.ValueType;
import org.robotui.message.topic.TopicSettings;
import org.robotui.ros.GraphName;
import org.robotui.ros.RosEnvironment;

/**
 * How a ROS robot is reached and what of it is offered.
 *
 * @param environment master, own address, remappings
 * @param topics which topics become ports
 * @param node first part of our node's name
 * @param guard whether a process of its own keeps the connections
 */
public record RosSettings(RosEnvironment environment, TopicSettings topics, String node, boolean guard) {
  private static final TextRule MASTER =
      new TextRule("the address of a master, such as http://robot:11311", RosSettings::noMaster);
  private static final TextRule NODE =
      TextRule.matching("the first part of a node's name, such as robotui", "[A-Za-z]\\w{0,254}");

  static final Schema SCHEMA = schema();

  private static Schema schema() {
    List<Setting> all = new ArrayList<>();
    all.add(Setting.optional("master", new ValueType.Text(MASTER),
        "address of the master, for example http://robot:11311; else ROS_MASTER_URI"));
    all.add(Setting.optional("host", new ValueType.Text(TextRule.HOST),
        "address by which the robot reaches this machine; else ROS_HOSTNAME or ROS_IP"));
    all.addAll(TopicSettings.settings(GraphName::of));
    all.add(Setting.of("node", new ValueType.Text(NODE), "robotui", "first part of the name of our node"));
    all.add(Setting.of("guard", new ValueType.Flag(), false,
        "keeps connections in a small process of its own, so that the robot never waits for a workbench that is stopped or killed"));
    return new Schema(all);
  }

  static RosSettings of(Settings settings, Map<String, String> variables) {
    List<String> arguments = new ArrayList<>();
    if (settings.has("master")) {
      arguments.add("__master:=" + settings.text("master"));
    }
    if (settings.has("host")) {
      arguments.add("__hostname:=" + settings.text("host"));
    }
    return new RosSettings(RosEnvironment.of(variables, arguments), TopicSettings.of(settings), settings.text("node"),
        settings.flag("guard"));
  }

  /**
   * The address of the master.
   *
   * @return as configured or from the environment
   */
  public URI master() {
    return environment.masterUri();
  }

  private static Optional<String> noMaster(String text) {
    try {
      RosEnvironment.of(Map.of("ROS_MASTER_URI", text), List.of());
      return Optional.empty();
    } catch (IllegalArgumentException e) {
      return Optional.of("");
    }
  }
}
