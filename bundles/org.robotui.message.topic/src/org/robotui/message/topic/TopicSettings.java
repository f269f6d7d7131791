package org.robotui.message.topic;

import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;
import java.util.regex.Pattern;
import org.robotui.api.config.Setting;
import org.robotui.api.config.Settings;
import org.robotui.api.config.TextRule;
import org.robotui.api.config.ValueType;

/**
 * Which topics of a robot become ports, and by which names.
 *
 * @param namespace names are relative to it, and only topics below it are offered; ends with a slash
 * @param include only topics of these names are offered
 * @param commands topics by message type that are offered for commands also while nobody subscribes to them
 * @param tf whether transforms are listened to
 */
public record TopicSettings(
    String namespace,
    List<Pattern> include,
    Map<String, List<String>> commands,
    boolean tf) {
  /** All topics, by their whole names. */
  public static final TopicSettings ALL = new TopicSettings("/", List.of(Pattern.compile(".*")), Map.of(), true);
  private static final Set<String> LISTENING = Set.of("namespace", "topics", "tf");

  /** Takes copies. */
  public TopicSettings {
    include = List.copyOf(include);
    commands = Map.copyOf(commands);
  }

  /**
   * The settings that every robot with topics has.
   *
   * @param name throws IllegalArgumentException with a reason where a text is no name in the framework
   * @return the schema of each
   */
  public static List<Setting> settings(Consumer<String> name) {
    ValueType names = oneOrMore(TextRule.readBy("the name of a topic, such as cmd_vel or /r1/cmd_vel", name));
    ValueType patterns = oneOrMore(TextRule.readBy(
        "the name of a topic, in which * stands for any part, such as scan or camera/*",
        text -> name.accept(text.replace('*', 'x'))));
    return List.of(
        Setting.of("namespace", new ValueType.Text(TextRule.readBy("a namespace, such as /r1", name)), "/",
            "only topics below it, and port names relative to it"),
        Setting.of("topics", patterns, List.of("*"), "which topics become ports; * stands for any part of a name"),
        Setting.of("velocity", names, List.of(), "topics for velocity commands, also while nobody subscribes to them"),
        Setting.of("goal", names, List.of(), "topics for navigation goals, also while nobody subscribes to them"),
        Setting.of("initial_pose", names, List.of(), "topics for initial poses, also while nobody subscribes to them"),
        Setting.of("path", names, List.of(), "topics to which waypoints are sent as a path"),
        Setting.of("poses", names, List.of(), "topics to which waypoints are sent as an array of poses"),
        Setting.of("tf", new ValueType.Flag(), true, "whether transforms are listened to"));
  }

  /**
   * The settings of what can only be listened to.
   *
   * @param name throws IllegalArgumentException with a reason where a text is no name in the framework
   * @return the schema of each
   */
  public static List<Setting> listening(Consumer<String> name) {
    return settings(name).stream().filter(each -> LISTENING.contains(each.name())).toList();
  }

  /**
   * Reads what was configured where no commands are given.
   *
   * @param settings has values for {@link #listening}
   * @return the settings
   */
  public static TopicSettings ofListening(Settings settings) {
    return new TopicSettings(namespace(settings.text("namespace")),
        texts(settings, "topics").stream().map(TopicSettings::pattern).toList(), Map.of(), settings.flag("tf"));
  }

  /**
   * Reads what was configured.
   *
   * @param settings has values for {@link #settings}
   * @return the settings
   */
  public static TopicSettings of(Settings settings) {
    return new TopicSettings(namespace(settings.text("namespace")),
        texts(settings, "topics").stream().map(TopicSettings::pattern).toList(),
        Map.of("geometry_msgs/Twist", texts(settings, "velocity"),
            "geometry_msgs/PoseStamped", texts(settings, "goal"),
            "geometry_msgs/PoseWithCovarianceStamped", texts(settings, "initial_pose"),
            "nav_msgs/Path", texts(settings, "path"),
            "geometry_msgs/PoseArray", texts(settings, "poses")),
        settings.flag("tf"));
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
