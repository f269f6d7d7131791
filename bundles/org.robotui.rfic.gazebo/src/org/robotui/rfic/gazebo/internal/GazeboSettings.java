package org.robotui.rfic.gazebo.internal;

import java.net.InetAddress;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ThreadFactory;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.Settings;
import org.robotui.api.config.TextRule;
import org.robotui.api.config.ValueType;
import org.robotui.gazebo.GazeboOptions;
import org.robotui.gazebo.QualifiedName;
import org.robotui.message.topic.TopicSettings;

/**
 * How a simulator is found, and what of its robots is offered.
 *
 * @param variables those of the environment, for what is not set
 * @param named the partition; empty for that of the environment
 * @param address of this machine in the network of the simulator; empty for that of the environment
 * @param topics which topics become ports
 */
public record GazeboSettings(Map<String, String> variables, String named, String address, TopicSettings topics) {
  static final Schema SCHEMA = schema();

  private static Schema schema() {
    List<Setting> all = new ArrayList<>();
    all.add(Setting.of("partition",
        new ValueType.Text(TextRule.readBy("a partition, such as robots", QualifiedName::checkPartition)), "",
        "partition of the simulator; empty for GZ_PARTITION or IGN_PARTITION, else the usual one of this user"));
    all.add(Setting.of("address",
        new ValueType.Text(TextRule.readBy("an address of this machine, such as 192.168.0.2",
            GazeboSettings::checkAddress)),
        "", "address of this machine in the network of the simulator; empty for GZ_IP or IGN_IP, "
            + "else only simulators of this machine are met"));
    all.addAll(TopicSettings.settings(QualifiedName::check));
    return new Schema(all);
  }

  private static void checkAddress(String text) {
    if (!text.isEmpty() && GazeboOptions.numeric(text).isEmpty()) {
      throw new IllegalArgumentException("an address has four numbers from 0 to 255 with points between them");
    }
  }

  static GazeboSettings of(Settings settings, Map<String, String> variables) {
    return new GazeboSettings(Map.copyOf(variables), settings.text("partition"), settings.text("address"),
        TopicSettings.of(settings));
  }

  /**
   * The partition.
   *
   * @return also where it is not named here
   */
  public String partition() {
    return options(Thread::new).partition();
  }

  /**
   * Who is met, for users.
   *
   * @return such as {@code Gazebo in partition robots}
   */
  public String peer() {
    return "Gazebo in partition " + partition();
  }

  /**
   * How a node begins.
   *
   * @param threads makes its threads
   * @return the options
   */
  public GazeboOptions options(ThreadFactory threads) {
    GazeboOptions given = GazeboOptions.of(variables, threads);
    InetAddress where = GazeboOptions.numeric(address).orElse(given.address());
    return (named.isEmpty() ? given : given.inPartition(named)).at(where);
  }
}
