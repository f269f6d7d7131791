package org.robotui.rfic.ros.internal;

import java.net.URI;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Pattern;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.Settings;
import org.robotui.api.config.TextRule;
import org.robotui.api.config.ValueType;
import org.robotui.ros.GraphName;
import org.robotui.ros.RosEnvironment;

/**
 * How a ROS robot is reached and what of it is offered.
 *
 * @param environment master, own address, remappings
 * @param namespace names are relative to it, and only topics below it are offered; ends with a slash
 * @param include only topics of these names are offered
 * @param commands topics by ROS type that are offered for commands also while nobody subscribes to them
 * @param node first part of our node's name
 * @param tf whether transforms are listened to
 * @param guard whether a process of its own keeps the connections
 */
public record RosSettings(
    RosEnvironment environment,
    String namespace,
    List<Pattern> include,
    Map<String, List<String>> commands,
    String node,
    boolean tf,
    boolean guard) {
  private static final TextRule MASTER =
      new TextRule("the address of a master, such as http://robot:11311", RosSettings::noMaster);
  private static final TextRule NAMESPACE = TextRule.readBy("a namespace, such as /r1", GraphName::of);
  private static final TextRule NODE =
      TextRule.matching("the first part of a node's name, such as robotui", "[A-Za-z]\\w{0,254}");
  private static final ValueType NAMES =
      oneOrMore(TextRule.readBy("the name of a topic, such as cmd_vel or /r1/cmd_vel", GraphName::of));
  private static final ValueType PATTERNS = oneOrMore(TextRule.readBy(
      "the name of a topic, in which * stands for any part, such as scan or camera/*",
      text -> GraphName.of(text.replace('*', 'x'))));

  static final Schema SCHEMA = Schema.of(
      Setting.optional("master", new ValueType.Text(MASTER),
          "address of the master, for example http://robot:11311; else ROS_MASTER_URI"),
      Setting.optional("host", new ValueType.Text(TextRule.HOST),
          "address by which the robot reaches this machine; else ROS_HOSTNAME or ROS_IP"),
      Setting.of("namespace", new ValueType.Text(NAMESPACE), "/",
          "only topics below it, and port names relative to it"),
      Setting.of("topics", PATTERNS, List.of("*"), "which topics become ports; * stands for any part of a name"),
      Setting.of("velocity", NAMES, List.of(), "topics for velocity commands, also while nobody subscribes to them"),
      Setting.of("goal", NAMES, List.of(), "topics for navigation goals, also while nobody subscribes to them"),
      Setting.of("initial_pose", NAMES, List.of(), "topics for initial poses, also while nobody subscribes to them"),
      Setting.of("path", NAMES, List.of(), "topics to which waypoints are sent as a path"),
      Setting.of("poses", NAMES, List.of(), "topics to which waypoints are sent as an array of poses"),
      Setting.of("node", new ValueType.Text(NODE), "robotui", "first part of the name of our node"),
      Setting.of("tf", new ValueType.Flag(), true, "whether transforms are listened to"),
      Setting.of("guard", new ValueType.Flag(), false,
          "keeps connections in a small process of its own, so that the robot never waits for a workbench that is stopped or killed"));

  static RosSettings of(Settings settings, Map<String, String> variables) {
    List<String> arguments = new ArrayList<>();
    if (settings.has("master")) {
      arguments.add("__master:=" + settings.text("master"));
    }
    if (settings.has("host")) {
      arguments.add("__hostname:=" + settings.text("host"));
    }
    return new RosSettings(RosEnvironment.of(variables, arguments), namespace(settings.text("namespace")),
        texts(settings, "topics").stream().map(RosSettings::pattern).toList(),
        Map.of("geometry_msgs/Twist", texts(settings, "velocity"),
            "geometry_msgs/PoseStamped", texts(settings, "goal"),
            "geometry_msgs/PoseWithCovarianceStamped", texts(settings, "initial_pose"),
            "nav_msgs/Path", texts(settings, "path"),
            "geometry_msgs/PoseArray", texts(settings, "poses")),
        settings.text("node"), settings.flag("tf"), settings.flag("guard"));
  }

  /**
   * The address of the master.
   *
   * @return as configured or from the environment
   */
  public URI master() {
    return environment.masterUri();
  }

  /**
   * The name of the port of a topic.
   *
   * @param topic a global name
   * @return relative to the namespace
   */
  public String portName(String topic) {
    return topic.startsWith(namespace) ? topic.substring(namespace.length()) : topic.substring(1);
  }

  /**
   * The topic of a name in the configuration.
   *
   * @param name global or relative to the namespace
   * @return a global name
   */
  public String topic(String name) {
    return name.startsWith("/") ? name : namespace + name;
  }

  /**
   * Whether a topic shall be offered.
   *
   * @param topic a global name
   * @return true where it is below the namespace and included
   */
  public boolean offers(String topic) {
    String name = portName(topic);
    return topic.startsWith(namespace)
        && include.stream().anyMatch(p -> p.matcher(name).matches() || p.matcher(topic).matches());
  }

  private static Optional<String> noMaster(String text) {
    try {
      RosEnvironment.of(Map.of("ROS_MASTER_URI", text), List.of());
      return Optional.empty();
    } catch (IllegalArgumentException e) {
      return Optional.of("");
    }
  }

  private static ValueType oneOrMore(TextRule rule) {
    return new ValueType.AnyOf(List.of(new ValueType.Text(rule), new ValueType.ListOf(new ValueType.Text(rule))));
  }

  private static String namespace(String written) {
    String global = written.startsWith("/") ? written : "/" + written;
    return global.endsWith("/") ? global : global + "/";
  }

  private static Pattern pattern(String glob) {
    StringBuilder regex = new StringBuilder();
    for (String part : glob.split("\\*", -1)) {
      regex.append(regex.isEmpty() ? "" : ".*").append(Pattern.quote(part));
    }
    return Pattern.compile(regex.toString());
  }

  private static List<String> texts(Settings settings, String name) {
    return settings.values().get(name) instanceof List<?> list
        ? list.stream().map(Object::toString).toList()
        : List.of(settings.text(name));
  }
}
