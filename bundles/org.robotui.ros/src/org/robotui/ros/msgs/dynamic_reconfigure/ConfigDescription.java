package org.robotui.ros.msgs.dynamic_reconfigure;

import java.util.List;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;

/**
 * Describes all parameters of a server ({@code dynamic_reconfigure/ConfigDescription}).
 *
 * @param groups the parameters, in groups
 * @param max    highest values
 * @param min    lowest values
 * @param dflt   values at the start
 */
public record ConfigDescription(List<Group> groups, Config max, Config min, Config dflt) {

  /** Between records and bytes. */
  public static final RecordCodec<ConfigDescription> CODEC =
      RecordCodec.of("dynamic_reconfigure/ConfigDescription", ConfigDescription::read, ConfigDescription::write);

  /** Keeps immutable copies of lists. */
  public ConfigDescription {
    groups = List.copyOf(groups);
  }

  private static ConfigDescription read(MessageReader in) throws MessageException {
    return new ConfigDescription(
        in.list("groups", Group.CODEC),
        in.nested("max", Config.CODEC),
        in.nested("min", Config.CODEC),
        in.nested("dflt", Config.CODEC));
  }

  private static void write(ConfigDescription m, MessageWriter out) {
    Group.CODEC.encodeAll(m.groups, out);
    Config.CODEC.encode(m.max, out);
    Config.CODEC.encode(m.min, out);
    Config.CODEC.encode(m.dflt, out);
  }
}
