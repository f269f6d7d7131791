package org.robotui.rfic.ros2.internal;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.Settings;
import org.robotui.api.config.TextRule;
import org.robotui.api.config.ValueType;
import org.robotui.message.LocalDefinitions;
import org.robotui.message.topic.DescriptionTopics;
import org.robotui.message.topic.TopicSettings;
import org.robotui.ros2.Ros2Environment;
import org.robotui.ros2.Ros2Environment.Range;
import org.robotui.ros2.name.Ros2Name;
import org.robotui.rtps.ParticipantSettings;

/**
 * How a ROS 2 robot is found and what of it is offered.
 *
 * @param environment domain, how far it is looked for, machines that are asked
 * @param topics which topics become ports
 * @param definitions the definitions of types on this machine
 * @param packages folders in which packages are looked for that a description of the robot names
 * @param node first part of our node's name
 */
public record Ros2Settings(Ros2Environment environment, TopicSettings topics, LocalDefinitions definitions,
    List<String> packages, String node) {
  private static final TextRule NODE =
      TextRule.matching("the first part of a node's name, such as robotui", "[A-Za-z]\\w{0,100}");
  private static final TextRule FOLDER = TextRule.readBy("a folder, such as /opt/ros/kilted", Ros2Settings::folder);

  static final Schema SCHEMA = schema();

  private static Schema schema() {
    List<Setting> all = new ArrayList<>();
    all.add(Setting.optional("domain", new ValueType.Int(0, ParticipantSettings.MAX_DOMAIN),
        "the number of the domain; else ROS_DOMAIN_ID, else 0"));
    all.add(Setting.optional("range", new ValueType.Choice(List.of("localhost", "subnet", "off")),
        "how far the robot is looked for: on this machine, wherever multicast reaches, or nowhere; else "
            + "ROS_AUTOMATIC_DISCOVERY_RANGE and ROS_LOCALHOST_ONLY, else this machine"));
    all.add(Setting.optional("peers", oneOrMore(TextRule.HOST),
        "machines that are asked one by one; else ROS_STATIC_PEERS"));
    all.add(Setting.of("interfaces", oneOrMore(TextRule.ANY), List.of(),
        "names or addresses of the network interfaces that are used with the range subnet; none for all"));
    all.addAll(TopicSettings.settings(Ros2Settings::name));
    all.add(Setting.of("types", oneOrMore(FOLDER), List.of(),
        "folders with definitions of types (.msg, .srv, .action, .idl), beside AMENT_PREFIX_PATH"));
    all.add(Setting.of("node", new ValueType.Text(NODE), "robotui", "first part of the name of our node"));
    return new Schema(all);
  }

  private static ValueType oneOrMore(TextRule rule) {
    return new ValueType.AnyOf(List.of(new ValueType.Text(rule), new ValueType.ListOf(new ValueType.Text(rule))));
  }

  private static void name(String text) {
    String whole = text.startsWith("/") ? text : "/" + text;
    Ros2Name.of(whole.length() > 1 && whole.endsWith("/") ? whole.substring(0, whole.length() - 1) : whole);
  }

  private static void folder(String text) {
    try {
      Path.of(text);
    } catch (InvalidPathException e) {
      throw new IllegalArgumentException(e.getReason(), e);
    }
  }

  static Ros2Settings of(Settings settings, Map<String, String> variables) {
    return new Ros2Settings(environment(settings, variables), TopicSettings.of(settings),
        LocalDefinitions.ofRos2(texts(settings, "types").stream().map(Path::of).toList(), variables),
        packages(settings, variables), settings.text("node"));
  }

  private static Ros2Environment environment(Settings settings, Map<String, String> variables) {
    Ros2Environment said = Ros2Environment.of(variables, List.of());
    int domain = settings.has("domain") ? (int) settings.integer("domain") : said.domain();
    Range range = settings.has("range") ? Range.valueOf(settings.text("range").toUpperCase(Locale.ROOT)) : said.range();
    List<String> peers = settings.has("peers") ? texts(settings, "peers") : said.staticPeers();
    return Ros2Environment.local(domain).within(range, peers, texts(settings, "interfaces"));
  }

  private static List<String> packages(Settings settings, Map<String, String> variables) {
    List<String> folders = new ArrayList<>(texts(settings, "types"));
    folders.addAll(DescriptionTopics.packages(variables));
    return folders;
  }

  private static List<String> texts(Settings settings, String name) {
    return settings.values().get(name) instanceof List<?> list ? list.stream().map(Object::toString).toList()
        : List.of(settings.text(name));
  }

  /**
   * To whom it connects, for users.
   *
   * @return such as {@code ROS 2, domain 0 on this machine}
   */
  public String peer() {
    String where = switch (environment.range()) {
      case OFF -> "nobody";
      case LOCALHOST -> "this machine";
      case SUBNET -> "this network";
    };
    List<String> all = new ArrayList<>(List.of(where));
    all.addAll(environment.range() == Range.OFF ? List.of() : environment.staticPeers());
    return "ROS 2, domain " + environment.domain() + " on " + String.join(", ", all);
  }
}
