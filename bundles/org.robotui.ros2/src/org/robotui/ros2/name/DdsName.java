package org.robotui.ros2.name;

import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.robotui.message.description.TypeName;

/**
 * What a topic of DDS is in ROS 2.
 *
 * @param role what it carries
 * @param name the whole name of the topic or service
 */
public record DdsName(Role role, Ros2Name name) {

  private static final Pattern TYPE =
      Pattern.compile("([A-Za-z]\\w*)::(msg|srv|action)::dds_::([A-Za-z]\\w*)_");

  /** What a topic of DDS carries. */
  public enum Role {
    /** Messages of a topic. */
    TOPIC("rt", ""),
    /** Requests to a service. */
    REQUEST("rq", "Request"),
    /** Replies of a service. */
    REPLY("rr", "Reply");

    private final String prefix;
    private final String end;

    Role(String prefix, String end) {
      this.prefix = prefix;
      this.end = end;
    }
  }

  /**
   * Reads the name of a topic of DDS.
   *
   * @param dds such as {@code rt/chatter}
   * @return empty if it is none of ROS 2
   */
  public static Optional<DdsName> parse(String dds) {
    for (Role role : Role.values()) {
      if (dds.startsWith(role.prefix + "/") && dds.endsWith(role.end)) {
        String name = dds.substring(role.prefix.length(), dds.length() - role.end.length());
        return Ros2Name.parse(name).filter(whole -> !whole.equals(Ros2Name.ROOT))
            .map(whole -> new DdsName(role, whole));
      }
    }
    return Optional.empty();
  }

  /**
   * The name in DDS.
   *
   * @return such as {@code rq/set_boolRequest}
   */
  public String text() {
    return role.prefix + name.text() + role.end;
  }

  /**
   * What DDS calls a type.
   *
   * @param type such as {@code std_srvs/srv/SetBool_Request}
   * @return such as {@code std_srvs::srv::dds_::SetBool_Request_}
   */
  public static String ofType(TypeName type) {
    return type.packageName() + "::" + type.kind().text() + "::dds_::" + type.name() + "_";
  }

  /**
   * Reads what DDS calls a type.
   *
   * @param dds such as {@code std_msgs::msg::dds_::String_}
   * @return empty if it is none of ROS 2
   */
  public static Optional<TypeName> type(String dds) {
    Matcher parts = TYPE.matcher(dds);
    return parts.matches() ? TypeName.parse(parts.group(1) + "/" + parts.group(2) + "/" + parts.group(3))
        : Optional.empty();
  }
}
