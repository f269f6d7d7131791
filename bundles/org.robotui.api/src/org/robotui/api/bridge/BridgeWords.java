package org.robotui.api.bridge;

import java.util.List;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.TextRule;
import org.robotui.api.config.ValueType;

/** What can be configured of a bridge, with the help of each word. */
public final class BridgeWords {
  /** Stamps stay what they are. */
  public static final String KEEP_STAMPS = "keep";
  /** Stamps are moved by the difference of the clocks of both robots, as it is estimated. */
  public static final String MOVE_STAMPS = "move";
  /** Stamps become the time at which the value was received, by the clock of the receiving robot. */
  public static final String NEW_STAMPS = "now";
  /** Only the newest value is worth sending. */
  public static final String NEWEST = "newest";
  /** Every value is worth sending, within the bounds of the queue. */
  public static final String ALL = "all";

  /** A bridge that carries values. */
  public static final String VALUES = "values";
  /** A bridge that offers a service of one robot to the programs of another one. */
  public static final String SERVICE = "service";
  /** A bridge that offers an action of one robot to the programs of another one. */
  public static final String ACTION = "action";

  /** A bridge that keeps a parameter of one robot equal to one of another robot. */
  public static final String PARAMETER = "parameter";

  private static final double LONGEST_SHIFT = 1e9;
  private static final TextRule END =
      TextRule.matching("a port of a robot, such as Natalie.scan or Natalie.base.scan", "[^.\\s][^.]*\\..*\\S");
  private static final ValueType PLACED_END = new ValueType.WithPlace(new ValueType.Text(END));
  private static final TextRule TYPE =
      TextRule.matching("the robot's name of a type, such as sensor_msgs/LaserScan", "\\S+");
  private static final TextRule EXPRESSION = TextRule.readBy(
      "the path of a field, a number, a text in single quotes, or a formula of paths and numbers, such as"
          + " 2 * (pose.x - 5)",
      FieldFormula::parse);
  private static final TextRule ID = TextRule.matching("the id of a transform, such as pose_goal", "[A-Za-z0-9_-]+");

  /** All words. */
  public static final Schema SCHEMA = Schema.of(
      Setting.required("from", PLACED_END, "the port that values come from: robot UI, robot interface where there are"
          + " several, and port"),
      Setting.required("to", PLACED_END, "where they go: a port for commands, or a topic or channel, which is offered"
          + " where nobody has it"),
      Setting.of("kind", new ValueType.Choice(List.of(VALUES, SERVICE, ACTION, PARAMETER)), VALUES,
          "what is carried: values, or calls of a service or goals of an action, which is offered to the programs of"
              + " 'from' and answered by that of 'to'; or a parameter, which is set at 'to' as it is at 'from'"),
      Setting.of("both", new ValueType.Flag(), false, "whether values go the other way as well"),
      Setting.optional("type", new ValueType.Text(TYPE),
          "the type of the messages that are sent; without it, what the topic carries, or what usually carries such values"),
      Setting.optional("transform", new ValueType.Text(ID), "the transform that values pass; those that are installed"
          + " are told where it is unknown"),
      Setting.optional("fields", new ValueType.MapOf(new ValueType.Text(EXPRESSION)),
          "what each field of the messages is made of"),
      Setting.optional("frames", new ValueType.MapOf(new ValueType.Text(TextRule.FRAME)),
          "frames that have other names on the other side"),
      Setting.optional("frame_prefix", new ValueType.Text(), "what is put before the names of all other frames"),
      Setting.of("stamps", new ValueType.Choice(List.of(KEEP_STAMPS, MOVE_STAMPS, NEW_STAMPS)), KEEP_STAMPS,
          "whether stamps stay, are moved by the difference of the clocks as it is estimated, or are made anew"),
      Setting.of("stamp_offset", new ValueType.Num(-LONGEST_SHIFT, LONGEST_SHIFT, "s"), 0.0, "what is added to stamps"),
      Setting.optional("when", new ValueType.Text(),
          "what values must be that pass: a condition as of alerts, such as battery charge < 0.2"),
      Setting.optional("rate", new ValueType.Num(0.01, 10_000, "Hz"), "how many values pass in a second at most"),
      Setting.optional("keep", new ValueType.Choice(List.of(NEWEST, ALL)),
          "which values wait where they cannot pass at once; without it, the newest of sensors and all others"),
      Setting.of("queue", new ValueType.Int(1, 10_000), 100L, "how many values wait at most, where all are kept"),
      Setting.optional("latched", new ValueType.Flag(),
          "whether those who come later get the last value; without it, as"
              + " the sender has it"),
      Setting.optional("lease", new ValueType.Flag(),
          "whether messages command the robot, and so need the lease and end with a stop; without it, all do but those of"
              + " sensors, maps and states, and so do calls"),
      Setting.optional("reply", new ValueType.MapOf(new ValueType.Text(EXPRESSION)),
          "what each field of the replies of a service, or of the results of an action, is made of; 'fields' does the"
              + " same for requests and goals"),
      Setting.optional("feedback", new ValueType.MapOf(new ValueType.Text(EXPRESSION)),
          "what each field of the feedback of an action is made of"),
      Setting.optional("timeout", new ValueType.Num(0.05, 86_400, "s"), "how long the answer of a service, or a goal of"
          + " an action, may take; without it, 10 s or an hour"),
      Setting.of("expiry", new ValueType.Num(0.05, 60, "s"), 0.5, "how long a command holds; it is not sent later"),
      Setting.optional("max_linear", new ValueType.Num(0, 100, "m/s"), "no motion that passes is faster"),
      Setting.optional("max_angular", new ValueType.Num(0, 100, "rad/s"), "no motion that passes turns faster"));

  private BridgeWords() {}
}
