package org.robotui.ros.msgs.dynamic_reconfigure;

import java.util.List;

import org.robotui.ros.message.MessageException;
import org.robotui.ros.message.MessageReader;
import org.robotui.ros.message.MessageWriter;
import org.robotui.ros.message.RecordCodec;

/**
 * Values of parameters ({@code dynamic_reconfigure/Config}).
 *
 * @param bools   truth values
 * @param ints    whole numbers
 * @param strs    texts
 * @param doubles numbers
 * @param groups  states of groups
 */
public record Config(List<BoolParameter> bools, List<IntParameter> ints, List<StrParameter> strs, List<DoubleParameter> doubles, List<GroupState> groups) {

  /** Between records and bytes. */
  public static final RecordCodec<Config> CODEC =
      RecordCodec.of("dynamic_reconfigure/Config", Config::read, Config::write);

  /** Keeps immutable copies of lists. */
  public Config {
    bools = List.copyOf(bools);
    ints = List.copyOf(ints);
    strs = List.copyOf(strs);
    doubles = List.copyOf(doubles);
    groups = List.copyOf(groups);
  }

  private static Config read(MessageReader in) throws MessageException {
    return new Config(
        in.list("bools", BoolParameter.CODEC),
        in.list("ints", IntParameter.CODEC),
        in.list("strs", StrParameter.CODEC),
        in.list("doubles", DoubleParameter.CODEC),
        in.list("groups", GroupState.CODEC));
  }

  private static void write(Config m, MessageWriter out) {
    BoolParameter.CODEC.encodeAll(m.bools, out);
    IntParameter.CODEC.encodeAll(m.ints, out);
    StrParameter.CODEC.encodeAll(m.strs, out);
    DoubleParameter.CODEC.encodeAll(m.doubles, out);
    GroupState.CODEC.encodeAll(m.groups, out);
  }
}
