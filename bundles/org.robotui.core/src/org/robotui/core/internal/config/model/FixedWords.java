package org.robotui.core.internal.config.model;

import java.util.List;
import org.robotui.api.config.Placed;
import org.robotui.api.config.Schema;
import org.robotui.api.config.Setting;
import org.robotui.api.config.TextRule;
import org.robotui.api.config.ValueType;

/** What a configuration can say beside the settings of the types: the same for all robot UIs. */
public final class FixedWords {
  /** What an id must be like. */
  public static final String ID = "[A-Za-z_][A-Za-z0-9_-]*";
  /** How a robot UI starts: at once, or when it is shown. */
  public static final List<String> STARTS = List.of("at_once", "when_shown");
  /** Of a robot UI. */
  public static final Schema RUIC = Schema.of(
      Setting.of("start", new ValueType.Choice(STARTS), STARTS.getFirst(),
          "whether it starts at once, or when it is shown for the first time"),
      Setting.optional("without", new ValueType.ListOf(new ValueType.Text()),
          "views of the type that are left out, parted by commas; the others take their room"));
  /** Of a robot interface. */
  public static final Schema INTERFACE = Schema.of(
      Setting.optional("robot", new ValueType.Text(),
          "the robot's name, without it that of the robot UI: frames, safety and the lease are by robot"),
      Setting.optional("title", new ValueType.Text(), "the name that users see"));
  /** Of a view. */
  public static final Schema VIEW =
      Schema.of(Setting.optional("title", new ValueType.Text(), "the title, in place of the view's usual one"));

  /** Faster than any robot: what is above is a mistake, and would be no limit. */
  private static final double FASTEST = 100;
  private static final ValueType SPEED = new ValueType.Num(0, FASTEST, "m/s");
  private static final ValueType TURN = new ValueType.Num(0, FASTEST, "rad/s");
  private static final TextRule INTERFACE_ID =
      TextRule.matching("the id of a robot interface, such as base", ID);
  private static final TextRule PORT = TextRule.matching("the name of a call port, such as services", "[^\\s.]+");
  private static final TextRule SERVICE = TextRule.matching("the name of a service, such as /stop", "\\S+");
  private static final Schema STOP_CALL = Schema.of(
      Setting.required("interface", placed(INTERFACE_ID), "id of the robot interface"),
      Setting.of("port", placed(PORT), Placed.nowhere("services"), "its call port"),
      Setting.required("service", new ValueType.Text(SERVICE), "the robot's name of the service"));
  /** Of how one robot is kept safe. */
  public static final Schema SAFETY = Schema.of(
      Setting.optional("max_linear", SPEED, "no motion command is faster; without it, there is no limit"),
      Setting.optional("max_angular", TURN, "no motion command turns faster; without it, there is no limit"),
      Setting.of("lease", new ValueType.Flag(), true, "whether commands need the lease"),
      Setting.optional("stop_call", new ValueType.Section(STOP_CALL), "what the robot is asked when it is stopped"));

  private FixedWords() {}

  private static ValueType placed(TextRule rule) {
    return new ValueType.WithPlace(new ValueType.Text(rule));
  }
}
